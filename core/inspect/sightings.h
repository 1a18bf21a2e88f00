#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "inspect/landmark_ranks.h"

namespace plateau {

/// How a witness stands to a simplex.
struct Sighting {
    std::uint32_t witness = 0;  ///< input index
    std::uint32_t rank = 0;     ///< the largest rank of a vertex; 0 in family dilated
    double distance = 0;        ///< family dilated: of the witness to the cell of the simplex, input units
};

/// Who witnesses a simplex itself, its faces aside, and who comes nearest to it.
struct Sightings {
    /// By (rank, witness), family dilated by (distance, witness): the first kMaxSightings of them.
    std::vector<Sighting> witnesses;
    std::uint32_t witness_count = 0;  ///< all of them
    /// The best witness, or the closest miss where there is none: the least rank, or distance; ties: the lowest input
    /// index. Nothing where all ranks are beyond the horizon, or the cell is empty.
    std::optional<Sighting> best;
    std::vector<std::uint32_t> best_ranks;  ///< of the vertices in its list; empty in family dilated
};

inline constexpr std::size_t kMaxSightings = 1000;

/// The witnesses with all vertices among the first `allowed` landmarks of their lists. Cost: a rank for each of the n
/// witnesses, and another one where there is no such witness.
Sightings sightings(const LandmarkRanks& ranks, std::span<const Step> simplex, std::uint32_t allowed);

}  // namespace plateau
