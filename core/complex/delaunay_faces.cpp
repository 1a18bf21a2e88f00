#include "complex/delaunay_faces.h"

namespace plateau {

namespace {
constexpr std::uint32_t kNone = DelaunayLink::kNone;
}

void DelaunayFaces::update(Step step, const Delaunay& delaunay, const DelaunayChange& change, const DelaunayLink& link,
                           const std::vector<SimplexTable>& tables) {
    faces_.grow(delaunay.cell_capacity());
    if (tables.size() > 1) facet_.grow(tables[1].size());
    if (tables.size() > 2) cell_.grow(tables[2].size());

    if (change.dimension < 3 || change.dimension_rose) {
        update_by_vertices(step, delaunay, change, link);
    } else {
        update_spatial(change, link);
    }
}

// Edges and triangles without p are in the link, those with p stand over its vertices and edges.
void DelaunayFaces::update_spatial(const DelaunayChange& change, const DelaunayLink& link) {
    for (std::size_t t = 0; t < change.born.size(); ++t) {
        const CellId id = change.born[t];
        const DelaunayLink::Triangle& base = link.triangles()[t];
        Faces faces;
        for (std::size_t j = 0; j < 3; ++j) {
            if (base.vertex[j] != kNone) {
                faces.edge[kEdge[base.apex][base.corner[j]]] = link.vertices()[base.vertex[j]].born;
            }
            if (base.edge[j] == kNone) continue;
            const DelaunayLink::Edge& edge = link.edges()[base.edge[j]];
            faces.edge[kEdge[base.corner[(j + 1) % 3]][base.corner[(j + 2) % 3]]] = edge.base;
            faces.triangle[base.corner[j]] = edge.born;
        }
        faces.triangle[base.apex] = base.base;
        faces.tetrahedron = base.born;
        for (int i = 0; i < 4; ++i) {
            const SimplexIndex triangle = faces.triangle[static_cast<std::size_t>(i)];
            if (triangle != kNoSimplex) facet_[triangle] = {id, i};
        }
        if (faces.tetrahedron != kNoSimplex) cell_[faces.tetrahedron] = id;
        faces_[id] = faces;
    }
}

// Where the triangles of the link do not stand for the new cells one by one.
void DelaunayFaces::update_by_vertices(Step step, const Delaunay& delaunay, const DelaunayChange& change,
                                       const DelaunayLink& link) {
    const auto corners = static_cast<std::size_t>(change.dimension) + 1;
    for (const CellId id : change.born) {
        const DelaunayCell& cell = delaunay.cell(id);
        Faces faces;
        std::array<std::uint32_t, 4> place{};
        std::size_t apex = 4;
        for (std::size_t i = 0; i < corners; ++i) {
            if (cell.vertex[i] == step) apex = i;
            place[i] = link.vertex(cell.vertex[i]);
        }
        std::array<std::array<std::uint32_t, 4>, 4> edge{};  // of the link, by places in the cell
        for (std::size_t i = 0; i < corners; ++i) {
            for (std::size_t j = i + 1; j < corners; ++j) {
                if (i == apex || j == apex) {
                    const std::uint32_t other = place[i == apex ? j : i];
                    if (other != kNone) faces.edge[kEdge[i][j]] = link.vertices()[other].born;
                } else {
                    const std::uint32_t base = edge[i][j] = edge[j][i] = link.edge(place[i], place[j]);
                    if (base != kNone) faces.edge[kEdge[i][j]] = link.edges()[base].base;
                }
            }
        }
        // The triangle opposite i; in a flat cell the cell, opposite the corner that it lacks.
        for (std::size_t i = corners == 4 ? 0 : 3; corners >= 3 && i < 4; ++i) {
            std::array<std::size_t, 3> other{};  // its corners but p
            std::size_t count = 0;
            for (std::size_t j = 0; j < 4; ++j) {
                if (j != i && j != apex) other[count++] = j;
            }
            const std::uint32_t base = edge[other[0]][other[1]];
            if (count == 2) {
                if (base != kNone) faces.triangle[i] = link.edges()[base].born;
            } else if (const std::uint32_t whole = link.triangle(base, place[other[2]]); whole != kNone) {
                faces.triangle[i] = link.triangles()[whole].base;
                if (i == apex) faces.tetrahedron = link.triangles()[whole].born;
            }
            if (faces.triangle[i] != kNoSimplex) facet_[faces.triangle[i]] = {id, static_cast<int>(i)};
        }
        if (faces.tetrahedron != kNoSimplex) cell_[faces.tetrahedron] = id;
        faces_[id] = faces;
    }
}

std::uint64_t DelaunayFaces::memory() const {
    return faces_.capacity() * sizeof(Faces) + facet_.capacity() * sizeof(Facet) + cell_.capacity() * sizeof(CellId);
}

}  // namespace plateau
