#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/paged_table.h"
#include "base/result.h"

namespace plateau {

/// Index of a cell of D(L), reused after its death (never within the step of the death).
using CellId = std::uint32_t;
inline constexpr CellId kNoCell = 0xFFFFFFFFu;
/// The infinite vertex; landmarks are named by their step, which starts at 1.
inline constexpr std::uint32_t kInfiniteVertex = 0;

/// A maximal simplex of D(L), or an infinite one over a hull facet. With m the dimension of D(L) the first m+1 entries
/// are in use; neighbor[i] is opposite vertex[i]. In 3d the vertices are positively oriented.
struct DelaunayCell {
    std::array<std::uint32_t, 4> vertex{};
    std::array<CellId, 4> neighbor{};
    bool alive = false;

    bool finite(int dimension) const {
        for (int i = 0; i <= dimension; ++i) {
            if (vertex[static_cast<std::size_t>(i)] == kInfiniteVertex) return false;
        }
        return true;
    }
    int index_of_vertex(std::uint32_t step) const { return index_in(vertex, step); }
    int index_of_neighbor(CellId cell) const { return index_in(neighbor, cell); }

private:
    // No branches: which of the four it is cannot be foreseen.
    static int index_in(const std::array<std::uint32_t, 4>& values, std::uint32_t value) {
        const int in_second_half = values[0] != value && values[1] != value ? 1 : 0;
        const auto first = static_cast<std::size_t>(2 * in_second_half);
        return 2 * in_second_half + (values[first] != value ? 1 : 0);
    }
};

/// What one insertion did. `died` cells stay readable until the next insertion.
struct DelaunayChange {
    std::vector<CellId> died;
    std::vector<CellId> born;
    int dimension = 0;            ///< m, of the affine hull of the landmarks so far
    bool dimension_rose = false;  ///< then every cell died and every cell is new
};

/// D(L): the Delaunay triangulation of the landmarks in their affine hull, incrementally; cospherical ties by symbolic
/// perturbation in the lexicographic order of coordinates, so the result does not depend on the insertion order.
/// One point, two points, collinear and coplanar sets are triangulations of dimension 0, 1, 2.
class Delaunay {
public:
    /// Points in the plane or in space (dimension 2 or 3).
    explicit Delaunay(std::uint32_t ambient_dimension);
    Delaunay(Delaunay&&) noexcept;
    Delaunay& operator=(Delaunay&&) noexcept;
    ~Delaunay();

    /// Inserts the landmark of this step (1, 2, ...), which differs from all before. `hint`: a landmark nearby, best
    /// the nearest one; ignored at step 1. Error: OutOfMemory. Expected cost: O(1) for points on a surface in
    /// farthest-first order; on a curve in space up to O(step).
    Result<const DelaunayChange*> insert(std::uint32_t step, std::span<const double> point, std::uint32_t hint);

    int dimension() const { return change_.dimension; }
    const DelaunayCell& cell(CellId id) const { return cells_[id]; }
    /// One more than the largest cell index in use.
    CellId cell_capacity() const { return static_cast<CellId>(cells_.size()); }
    /// Cells alive now, infinite ones included.
    std::uint32_t cell_count() const { return cell_count_; }

private:
    struct Triangulation;
    CellId take_slot();
    void mirror_born();

    std::unique_ptr<Triangulation> triangulation_;
    std::uint32_t ambient_dimension_;
    PagedTable<DelaunayCell> cells_;
    std::vector<CellId> free_;
    std::uint32_t cell_count_ = 0;
    DelaunayChange change_;
};

}  // namespace plateau
