#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/dynamic_components.h"
#include "complex/delaunay_faces.h"
#include "delaunay/delaunay.h"
#include "surface/peeling.h"

namespace plateau {

/// The cells of D(L) that are reached from the infinite cells through facets not in K [GO 3.2.2 step 4], under
/// insertion. What opens is flooded; what is cut off is found as components under change are.
class OuterRegion {
public:
    /// Follows one insertion, after K has followed it. `all`: D(L) has just become spatial.
    void update(Step step, const Delaunay& delaunay, const DelaunayChange& change, const DelaunayFaces& faces,
                const Peeling& peeling, bool all);

    /// Asks for what is known of the cell.
    void expect(CellId cell) const {
        if (cell >= cells_.size()) return;
        prefetch(&cells_[cell]);
        components_.expect(cell + 1);
    }
    bool outer(CellId cell) const { return cells_[cell].outer; }
    /// Cells that were there before the last step and changed sides.
    std::span<const CellId> flipped() const { return flipped_; }
    std::uint64_t memory() const { return cells_.capacity() * sizeof(Cell) + components_.memory(); }

private:
    using Node = DynamicComponents::Node;
    static constexpr Node kOutside = 0;  // the infinite cells; a finite cell is its id + 1
    struct Cell {
        Step born = 0;
        Step touched = 0;  // last step at which it was told its side
        bool infinite = false;
        bool outer = false;
        bool was_outer = false;  // before the step at which it was touched
    };
    struct Context {
        Step step;
        const Delaunay& delaunay;
        const DelaunayChange& change;
        const DelaunayFaces& faces;
        const Peeling& peeling;

        bool open(CellId cell, int index) const {
            const SimplexIndex triangle = faces.triangle(cell, index);
            return triangle == kNoSimplex || !peeling.kept(triangle);
        }
        bool was_open(CellId cell, int index) const {
            const SimplexIndex triangle = faces.triangle(cell, index);
            return triangle == kNoSimplex || !peeling.was_kept(triangle);
        }
    };

    Node node(CellId cell) const { return cells_[cell].infinite ? kOutside : cell + 1; }
    void remove_died(const Context& context);
    void add_born(const Context& context);
    void change_facets(const Context& context);
    void flood(const Context& context);
    void set_outer(CellId cell, bool outer, Step step);

    std::vector<Cell> cells_;  // by cell of D(L)
    DynamicComponents components_{kOutside};
    std::vector<CellId> stack_;  // outer cells that may open to others
    std::vector<CellId> touched_, flipped_;
};

}  // namespace plateau
