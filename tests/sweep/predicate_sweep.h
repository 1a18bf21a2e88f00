#pragma once

#include <cstdint>

namespace plateau::sweep {

struct Outcome {
    std::uint32_t calls = 0;
    std::uint32_t mismatches = 0;
};

/// Near-degenerate inputs (small grids, cospherical integer points, almost coplanar ones, each moved by up to two units
/// in the last place, at spacings 1e-3, 0.1, 1/3, 1 and 1e6): the signs that CGAL's predicates and ours give, against
/// signs of determinants in big integers. `rounds` inputs a spacing and kind.
Outcome sweep_predicates(std::uint32_t rounds);

/// FNV-1a over the sorted finite cells of D(L) of an edge^3 grid of the given spacing, inserted in a shuffled order. A
/// build whose intervals are rounded the wrong way never returns from this.
std::uint64_t grid_delaunay_hash(std::uint32_t edge, double spacing);

}  // namespace plateau::sweep
