#pragma once

#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "base/deadline.h"
#include "cloud/point_cloud.h"

namespace plateau {

/// A static k-d tree over the points of a cloud of any dimension, with tight boxes. Points are reordered so that every
/// node holds a range of them.
///
/// Rounding is monotone, so the squared distance to a box never exceeds the rounded one to a point in it: what a search
/// prunes by it could not have counted.
class KdTree {
public:
    struct Node {
        std::uint32_t begin, end;  ///< positions below
        std::uint32_t right;       ///< index of the second child, 0 at a leaf; the first child follows its parent
    };
    struct Neighbor {
        double distance_squared;
        std::uint32_t input_index;
        bool operator<(const Neighbor& other) const {
            return distance_squared < other.distance_squared ||
                   (distance_squared == other.distance_squared && input_index < other.input_index);
        }
    };

    /// `cloud` must outlive prepare().
    explicit KdTree(const PointCloud& cloud);

    /// Builds until the deadline passes, at least a node; true when it is complete. Cost in all: O(n log n).
    bool prepare(const Deadline& deadline);

    std::uint32_t size() const { return static_cast<std::uint32_t>(input_index_.size()); }
    std::uint32_t dimension() const { return dimension_; }
    std::uint32_t node_count() const { return static_cast<std::uint32_t>(nodes_.size()); }
    const Node& node(std::uint32_t index) const { return nodes_[index]; }
    std::uint32_t input_index(std::uint32_t position) const { return input_index_[position]; }
    std::uint32_t position(std::uint32_t input_index) const { return position_[input_index]; }
    /// Once prepared.
    const double* point(std::uint32_t position) const {
        return points_.data() + static_cast<std::size_t>(position) * dimension_;
    }

    /// Calls use(axes) with the dimension as a number that is constant where it is small, so that loops unroll.
    template <class Use>
    void with_axes(const Use& use) const {
        switch (dimension_) {
            case 2:
                return use(std::integral_constant<std::size_t, 2>{});
            case 3:
                return use(std::integral_constant<std::size_t, 3>{});
            default:
                return use(static_cast<std::size_t>(dimension_));
        }
    }
    /// Both squared distances are summed in axis order, as distance_squared() does.
    template <class Axes>
    double box_distance_squared(std::uint32_t node, const double* p, Axes axes) const {
        const double* low = bounds_.data() + static_cast<std::size_t>(node) * 2 * axes;
        const double* high = low + axes;
        double sum = 0;
        for (std::size_t axis = 0; axis < axes; ++axis) {
            double gap = 0;
            if (p[axis] < low[axis]) gap = low[axis] - p[axis];
            if (p[axis] > high[axis]) gap = p[axis] - high[axis];
            sum += gap * gap;
        }
        return sum;
    }
    /// At least the squared distance to any point in the box of the node, rounding included.
    template <class Axes>
    double box_reach_squared(std::uint32_t node, const double* p, Axes axes) const {
        const double* low = bounds_.data() + static_cast<std::size_t>(node) * 2 * axes;
        const double* high = low + axes;
        double sum = 0;
        for (std::size_t axis = 0; axis < axes; ++axis) {
            const double below = p[axis] - low[axis];
            const double above = high[axis] - p[axis];
            const double reach = below > above ? below : above;
            sum += reach * reach;
        }
        return sum;
    }
    template <class Axes>
    double point_distance_squared(std::uint32_t position, const double* p, Axes axes) const {
        const double* q = points_.data() + static_cast<std::size_t>(position) * axes;
        double sum = 0;
        for (std::size_t axis = 0; axis < axes; ++axis) {
            const double along = q[axis] - p[axis];
            sum += along * along;
        }
        return sum;
    }

    /// Squared distance to the nearest other point; infinity where there is none. Cost: O(log n) on the average.
    double nearest_other_squared(std::uint32_t position) const;
    /// The same for the nearest other place: duplicates do not count.
    double nearest_distinct_squared(std::uint32_t position) const;
    /// The `count` nearest other points, fewer where there are not as many, into `nearest`, nearest first. Ties: the
    /// lowest input index. Cost: O(count + log n) on the average.
    void nearest_others(std::uint32_t position, std::uint32_t count, std::vector<Neighbor>& nearest) const;

private:
    struct PendingRange {
        std::uint32_t begin, end;
        std::uint32_t parent;  // whose `right` this range becomes, or kNone
    };

    void add_box(std::uint32_t begin, std::uint32_t end);
    std::uint32_t widest_axis(std::uint32_t node) const;
    void split(std::uint32_t begin, std::uint32_t end, std::uint32_t axis);
    template <class Axes, class Limit, class Use>
    void search(std::uint32_t node, std::uint32_t position, Axes axes, const Limit& limit, const Use& use) const;
    template <class Counts>
    double nearest_squared(std::uint32_t position, const Counts& counts) const;

    const PointCloud* cloud_;
    std::uint32_t dimension_;
    std::vector<std::uint32_t> input_index_, position_;
    std::vector<double> points_;  // by position
    std::vector<Node> nodes_;
    std::vector<double> bounds_;  // by node: the lowest coordinates, then the highest
    std::vector<PendingRange> pending_;
};

}  // namespace plateau
