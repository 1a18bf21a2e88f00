#include "cloud/kd_tree.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace plateau {

namespace {

constexpr std::uint32_t kLeafSize = 8;
constexpr std::uint32_t kNone = 0xFFFFFFFFu;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

KdTree::KdTree(const PointCloud& cloud) : cloud_(&cloud), dimension_(cloud.dimension) {
    input_index_.resize(cloud.size());
    std::iota(input_index_.begin(), input_index_.end(), 0u);
    pending_.push_back({0, cloud.size(), kNone});
}

bool KdTree::prepare(const Deadline& deadline) {
    for (bool first = true; !pending_.empty(); first = false) {
        if (!first && deadline.passed()) return false;
        const PendingRange range = pending_.back();
        pending_.pop_back();
        const std::uint32_t index = node_count();
        if (range.parent != kNone) nodes_[range.parent].right = index;
        nodes_.push_back({range.begin, range.end, 0});
        add_box(range.begin, range.end);
        if (range.end - range.begin <= kLeafSize) {
            // nth_element leaves its halves in a library's own order.
            std::sort(input_index_.begin() + range.begin, input_index_.begin() + range.end);
            continue;
        }
        split(range.begin, range.end, widest_axis(index));
        const std::uint32_t middle = range.begin + (range.end - range.begin) / 2;
        pending_.push_back({middle, range.end, index});
        pending_.push_back({range.begin, middle, kNone});
    }
    if (position_.empty()) {
        position_.resize(size());
        points_.reserve(cloud_->coordinates.size());
        for (std::uint32_t position = 0; position < size(); ++position) {
            position_[input_index_[position]] = position;
            const auto point = cloud_->point(input_index_[position]);
            points_.insert(points_.end(), point.begin(), point.end());
        }
    }
    return true;
}

void KdTree::add_box(std::uint32_t begin, std::uint32_t end) {
    const std::size_t at = bounds_.size();
    bounds_.resize(at + dimension_, kInfinity);
    bounds_.resize(at + 2 * std::size_t{dimension_}, -kInfinity);
    double* low = bounds_.data() + at;
    double* high = low + dimension_;
    for (std::uint32_t i = begin; i < end; ++i) {
        const auto point = cloud_->point(input_index_[i]);
        for (std::uint32_t axis = 0; axis < dimension_; ++axis) {
            low[axis] = std::min(low[axis], point[axis]);
            high[axis] = std::max(high[axis], point[axis]);
        }
    }
}

std::uint32_t KdTree::widest_axis(std::uint32_t node) const {
    const double* low = bounds_.data() + static_cast<std::size_t>(node) * 2 * dimension_;
    const double* high = low + dimension_;
    std::uint32_t widest = 0;
    for (std::uint32_t axis = 1; axis < dimension_; ++axis) {
        if (high[axis] - low[axis] > high[widest] - low[widest]) widest = axis;
    }
    return widest;
}

void KdTree::split(std::uint32_t begin, std::uint32_t end, std::uint32_t axis) {
    const auto first = input_index_.begin();
    std::nth_element(first + begin, first + begin + (end - begin) / 2, first + end,
                     [&](std::uint32_t a, std::uint32_t b) {
                         const double xa = cloud_->point(a)[axis];
                         const double xb = cloud_->point(b)[axis];
                         return xa < xb || (xa == xb && a < b);
                     });
}

// Calls use(other, squared distance) for every other point in boxes that are at most limit() away.
template <class Axes, class Limit, class Use>
void KdTree::search(std::uint32_t node, std::uint32_t position, Axes axes, const Limit& limit, const Use& use) const {
    const double* p = point(position);
    if (box_distance_squared(node, p, axes) > limit()) return;
    const Node& range = nodes_[node];
    if (range.right == 0) {
        for (std::uint32_t other = range.begin; other < range.end; ++other) {
            if (other != position) use(other, point_distance_squared(other, p, axes));
        }
        return;
    }
    // The half that holds the point first: it bounds the search in the other.
    const bool in_right = position >= nodes_[range.right].begin;
    search(in_right ? range.right : node + 1, position, axes, limit, use);
    search(in_right ? node + 1 : range.right, position, axes, limit, use);
}

template <class Counts>
double KdTree::nearest_squared(std::uint32_t position, const Counts& counts) const {
    double nearest = kInfinity;
    with_axes([&](auto axes) {
        search(
            0, position, axes, [&] { return nearest; },
            [&](std::uint32_t, double squared) {
                if (counts(squared)) nearest = std::min(nearest, squared);
            });
    });
    return nearest;
}

double KdTree::nearest_other_squared(std::uint32_t position) const {
    return nearest_squared(position, [](double) { return true; });
}

double KdTree::nearest_distinct_squared(std::uint32_t position) const {
    return nearest_squared(position, [](double squared) { return squared > 0; });
}

void KdTree::nearest_others(std::uint32_t position, std::uint32_t count, std::vector<Neighbor>& nearest) const {
    nearest.clear();
    const auto limit = [&] {
        if (nearest.size() < count) return kInfinity;
        return nearest.back().distance_squared;
    };
    with_axes([&](auto axes) {
        search(0, position, axes, limit, [&](std::uint32_t other, double squared) {
            const Neighbor candidate{squared, input_index_[other]};
            if (nearest.size() == count) {
                if (!(candidate < nearest.back())) return;
                nearest.pop_back();
            }
            nearest.insert(std::upper_bound(nearest.begin(), nearest.end(), candidate), candidate);
        });
    });
}

}  // namespace plateau
