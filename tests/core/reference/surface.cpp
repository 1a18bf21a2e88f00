#include "reference/surface.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "reference/cellular.h"
#include "reference/elimination.h"

namespace plateau::reference {
namespace {

Simplex without(Simplex simplex, int vertex) {
    simplex.erase(std::find(simplex.begin(), simplex.end(), vertex));
    return simplex;
}

int opposite_vertex(const Simplex& cell, const Simplex& facet) {
    for (const int vertex : cell) {
        if (!std::binary_search(facet.begin(), facet.end(), vertex)) return vertex;
    }
    throw std::logic_error("a facet with all vertices of its cell");
}

std::vector<bool> flooded(const Cellular& space, const std::set<Simplex>& kept) {
    std::vector<bool> outer(space.cells.size());
    std::vector<int> pending;
    for (std::size_t c = 0; c < space.cells.size(); ++c) {
        if (!space.infinite(static_cast<int>(c))) continue;
        outer[c] = true;
        pending.push_back(static_cast<int>(c));
    }
    while (!pending.empty()) {
        const int cell = pending.back();
        pending.pop_back();
        for (const Simplex& facet : facets(space.cells[static_cast<std::size_t>(cell)])) {
            if (kept.count(facet) > 0) continue;
            const int neighbor = space.across(facet, cell);
            if (outer[static_cast<std::size_t>(neighbor)]) continue;
            outer[static_cast<std::size_t>(neighbor)] = true;
            pending.push_back(neighbor);
        }
    }
    return outer;
}

/// Which side of the triangle the cell is on.
int side_of(const Simplex& triangle, int cell, const Cellular& space, const ExactPoints& points) {
    const bool infinite = space.infinite(cell);
    const int finite = infinite ? space.across(triangle, cell) : cell;
    const int apex = opposite_vertex(space.cells[static_cast<std::size_t>(finite)], triangle);
    const int sign = orientation(points, triangle[0], triangle[1], triangle[2], apex);
    if (sign == 0) throw std::logic_error("a flat cell");
    return ((sign > 0) != infinite) ? 0 : 1;
}

}  // namespace

std::set<Simplex> without_sharp_edges(std::set<Simplex> triangles, const ExactPoints& points, double rho) {
    for (auto it = triangles.begin(); rho > 0 && it != triangles.end();) {
        it = radius_edge_ratio_exceeds(points, *it, rho) ? triangles.erase(it) : std::next(it);
    }
    while (true) {
        std::map<Simplex, std::vector<int>> thirds;
        for (const Simplex& triangle : triangles) {
            for (const Simplex& edge : facets(triangle)) thirds[edge].push_back(opposite_vertex(triangle, edge));
        }
        std::set<Simplex> doomed;
        for (const auto& [edge, vertices] : thirds) {
            bool sharp = true;
            for (const int a : vertices) {
                for (const int b : vertices) sharp = sharp && wedge_sign(points, edge, a, b) >= 0;
            }
            if (!sharp) continue;
            for (const int third : vertices) {
                Simplex triangle = edge;
                triangle.push_back(third);
                std::sort(triangle.begin(), triangle.end());
                doomed.insert(triangle);
            }
        }
        if (doomed.empty()) return triangles;
        for (const Simplex& triangle : doomed) triangles.erase(triangle);
    }
}

Surface outer_boundary(const std::set<Simplex>& kept, const Triangulation& triangulation, const ExactPoints& points) {
    Surface surface;
    if (triangulation.dimension < 3 || kept.empty()) return surface;
    const Cellular space(triangulation);
    const std::vector<bool> outer = flooded(space, kept);

    std::map<Row, int> cell_of_row;
    for (const Simplex& triangle : kept) {
        for (const int cell : space.at_facet.at(triangle)) {
            if (outer[static_cast<std::size_t>(cell)])
                cell_of_row[{triangle, side_of(triangle, cell, space, points)}] = cell;
        }
    }
    for (const auto& entry : cell_of_row) surface.rows.push_back(entry.first);
    const auto number_of = [&](const Row& row) {
        return static_cast<std::size_t>(std::lower_bound(surface.rows.begin(), surface.rows.end(), row) -
                                        surface.rows.begin());
    };

    Classes corner_classes(3 * surface.rows.size()), side_classes(3 * surface.rows.size()),
        components(surface.rows.size());
    for (const auto& [row, first_cell] : cell_of_row) {
        for (std::size_t left_out = 0; left_out < 3; ++left_out) {
            // Around the edge, from the outer cell at this row through facets not kept, to the next kept facet.
            const Simplex edge = without(row.triangle, row.triangle[left_out]);
            Simplex facet = row.triangle;
            int cell = first_cell;
            while (true) {
                const Simplex& vertices = space.cells[static_cast<std::size_t>(cell)];
                facet = without(vertices, opposite_vertex(facet, edge));
                if (kept.count(facet) > 0) break;
                cell = space.across(facet, cell);
            }
            const std::size_t here = number_of(row);
            const std::size_t there = number_of({facet, side_of(facet, cell, space, points)});
            if (here == there) throw std::logic_error("a surface triangle glued to itself");
            const auto place = [](const Simplex& triangle, int vertex) {
                return static_cast<std::size_t>(std::find(triangle.begin(), triangle.end(), vertex) - triangle.begin());
            };
            components.unite(here, there);
            side_classes.unite(3 * here + left_out, 3 * there + place(facet, opposite_vertex(facet, edge)));
            for (const int vertex : edge) {
                corner_classes.unite(3 * here + place(row.triangle, vertex), 3 * there + place(facet, vertex));
            }
        }
    }
    const std::vector<int> corners = corner_classes.numbers(surface.vertex_count);
    const std::vector<int> sides = side_classes.numbers(surface.edge_count);
    components.numbers(surface.component_count);
    for (std::size_t row = 0; row < surface.rows.size(); ++row) {
        surface.corners.push_back({corners[3 * row], corners[3 * row + 1], corners[3 * row + 2]});
        surface.sides.push_back({sides[3 * row], sides[3 * row + 1], sides[3 * row + 2]});
    }
    return surface;
}

std::vector<int> Surface::betti() const {
    return {component_count, 2 * component_count - euler_characteristic(), component_count};
}

std::vector<int> Surface::betti_by_elimination() const {
    std::vector<std::vector<int>> edges(static_cast<std::size_t>(edge_count)), triangles;
    for (std::size_t row = 0; row < rows.size(); ++row) {
        triangles.push_back({sides[row].begin(), sides[row].end()});
        for (std::size_t k = 0; k < 3; ++k) {
            edges[static_cast<std::size_t>(sides[row][k])] = {corners[row][(k + 1) % 3], corners[row][(k + 2) % 3]};
        }
    }
    const int rank_edges = rank_mod_two(edges, vertex_count);
    const int rank_triangles = rank_mod_two(triangles, edge_count);
    return {vertex_count - rank_edges, edge_count - rank_edges - rank_triangles,
            static_cast<int>(rows.size()) - rank_triangles};
}

}  // namespace plateau::reference
