#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/deadline.h"
#include "cloud/point_cloud.h"

namespace plateau {

/// Position of a witness in the order of the tree, 0-based. Not the input index: see LandmarkLists::input_index.
using WitnessId = std::uint32_t;

/// A landmark entered a witness's list.
struct ListEntry {
    WitnessId witness = 0;
    std::uint32_t rank = 0;     ///< 0-based place in the list
    std::uint32_t dropped = 0;  ///< step of the landmark that left the list for it; 0: none did
};

/// The landmark list of every witness: its min(i, kappa) nearest landmarks by (distance, step), and the farthest
/// witness, kept under insertion of landmarks [GO 4.1, 4.2].
///
/// A static k-d tree over the witnesses whose nodes hold the largest first and the largest kappa-th distance below
/// them: the root names the farthest witness, and an insertion descends only where the box is nearer than the largest
/// kappa-th distance. About 5.5 n ln n list changes in all, each O(kappa), plus O(log n) nodes around them.
///
/// Ties: equal distances keep the earlier landmark in front; of equally far witnesses the lowest input index is
/// farthest.
class LandmarkLists {
public:
    /// `cloud` must outlive the lists; kappa >= 1. The tree is built by prepare().
    LandmarkLists(const PointCloud& cloud, std::uint32_t kappa);

    /// Builds the tree until the deadline passes, at least a node of it; true when it is complete. Cost in all: O(n log
    /// n).
    bool prepare(const Deadline& deadline);

    /// Inserts the landmark with this input index at the given step (1-based, consecutive). The entries name the
    /// witnesses whose list it entered, in tree order; valid until the next call.
    std::span<const ListEntry> insert(std::uint32_t input_index, std::uint32_t step);

    /// Input index of the witness farthest from its nearest landmark. After the first insertion.
    std::uint32_t farthest() const { return nodes_.front().farthest; }
    /// Its squared distance: epsilon squared.
    double farthest_distance_squared() const { return nodes_.front().largest_first; }

    /// Squared distance of a witness to the nearest other witness, landmark or not; infinity where there is none. Once
    /// prepared. Cost: O(log n) on the average.
    double nearest_other_squared(WitnessId witness) const;

    std::uint32_t kappa() const { return kappa_; }
    std::uint32_t size() const { return static_cast<std::uint32_t>(input_index_.size()); }
    std::uint32_t input_index(WitnessId witness) const { return input_index_[witness]; }
    /// Tree position of the point with this input index.
    WitnessId witness(std::uint32_t input_index) const { return witness_of_[input_index]; }
    /// Steps of the witness's nearest landmarks, nearest first; kappa of them, 0 beyond the landmarks so far.
    std::span<const std::uint32_t> list(WitnessId witness) const {
        return {steps_.data() + static_cast<std::size_t>(witness) * kappa_, kappa_};
    }
    /// Squared distances of the same landmarks; infinity beyond the landmarks so far.
    std::span<const double> distances_squared(WitnessId witness) const {
        return {distances_.data() + static_cast<std::size_t>(witness) * kappa_, kappa_};
    }

private:
    using Point = std::array<double, 3>;  // a plane point has z = 0, which adds nothing to a squared distance
    struct Node {
        Point low, high;
        double largest_first;
        double largest_last;  // of the kappa-th distances
        std::uint32_t farthest;
        std::uint32_t begin, end;  // witnesses below
        std::uint32_t right;       // index of the second child, 0 at a leaf; the first child follows its parent
    };

    bool visit(std::uint32_t node_index, const Point& p, std::uint32_t step);
    void visit_leaf(Node& node, const Point& p, std::uint32_t step);
    void search(std::uint32_t node_index, WitnessId witness, double& nearest) const;
    void split(std::uint32_t begin, std::uint32_t end, std::uint32_t axis);

    struct PendingRange {
        std::uint32_t begin, end;
        std::uint32_t parent;  // whose `right` this range becomes, or kNone
    };

    const PointCloud* cloud_;
    std::uint32_t kappa_;
    std::vector<std::uint32_t> input_index_;
    std::vector<WitnessId> witness_of_;
    std::vector<Point> points_;  // by witness
    std::vector<double> distances_;
    std::vector<std::uint32_t> steps_;
    std::vector<Node> nodes_;
    std::vector<PendingRange> pending_;
    std::vector<ListEntry> entries_;
};

}  // namespace plateau
