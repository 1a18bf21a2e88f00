#include "homology/skeleton_components.h"

namespace plateau {

void SkeletonComponents::update(Step step, const SimplexTable& edges, std::span<const Death> deaths) {
    first_.push_back(kEnd);
    next_.resize(2 * static_cast<std::size_t>(edges.size()), kEnd);
    components_.resize(step);
    components_.add_node(step - 1);
    for (SimplexIndex edge = edges.first_of_step[step]; edge < edges.size(); ++edge) {
        if (edges.death[track_][edge] != kNever) continue;
        const auto ends = edges.tuple(edge);
        for (std::uint32_t end = 0; end < 2; ++end) {
            next_[2 * edge + end] = first_[ends[end] - 1];
            first_[ends[end] - 1] = 2 * edge + end;
        }
        components_.add_edge(ends[0] - 1, ends[1] - 1);
    }
    for (const Death& death : deaths) {
        if (death.track != track_ || death.dimension != 1) continue;
        const auto ends = edges.tuple(death.simplex);
        components_.remove_edge(ends[0] - 1, ends[1] - 1);
    }
    components_.settle([&](std::uint32_t landmark, const auto& use) {
        std::uint32_t* link = &first_[landmark];
        while (*link != kEnd) {
            const SimplexIndex edge = *link / 2;
            if (edges.death[track_][edge] == kNever) {
                use(edges.tuple(edge)[1 - *link % 2] - 1);
                link = &next_[*link];
            } else {
                *link = next_[*link];
            }
        }
    });
}

std::uint64_t SkeletonComponents::memory() const {
    return (first_.capacity() + next_.capacity()) * sizeof(std::uint32_t) + components_.memory();
}

}  // namespace plateau
