#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/part_search.h"
#include "complex/delaunay_faces.h"
#include "complex/simplex_table.h"
#include "delaunay/delaunay.h"
#include "homology/component_labels.h"

namespace plateau {

/// Connected components of what a spatial D(L) leaves around one track of C_nu^W, after every step: the cells whose
/// tetrahedron is not kept, all infinite cells being one, joined through the facets that are not kept.
class ComplementComponents {
public:
    explicit ComplementComponents(int track) : track_(static_cast<std::size_t>(track)) {}

    /// Follows one insertion into a D(L) of dimension 3, after complex and faces have followed it. `deaths` of this
    /// step. Cost: about the cells that died and were born, and the pieces that came off.
    void update(Step step, const std::vector<SimplexTable>& tables, std::span<const Death> deaths,
                const Delaunay& delaunay, const DelaunayChange& change, const DelaunayFaces& faces);

    std::uint32_t count() const { return labels_.count(); }
    std::uint64_t memory() const;

private:
    using Label = ComponentLabels::Label;
    enum Flags : std::uint32_t { kClosed = 15, kSolid = 16, kInfinite = 32 };
    struct Cell {
        Label label = ComponentLabels::kNone;  // none while the tetrahedron is kept
        std::uint32_t flags = 0;               // bit i: facet i is kept; kSolid: the tetrahedron is
        Step born = 0;
        Step beside_dead = 0;  // last step at which a dead cell was joined to it
    };
    struct Context {
        Step step;
        const std::vector<SimplexTable>& tables;
        const Delaunay& delaunay;
        const DelaunayChange& change;
        const DelaunayFaces& faces;
    };

    bool open(CellId cell, std::size_t facet) const { return (cells_[cell].flags >> facet & 1u) == 0; }
    void open_deaths(const Context& context, std::span<const Death> deaths);
    void leave_dead(const Context& context);
    void set_born(const Context& context);
    void label_born(const Context& context);
    void label_part(CellId first, const Context& context);
    void separate(const Context& context);

    std::size_t track_;
    Label outside_ = ComponentLabels::kNone;
    ComponentLabels labels_;
    std::vector<Cell> cells_;       // by cell of D(L)
    std::vector<CellId> opened_;    // cells next to a facet that opened at this step
    std::vector<CellId> suspects_;  // one of each part that may have come off
    std::vector<CellId> beside_;    // cells that a dead cell was joined to
    std::vector<CellId> part_;      // scratch of label_part
    bool beside_infinity_ = false;  // a dead cell was joined to the infinite ones, or was one
    bool infinity_met_ = false;     // a part of the new cells is joined to them
    CellId infinite_cell_ = kNoCell;
    PartSearch search_;
};

}  // namespace plateau
