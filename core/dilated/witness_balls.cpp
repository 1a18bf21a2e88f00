#include "dilated/witness_balls.h"

#include <algorithm>
#include <cmath>

namespace plateau {

bool WitnessBalls::prepare(Slice& slice) {
    constexpr double kAboveRounding = 1 + 0x1p-40;
    const KdTree& tree = *tree_;
    const std::size_t axes = tree.dimension();
    std::vector<double> low(axes), high(axes), center(axes);
    const auto distance_squared = [&](const double* a, const double* b) {
        double sum = 0;
        for (std::size_t axis = 0; axis < axes; ++axis) {
            const double along = a[axis] - b[axis];
            sum += along * along;
        }
        return sum;
    };
    while (middle_.size() < tree.node_count()) {
        if (slice.used_up()) return false;
        const KdTree::Node& node = tree.node(static_cast<std::uint32_t>(middle_.size()));
        slice.charge((node.end - node.begin) / 8);
        std::copy_n(tree.point(node.begin), axes, low.begin());
        high = low;
        for (std::uint32_t i = node.begin; i < node.end; ++i) {
            for (std::size_t axis = 0; axis < axes; ++axis) {
                low[axis] = std::min(low[axis], tree.point(i)[axis]);
                high[axis] = std::max(high[axis], tree.point(i)[axis]);
            }
        }
        for (std::size_t axis = 0; axis < axes; ++axis) center[axis] = low[axis] + (high[axis] - low[axis]) / 2;
        std::uint32_t middle = node.begin;
        for (std::uint32_t i = node.begin; i < node.end; ++i) {
            if (distance_squared(tree.point(i), center.data()) < distance_squared(tree.point(middle), center.data())) {
                middle = i;
            }
        }
        double farthest = 0;
        for (std::uint32_t i = node.begin; i < node.end; ++i) {
            farthest = std::max(farthest, distance_squared(tree.point(i), tree.point(middle)));
        }
        middle_.push_back(middle);
        radius_.push_back(std::sqrt(farthest) * kAboveRounding);
    }
    return true;
}

}  // namespace plateau
