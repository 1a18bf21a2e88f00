#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/dynamic_components.h"
#include "complex/simplex_table.h"

namespace plateau {

/// Connected components of the landmarks and the edges of one track: beta_0, after every step.
class SkeletonComponents {
public:
    explicit SkeletonComponents(int track) : track_(static_cast<std::size_t>(track)) {}

    /// Follows one insertion. `deaths` of this step.
    void update(Step step, const SimplexTable& edges, std::span<const Death> deaths);

    std::uint32_t count() const { return components_.count(); }
    std::uint64_t memory() const;

private:
    static constexpr std::uint32_t kEnd = 0xFFFFFFFFu;

    std::size_t track_;
    std::vector<std::uint32_t> first_;  // by landmark, that is step - 1: list of edge ends, 2 * edge + end
    std::vector<std::uint32_t> next_;   // by edge end
    DynamicComponents components_;
};

}  // namespace plateau
