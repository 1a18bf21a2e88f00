#include "homology/simplex_counts.h"

namespace plateau {

void SimplexCounts::update(Step step, const std::vector<SimplexTable>& tables, std::span<const Death> deaths,
                           std::span<const Step> hidden) {
    counts_[0] += 1 - static_cast<std::uint32_t>(hidden.size());
    for (const Death& death : deaths) {
        if (death.track == track_) --counts_[death.dimension];
    }
    for (const SimplexTable& table : tables) {
        const auto& death = table.death[static_cast<std::size_t>(track_)];
        for (SimplexIndex simplex = table.first_of_step[step]; simplex < table.size(); ++simplex) {
            if (death[simplex] == kNever) ++counts_[static_cast<std::size_t>(table.dimension)];
        }
    }
}

std::int64_t SimplexCounts::euler() const {
    std::int64_t sum = 0;
    for (std::size_t k = 0; k < counts_.size(); ++k) {
        sum += k % 2 == 0 ? std::int64_t{counts_[k]} : -std::int64_t{counts_[k]};
    }
    return sum;
}

}  // namespace plateau
