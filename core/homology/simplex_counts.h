#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "complex/simplex_table.h"

namespace plateau {

/// How many simplices of each dimension live in a track, vertices included, after every step.
class SimplexCounts {
public:
    SimplexCounts(int track, int max_dimension) : track_(track), counts_(static_cast<std::size_t>(max_dimension) + 1) {}

    /// Follows one insertion. `deaths` of this step, `hidden`: landmarks that stopped being vertices at it or never
    /// were one.
    void update(Step step, const std::vector<SimplexTable>& tables, std::span<const Death> deaths,
                std::span<const Step> hidden = {});

    std::uint32_t operator[](std::size_t dimension) const { return counts_[dimension]; }
    int max_dimension() const { return static_cast<int>(counts_.size()) - 1; }
    /// The Euler characteristic: their alternating sum.
    std::int64_t euler() const;

private:
    int track_;
    std::vector<std::uint32_t> counts_;  // by dimension, from 0
};

}  // namespace plateau
