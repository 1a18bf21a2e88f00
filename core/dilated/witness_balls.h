#pragma once

#include <cstdint>
#include <vector>

#include "base/slice.h"
#include "cloud/kd_tree.h"

namespace plateau {

/// For every node of the tree of witnesses one of them near its middle, and the radius of a ball around that one which
/// holds all witnesses below. What is known of the one bounds the others: the distance to a set, and the distance to
/// the j-th nearest landmark, change by no more than the way between two points.
class WitnessBalls {
public:
    /// `tree` prepared; must outlive this.
    explicit WitnessBalls(const KdTree& tree) : tree_(&tree) {}

    /// Looks at further nodes until the slice is used up; true when all are known. Cost of all: O(n log n).
    bool prepare(Slice& slice);

    const KdTree& tree() const { return *tree_; }
    /// Position of the witness in the middle.
    std::uint32_t middle(std::uint32_t node) const { return middle_[node]; }
    double radius(std::uint32_t node) const { return radius_[node]; }
    std::uint64_t memory() const {
        return middle_.capacity() * sizeof(std::uint32_t) + radius_.capacity() * sizeof(double);
    }

private:
    const KdTree* tree_;
    std::vector<std::uint32_t> middle_;
    std::vector<double> radius_;
};

}  // namespace plateau
