#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "complex/delaunay_faces.h"
#include "delaunay/delaunay.h"
#include "surface/peeling.h"

namespace plateau {

/// The cells of D(L) that are reached from the infinite cells through facets not in K [GO 3.2.2 step 4], under
/// insertion.
///
/// What opens is flooded. What may have been cut off is the rest of the outer region on both sides of the cut: searches
/// run in turn from every cell next to the cut until they meet, reach an infinite cell, or exhaust a part that is
/// enclosed now; so a step costs about the smaller part.
class OuterRegion {
public:
    /// Follows one insertion, after K has followed it.
    void update(const Delaunay& delaunay, const DelaunayChange& change, const DelaunayFaces& faces,
                const Peeling& peeling, bool all);

    bool outer(CellId cell) const { return outer_[cell] != 0; }
    /// Cells that were there before the last step and changed sides.
    std::span<const CellId> flipped() const { return flipped_; }
    std::uint64_t memory() const { return outer_.capacity() * (2 + 2 * sizeof(std::uint32_t)); }

private:
    struct Context {
        const Delaunay& delaunay;
        const DelaunayFaces& faces;
        const Peeling& peeling;

        bool open(CellId cell, int index) const {
            const SimplexIndex triangle = faces.triangle(cell, index);
            return triangle == kNoSimplex || !peeling.kept(triangle);
        }
    };

    void find_enclosed(const Context& context, const std::vector<CellId>& suspects);
    void flood(const Context& context, std::vector<CellId>& stack);
    void set_outer(CellId cell, bool outer);

    std::vector<std::uint8_t> outer_;        // by cell
    std::vector<std::uint8_t> was_outer_;    // by cell, for those touched at this step
    std::vector<std::uint32_t> touched_at_;  // by cell
    std::vector<std::uint32_t> seen_at_;     // by cell: search number
    std::vector<std::uint32_t> group_;       // by cell: group of the current search
    std::vector<std::uint32_t> born_at_;
    std::vector<CellId> touched_, flipped_;
    std::uint32_t now_ = 0;
};

}  // namespace plateau
