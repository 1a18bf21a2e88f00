#include "homology/skeleton_components.h"

namespace plateau {

void SkeletonComponents::update(Step step, const SimplexTable& edges, std::span<const Death> deaths) {
    const std::uint32_t landmark = step - 1;
    label_.push_back(labels_.make());
    labels_.add(label_.back());
    joined_at_.push_back(step);
    first_.push_back(kEnd);
    search_.resize(step);
    next_.resize(2 * static_cast<std::size_t>(edges.size()), kEnd);

    for (SimplexIndex edge = edges.first_of_step[step]; edge < edges.size(); ++edge) {
        if (edges.death[track_][edge] != kNever) continue;
        const std::uint32_t other = edges.tuple(edge)[0] - 1;
        next_[2 * edge] = first_[other];
        first_[other] = 2 * edge;
        next_[2 * edge + 1] = first_[landmark];
        first_[landmark] = 2 * edge + 1;
        joined_at_[other] = step;
        labels_.join(label_[other], label_[landmark]);
    }
    suspects_.clear();
    for (const Death& death : deaths) {
        if (death.track != track_ || death.dimension != 1) continue;
        const auto ends = edges.tuple(death.simplex);
        // Mostly the way over the new landmark stands in for the edge.
        if (joined_at_[ends[0] - 1] == step && joined_at_[ends[1] - 1] == step) continue;
        suspects_.push_back(ends[0] - 1);
        suspects_.push_back(ends[1] - 1);
    }
    if (!suspects_.empty()) separate(edges);
}

// Every piece that came off holds an end of an edge that died and has no stand-in.
void SkeletonComponents::separate(const SimplexTable& edges) {
    const auto visit_neighbors = [&](std::uint32_t landmark, const auto& use) {
        std::uint32_t* link = &first_[landmark];
        while (*link != kEnd) {
            const SimplexIndex edge = *link / 2;
            if (edges.death[track_][edge] != kNever) {
                *link = next_[*link];
                continue;
            }
            use(edges.tuple(edge)[*link % 2 == 0 ? 1 : 0] - 1);
            link = &next_[*link];
        }
    };
    const auto label_of = [&](std::uint32_t landmark) -> ComponentLabels::Label& { return label_[landmark]; };
    const auto endless = [](std::uint32_t) { return false; };
    labels_.for_each_shared(suspects_, label_of, [&](std::span<const std::uint32_t> suspects) {
        search_.run(suspects, visit_neighbors, endless, [&](const auto& piece) { labels_.cut_off(piece, label_of); });
    });
}

std::uint64_t SkeletonComponents::memory() const {
    return (label_.capacity() + joined_at_.capacity() + first_.capacity() + next_.capacity()) * sizeof(std::uint32_t) +
           labels_.memory() + search_.memory();
}

}  // namespace plateau
