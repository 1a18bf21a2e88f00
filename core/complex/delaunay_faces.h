#pragma once

#include <array>
#include <optional>
#include <vector>

#include "base/paged_table.h"
#include "base/prefetch.h"
#include "complex/delaunay_link.h"
#include "complex/simplex_table.h"
#include "delaunay/delaunay.h"

namespace plateau {

/// Which recorded simplices the faces of each cell of D(L) are, and where the recorded triangles and tetrahedra lie
/// among the cells: the dictionary between complex and triangulation, so that nothing is looked up by its vertices.
class DelaunayFaces {
public:
    /// A facet of D(L) seen from one of its two cells: the one opposite vertex `index` of `cell`.
    struct Facet {
        CellId cell = kNoCell;
        int index = 0;
    };

    /// Asks for the entries of the cell.
    void expect(CellId cell) const {
        if (cell >= faces_.size()) return;
        prefetch(&faces_[cell]);
        prefetch(&faces_[cell].tetrahedron);
    }
    /// Follows one insertion, after its simplices were born. Cost: O(cells born).
    void update(Step step, const Delaunay& delaunay, const DelaunayChange& change, const DelaunayLink& link,
                const std::vector<SimplexTable>& tables);

    /// The recorded edge between two vertices of the cell, by their places, or kNoSimplex if no track ever held it.
    SimplexIndex edge(CellId cell, std::size_t i, std::size_t j) const { return faces_[cell].edge[kEdge[i][j]]; }
    /// The recorded triangle opposite vertex `index` of the cell, or kNoSimplex. Of a flat D(L): the cell itself, at
    /// index 3.
    SimplexIndex triangle(CellId cell, int index) const {
        return faces_[cell].triangle[static_cast<std::size_t>(index)];
    }
    /// The recorded tetrahedron that the cell is, or kNoSimplex.
    SimplexIndex tetrahedron(CellId cell) const { return faces_[cell].tetrahedron; }
    /// One of the two places of a triangle that is in a spatial D(L).
    Facet facet(SimplexIndex triangle) const { return facet_[triangle]; }
    /// The same of a triangle that may have left a spatial D(L): then none.
    std::optional<Facet> facet_in(const Delaunay& delaunay, SimplexIndex triangle) const {
        const Facet place = facet_[triangle];
        const bool there = delaunay.cell(place.cell).alive && this->triangle(place.cell, place.index) == triangle;
        return there ? std::optional(place) : std::nullopt;
    }
    /// The cell of a tetrahedron that is in D(L).
    CellId cell(SimplexIndex tetrahedron) const { return cell_[tetrahedron]; }
    std::uint64_t memory() const;

private:
    void update_spatial(const DelaunayChange& change, const DelaunayLink& link);
    void update_by_vertices(Step step, const Delaunay& delaunay, const DelaunayChange& change,
                            const DelaunayLink& link);

    static constexpr std::size_t kEdge[4][4] = {{6, 0, 1, 2}, {0, 6, 3, 4}, {1, 3, 6, 5}, {2, 4, 5, 6}};
    struct Faces {
        std::array<SimplexIndex, 6> edge{kNoSimplex, kNoSimplex, kNoSimplex, kNoSimplex, kNoSimplex, kNoSimplex};
        std::array<SimplexIndex, 4> triangle{kNoSimplex, kNoSimplex, kNoSimplex, kNoSimplex};
        SimplexIndex tetrahedron = kNoSimplex;
    };

    PagedTable<Faces> faces_;  // by cell
    PagedTable<Facet> facet_;  // by triangle
    PagedTable<CellId> cell_;  // by tetrahedron
};

}  // namespace plateau
