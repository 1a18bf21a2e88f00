#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/part_search.h"
#include "complex/simplex_table.h"
#include "homology/component_labels.h"

namespace plateau {

/// Connected components of the landmarks and the edges of one track: beta_0, after every step.
class SkeletonComponents {
public:
    explicit SkeletonComponents(int track) : track_(static_cast<std::size_t>(track)) {}

    /// Follows one insertion. `deaths` of this step. Cost: about the births and deaths, and the pieces that came off.
    void update(Step step, const SimplexTable& edges, std::span<const Death> deaths);

    std::uint32_t count() const { return labels_.count(); }
    std::uint64_t memory() const;

private:
    static constexpr std::uint32_t kEnd = 0xFFFFFFFFu;

    void separate(const SimplexTable& edges);

    std::size_t track_;
    ComponentLabels labels_;
    std::vector<ComponentLabels::Label> label_;  // by landmark: step - 1
    std::vector<Step> joined_at_;                // by landmark: last step that bore an edge to it
    std::vector<std::uint32_t> first_;           // by landmark: list of edge ends, 2 * edge + (0 older, 1 younger)
    std::vector<std::uint32_t> next_;            // by edge end
    std::vector<std::uint32_t> suspects_;
    PartSearch search_;
};

}  // namespace plateau
