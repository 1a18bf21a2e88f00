#include "complex/delaunay_faces.h"

#include "base/few.h"

namespace plateau {

namespace {

SimplexIndex born_simplex(const LinkTable& candidates, const Step* others) {
    const std::uint32_t candidate = candidates.find(others);
    return candidate == kNoSimplex ? kNoSimplex : candidates[candidate].simplex;
}

}  // namespace

void DelaunayFaces::update(Step step, const Delaunay& delaunay, const DelaunayChange& change, const NuComplex& complex,
                           const std::vector<SimplexTable>& tables) {
    if (change.dimension < 3) return;
    constexpr std::array<SimplexIndex, 4> kNoTriangles{kNoSimplex, kNoSimplex, kNoSimplex, kNoSimplex};
    triangle_.resize(delaunay.cell_capacity(), kNoTriangles);
    tetrahedron_.resize(delaunay.cell_capacity(), kNoSimplex);
    facet_.resize(tables[1].size());
    cell_.resize(tables[2].size());

    for (const CellId id : change.born) {
        const DelaunayCell& cell = delaunay.cell(id);
        triangle_[id] = kNoTriangles;
        tetrahedron_[id] = kNoSimplex;
        for (int i = 0; i < 4; ++i) {
            std::array<Step, 3> vertices{};
            std::size_t count = 0;
            bool contains_new = false;
            for (int j = 0; j < 4; ++j) {
                const Step vertex = cell.vertex[static_cast<std::size_t>(j)];
                if (j == i || vertex == kInfiniteVertex) continue;
                contains_new = contains_new || vertex == step;
                if (vertex != step) vertices[count++] = vertex;
            }
            sort_few(vertices.data(), count);
            SimplexIndex triangle = kNoSimplex;
            if (contains_new && count == 2) {
                triangle = born_simplex(complex.candidates(2), vertices.data());
            } else if (!contains_new && count == 3) {
                if (change.dimension_rose) {
                    triangle = tables[1].find(vertices);
                } else {
                    const CellId outside = cell.neighbor[static_cast<std::size_t>(i)];
                    triangle =
                        triangle_[outside][static_cast<std::size_t>(delaunay.cell(outside).index_of_neighbor(id))];
                }
            }
            triangle_[id][static_cast<std::size_t>(i)] = triangle;
            if (triangle != kNoSimplex) facet_[triangle] = {id, i};
            const bool whole = cell.vertex[static_cast<std::size_t>(i)] == step && count == 3;
            if (whole) tetrahedron_[id] = born_simplex(complex.candidates(3), vertices.data());
        }
        if (tetrahedron_[id] != kNoSimplex) cell_[tetrahedron_[id]] = id;
    }
}

}  // namespace plateau
