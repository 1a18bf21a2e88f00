#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "complex/simplex_table.h"
#include "surface/landmark_points.h"

namespace plateau {

/// One side of a kept triangle at one of its edges: the pieces that are glued around the edge.
struct EdgeSide {
    std::uint32_t row = 0;     ///< the surface row that the side belongs to
    std::uint32_t corner = 0;  ///< place, in the triangle's ascending tuple, of the vertex off the edge
    Step third = 0;            ///< that vertex
    bool forward = false;      ///< the row, counter-clockwise from outside, runs along the edge from its first vertex
};

/// Vertices of a triangle as its row sees them: counter-clockwise from the outer side.
inline std::array<Step, 3> oriented(std::span<const Step> tuple, std::uint8_t side) {
    return side == 0 ? std::array<Step, 3>{tuple[0], tuple[1], tuple[2]}
                     : std::array<Step, 3>{tuple[0], tuple[2], tuple[1]};
}

/// Whether a row runs forward along the edge that lacks the given corner: the cycle v0 v1 v2 runs backward on v0 v2
/// only.
inline bool runs_forward(std::uint8_t side, std::uint32_t corner) {
    return (side == 0) != (corner == 1);
}

/// Pairs the sides at the edge (u, v), u < v, through the outer cells between them [GO 3.2.2 step 4]: each forward side
/// with the backward side that it meets first when it turns into its outer side. Exact; with two sides no geometry.
/// Result: pairs of places in `sides`. Cost: quadratic in the sides at this edge.
std::vector<std::pair<std::uint32_t, std::uint32_t>> pair_sides(std::span<const EdgeSide> sides, Step u, Step v,
                                                                const LandmarkPoints& points);

}  // namespace plateau
