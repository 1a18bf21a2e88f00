#pragma once

#include <array>
#include <vector>

#include "complex/nu_complex.h"
#include "complex/simplex_table.h"
#include "delaunay/delaunay.h"

namespace plateau {

/// Where the recorded triangles and tetrahedra lie among the cells of a three-dimensional D(L), and back: the
/// dictionary between the complex and its complement. While D(L) is flat it is empty.
class DelaunayFaces {
public:
    /// A facet of D(L) seen from one of its two cells: the one opposite vertex `index` of `cell`.
    struct Facet {
        CellId cell = kNoCell;
        int index = 0;
    };

    /// Follows one insertion, after the complex has followed it. Cost: O(cells born).
    void update(Step step, const Delaunay& delaunay, const DelaunayChange& change, const NuComplex& complex,
                const std::vector<SimplexTable>& tables);

    /// The recorded triangle opposite vertex `index` of the cell, or kNoSimplex if no track ever held it.
    SimplexIndex triangle(CellId cell, int index) const { return triangle_[cell][static_cast<std::size_t>(index)]; }
    /// The recorded tetrahedron that the cell is, or kNoSimplex.
    SimplexIndex tetrahedron(CellId cell) const { return tetrahedron_[cell]; }
    /// One of the two places of a triangle that is in D(L).
    Facet facet(SimplexIndex triangle) const { return facet_[triangle]; }
    /// The cell of a tetrahedron that is in D(L).
    CellId cell(SimplexIndex tetrahedron) const { return cell_[tetrahedron]; }

private:
    std::vector<std::array<SimplexIndex, 4>> triangle_;
    std::vector<SimplexIndex> tetrahedron_;
    std::vector<Facet> facet_;
    std::vector<CellId> cell_;
};

}  // namespace plateau
