#include "complex/delaunay_faces.h"

namespace plateau {

void DelaunayFaces::update(Step step, const Delaunay& delaunay, const DelaunayChange& change, const DelaunayLink& link,
                           const std::vector<SimplexTable>& tables) {
    faces_.resize(delaunay.cell_capacity());
    if (tables.size() > 1) facet_.resize(tables[1].size());
    if (tables.size() > 2) cell_.resize(tables[2].size());

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
                edge[i][j] = edge[j][i] = DelaunayLink::kNone;
                if (i == apex || j == apex) {
                    const std::uint32_t other = place[i == apex ? j : i];
                    if (other != DelaunayLink::kNone) faces.edge[kEdge[i][j]] = link.vertices()[other].born;
                } else if (place[i] != DelaunayLink::kNone && place[j] != DelaunayLink::kNone) {
                    edge[i][j] = edge[j][i] = link.edge(place[i], place[j]);
                    if (edge[i][j] != DelaunayLink::kNone) faces.edge[kEdge[i][j]] = link.edges()[edge[i][j]].base;
                }
            }
        }
        // The triangle opposite i, in a flat cell the cell: with p it is over an edge of the link, else in the link.
        for (std::size_t i = corners == 4 ? 0 : 3; corners >= 3 && i < 4; ++i) {
            std::array<std::size_t, 3> other{};
            std::size_t count = 0;
            for (std::size_t j = 0; j < 4; ++j) {
                if (j != i) other[count++] = j;
            }
            SimplexIndex triangle = kNoSimplex;
            std::uint32_t base = DelaunayLink::kNone;
            if (i == apex || apex == 4) {
                base = edge[other[0]][other[1]];
                const std::uint32_t third = place[other[2]];
                if (base != DelaunayLink::kNone && third != DelaunayLink::kNone)
                    base = link.triangle(base, third);
                else
                    base = DelaunayLink::kNone;
                if (base != DelaunayLink::kNone) triangle = link.triangles()[base].base;
                if (base != DelaunayLink::kNone && i == apex) faces.tetrahedron = link.triangles()[base].born;
            } else {
                if (other[0] == apex) base = edge[other[1]][other[2]];
                if (other[1] == apex) base = edge[other[0]][other[2]];
                if (other[2] == apex) base = edge[other[0]][other[1]];
                if (base != DelaunayLink::kNone) triangle = link.edges()[base].born;
            }
            faces.triangle[i] = triangle;
            if (triangle != kNoSimplex) facet_[triangle] = {id, static_cast<int>(i)};
        }
        if (faces.tetrahedron != kNoSimplex) cell_[faces.tetrahedron] = id;
        faces_[id] = faces;
    }
}

std::uint64_t DelaunayFaces::memory() const {
    return faces_.capacity() * sizeof(Faces) + facet_.capacity() * sizeof(Facet) + cell_.capacity() * sizeof(CellId);
}

}  // namespace plateau
