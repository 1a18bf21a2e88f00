#include "homology/complement_components.h"

namespace plateau {

void ComplementComponents::update(Step step, const std::vector<SimplexTable>& tables, std::span<const Death> deaths,
                                  const Delaunay& delaunay, const DelaunayChange& change, const DelaunayFaces& faces) {
    const Context context{step, tables, delaunay, change, faces};
    cells_.resize(delaunay.cell_capacity());
    search_.resize(delaunay.cell_capacity());
    suspects_.clear();
    if (outside_ == ComponentLabels::kNone) {
        outside_ = labels_.make();
        labels_.add(outside_);
    } else {
        leave_dead(context);
        open_deaths(context, deaths);
    }
    set_born(context);
    label_born(context);
    separate(context);
}

// Of the cells that died: their nodes go, and what they were joined to is remembered.
void ComplementComponents::leave_dead(const Context& context) {
    beside_.clear();
    beside_infinity_ = false;
    for (const CellId id : context.change.died) {
        const Cell& cell = cells_[id];
        if ((cell.flags & kSolid) != 0) continue;
        beside_infinity_ = beside_infinity_ || (cell.flags & kInfinite) != 0;
        const DelaunayCell& dead = context.delaunay.cell(id);
        for (std::size_t i = 0; i < 4; ++i) {
            if (!open(id, i) || !context.delaunay.cell(dead.neighbor[i]).alive) continue;
            Cell& neighbor = cells_[dead.neighbor[i]];
            if ((neighbor.flags & kInfinite) != 0) {
                beside_infinity_ = true;
                infinite_cell_ = dead.neighbor[i];
            }
            if ((neighbor.flags & kInfinite) != 0 || neighbor.beside_dead == context.step) continue;
            neighbor.beside_dead = context.step;
            beside_.push_back(dead.neighbor[i]);
        }
        if ((cell.flags & kInfinite) == 0) labels_.remove(cell.label);
    }
}

// What lost its last witness but is still in D(L) opens.
void ComplementComponents::open_deaths(const Context& context, std::span<const Death> deaths) {
    opened_.clear();
    for (const Death& death : deaths) {
        if (death.track != track_ || death.dimension == 1) continue;
        if (death.dimension == 3) {
            const CellId id = context.faces.cell(death.simplex);
            if (!context.delaunay.cell(id).alive || context.faces.tetrahedron(id) != death.simplex) continue;
            Cell& cell = cells_[id];
            cell.flags &= ~std::uint32_t{kSolid};
            cell.label = labels_.make();
            labels_.add(cell.label);
            continue;
        }
        const auto facet = context.faces.facet(death.simplex);
        const DelaunayCell& cell = context.delaunay.cell(facet.cell);
        const bool there = cell.alive && context.faces.triangle(facet.cell, facet.index) == death.simplex;
        if (!there) continue;
        const CellId neighbor = cell.neighbor[static_cast<std::size_t>(facet.index)];
        const int mirror = context.delaunay.cell(neighbor).index_of_neighbor(facet.cell);
        cells_[facet.cell].flags &= ~(1u << facet.index);
        cells_[neighbor].flags &= ~(1u << mirror);
        opened_.push_back(facet.cell);
        opened_.push_back(neighbor);
    }
}

void ComplementComponents::set_born(const Context& context) {
    const auto lives = [&](int dimension, SimplexIndex simplex) {
        return simplex != kNoSimplex &&
               context.tables[static_cast<std::size_t>(dimension - 1)].death[track_][simplex] == kNever;
    };
    for (const CellId id : context.change.born) {
        const DelaunayCell& cell = context.delaunay.cell(id);
        Cell state;
        state.born = context.step;
        if (!cell.finite(3)) {
            state.flags = kInfinite;
            state.label = outside_;
            infinite_cell_ = id;
        } else if (lives(3, context.faces.tetrahedron(id))) {
            state.flags = kSolid;
        }
        for (int i = 0; i < 4; ++i) {
            if (lives(2, context.faces.triangle(id, i))) state.flags |= 1u << i;
        }
        cells_[id] = state;
    }
}

// The new cells in parts that are joined through new facets; each part takes the labels of what lies around it.
void ComplementComponents::label_born(const Context& context) {
    infinity_met_ = false;
    for (const CellId id : context.change.born) {
        const bool waits = cells_[id].label == ComponentLabels::kNone && (cells_[id].flags & kSolid) == 0;
        if (waits) label_part(id, context);
    }
    for (std::size_t i = 0; i < opened_.size(); i += 2) {
        const Label a = cells_[opened_[i]].label;
        const Label b = cells_[opened_[i + 1]].label;
        if (a != ComponentLabels::kNone && b != ComponentLabels::kNone) labels_.join(a, b);
    }
    opened_.clear();
}

void ComplementComponents::label_part(CellId first, const Context& context) {
    constexpr Label kPending = ComponentLabels::kNone - 1;
    Label label = ComponentLabels::kNone;
    bool suspect = false;
    const auto take = [&](Label other) {
        if (label == ComponentLabels::kNone) label = other;
        labels_.join(label, other);
    };
    part_.assign(1, first);
    cells_[first].label = kPending;
    for (std::size_t next = 0; next < part_.size(); ++next) {
        const DelaunayCell& cell = context.delaunay.cell(part_[next]);
        for (std::size_t i = 0; i < 4; ++i) {
            if (!open(part_[next], i)) continue;
            Cell& neighbor = cells_[cell.neighbor[i]];
            if (neighbor.label == kPending) continue;
            if ((neighbor.flags & kInfinite) != 0) {
                take(outside_);
                suspect = suspect || (beside_infinity_ && !infinity_met_);
                infinity_met_ = true;
            } else if (neighbor.born == context.step) {
                neighbor.label = kPending;
                part_.push_back(cell.neighbor[i]);
            } else {
                take(neighbor.label);
                suspect = suspect || neighbor.beside_dead == context.step;
                neighbor.beside_dead = 0;
            }
        }
    }
    if (label == ComponentLabels::kNone) label = labels_.make();
    for (const CellId id : part_) cells_[id].label = label;
    labels_.add(label, static_cast<std::uint32_t>(part_.size()));
    if (suspect) suspects_.push_back(first);
}

// Every piece that came off holds a cell, or all infinite cells, that a dead cell was joined to; or a part of the new
// cells that such a cell is joined to now.
void ComplementComponents::separate(const Context& context) {
    for (const CellId id : beside_) {
        if (cells_[id].beside_dead == context.step) suspects_.push_back(id);
    }
    if (beside_infinity_ && !infinity_met_) suspects_.push_back(infinite_cell_);
    if (suspects_.size() < 2) return;

    const auto label_of = [&](CellId id) -> Label& { return cells_[id].label; };
    const auto visit_neighbors = [&](CellId id, const auto& use) {
        const DelaunayCell& cell = context.delaunay.cell(id);
        for (std::size_t i = 0; i < 4; ++i) {
            if (open(id, i)) use(cell.neighbor[i]);
        }
    };
    const auto endless = [&](CellId id) { return (cells_[id].flags & kInfinite) != 0; };
    labels_.for_each_shared(suspects_, label_of, [&](std::span<const CellId> suspects) {
        search_.run(suspects, visit_neighbors, endless, [&](const auto& piece) { labels_.cut_off(piece, label_of); });
    });
}

std::uint64_t ComplementComponents::memory() const {
    return cells_.capacity() * sizeof(Cell) + labels_.memory() + search_.memory();
}

}  // namespace plateau
