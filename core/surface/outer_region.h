#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/paged_table.h"
#include "base/part_search.h"
#include "base/prefetch.h"
#include "base/slice.h"
#include "complex/delaunay_faces.h"
#include "delaunay/delaunay.h"
#include "surface/peeling.h"

namespace plateau {

/// The cells of D(L) that are reached from the infinite cells through facets not in K [GO 3.2.2 step 4], under
/// insertion. What opens is flooded. Only a triangle that enters K can cut something off, since the cells around a new
/// landmark hang together else; then searches go out from the outer cells that lost an open facet.
class OuterRegion {
public:
    /// Follows one insertion, after K has followed it. `all`: D(L) has just become spatial. False if the slice was used
    /// up before the end: call it again, with the same arguments, before anything else is asked.
    bool update(Step step, const Delaunay& delaunay, const DelaunayChange& change, const DelaunayFaces& faces,
                const Peeling& peeling, bool all, Slice& slice);

    /// Asks for what is known of the cell.
    void expect(CellId cell) const {
        if (cell < cells_.size()) prefetch(&cells_[cell]);
    }
    bool outer(CellId cell) const { return cells_[cell].outer; }
    /// Whether the facet is in K.
    bool closed(CellId cell, int index) const { return (cells_[cell].closed >> index & 1) != 0; }
    /// Cells that were there before the last step and changed sides.
    std::span<const CellId> flipped() const { return flipped_; }
    std::uint64_t memory() const { return cells_.capacity() * sizeof(Cell) + search_.memory(); }

private:
    using Node = PartSearch::Node;
    static constexpr Node kOutside = 0;  // the infinite cells; a finite cell is its id + 1
    struct Cell {
        Step born = 0;
        Step touched = 0;         // last step at which it was told its side
        std::uint8_t closed = 0;  // bit i: facet i is in K
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
    };

    Node node(CellId cell) const { return cells_[cell].infinite ? kOutside : cell + 1; }
    void begin(const Context& context, bool all);
    void suspect_around_died(const Context& context);
    void add_born(const Context& context);
    void change_facets(const Context& context);
    bool flood(const Context& context, Slice& slice);
    void close(CellId cell, int index, bool closed);
    void set_outer(CellId cell, bool outer, Step step);

    PagedTable<Cell> cells_;  // by cell of D(L)
    PartSearch search_;
    std::vector<Node> suspects_;  // outer cells that an open facet led out of
    std::vector<CellId> stack_;   // outer cells that may open to others
    std::vector<CellId> touched_, flipped_;
    bool begun_ = false;
};

}  // namespace plateau
