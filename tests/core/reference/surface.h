#pragma once

#include <array>
#include <set>
#include <vector>

#include "reference/exact.h"
#include "reference/triangulation.h"

namespace plateau::reference {

/// A kept facet seen from one outer side. Side 0: the outer side is where its ascending vertices turn
/// counter-clockwise.
struct Row {
    Simplex triangle;
    int side = 0;

    friend bool operator<(const Row& a, const Row& b) {
        return a.triangle != b.triangle ? a.triangle < b.triangle : a.side < b.side;
    }
    friend bool operator==(const Row& a, const Row& b) { return a.triangle == b.triangle && a.side == b.side; }
};

/// The surface as a closed complex glued from triangles; vertices and edges met twice are separate.
struct Surface {
    std::vector<Row> rows;                    ///< sorted
    std::vector<std::array<int, 3>> corners;  ///< mesh vertex at each vertex of each row's triangle, 0-based
    std::vector<std::array<int, 3>> sides;    ///< mesh edge opposite to each vertex of each row's triangle, 0-based
    int vertex_count = 0;
    int edge_count = 0;
    int component_count = 0;

    int euler_characteristic() const { return vertex_count - edge_count + static_cast<int>(rows.size()); }
    /// By the formula for closed surfaces: beta_0 = beta_2 = components, beta_1 = 2 beta_0 - chi.
    std::vector<int> betti() const;
    /// By elimination of the boundary matrices of the glued cells.
    std::vector<int> betti_by_elimination() const;
};

/// Steps (2) and (3): triangles without those of a radius-edge ratio above rho (0: off) and, as long as there are any,
/// without those at sharp edges.
std::set<Simplex> without_sharp_edges(std::set<Simplex> triangles, const ExactPoints& points, double rho);

/// Step (4): the outer boundary of the kept triangles in a triangulation of space; empty in lower dimension.
Surface outer_boundary(const std::set<Simplex>& kept, const Triangulation& triangulation, const ExactPoints& points);

}  // namespace plateau::reference
