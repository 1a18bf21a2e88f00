#include "surface/outer_region.h"

namespace plateau {

bool OuterRegion::update(Step step, const Delaunay& delaunay, const DelaunayChange& change, const DelaunayFaces& faces,
                         const Peeling& peeling, bool all, Slice& slice) {
    const Context context{step, delaunay, change, faces, peeling};
    if (!begun_) begin(context, all);
    begun_ = true;
    if (!flood(context, slice)) return false;
    begun_ = false;
    for (const CellId cell : touched_) {
        if (cells_[cell].outer != cells_[cell].was_outer) flipped_.push_back(cell);
    }
    return true;
}

void OuterRegion::begin(const Context& context, bool all) {
    touched_.clear();
    flipped_.clear();
    stack_.clear();
    suspects_.clear();
    cells_.grow(context.delaunay.cell_capacity());
    search_.resize(context.delaunay.cell_capacity() + std::size_t{1});
    const bool may_cut_off = !all && !context.peeling.entered().empty();
    if (may_cut_off) suspect_around_died(context);
    add_born(context);
    if (!all) change_facets(context);
    if (!may_cut_off) return;

    const auto visit_neighbors = [&](Node one, const auto& use) {
        for (int i = 0; i < 4; ++i) {
            if (!closed(one - 1, i)) use(node(context.delaunay.cell(one - 1).neighbor[static_cast<std::size_t>(i)]));
        }
    };
    search_.run(suspects_, visit_neighbors, kOutside, [&](const auto& visit_piece) {
        visit_piece([&](Node one) { set_outer(one - 1, false, context.step); });
    });
}

// Where infinite cells died others stay beside them, since a landmark never sees the whole hull: so the outside is
// among the suspects when it has to be.
void OuterRegion::suspect_around_died(const Context& context) {
    for (const CellId id : context.change.died) {
        if (!outer(id)) continue;
        for (int i = 0; i < 4; ++i) {
            const CellId neighbor = context.delaunay.cell(id).neighbor[static_cast<std::size_t>(i)];
            if (!closed(id, i) && context.delaunay.cell(neighbor).alive) suspects_.push_back(node(neighbor));
        }
    }
}

void OuterRegion::add_born(const Context& context) {
    for (const CellId id : context.change.born) {
        const bool infinite = !context.delaunay.cell(id).finite(3);
        cells_[id] = {context.step, 0, 0, infinite, infinite, infinite};
        for (int i = 0; i < 4; ++i) {
            const SimplexIndex triangle = context.faces.triangle(id, i);
            if (triangle != kNoSimplex && context.peeling.kept(triangle)) close(id, i, true);
        }
    }
    for (const CellId id : context.change.born) {
        for (int i = 0; i < 4; ++i) {
            const CellId neighbor = context.delaunay.cell(id).neighbor[static_cast<std::size_t>(i)];
            if (!closed(id, i) && outer(neighbor)) stack_.push_back(neighbor);
        }
    }
}

void OuterRegion::change_facets(const Context& context) {
    const auto visit = [&](SimplexIndex triangle, bool closes) {
        const auto facet = context.faces.facet_in(context.delaunay, triangle);
        if (!facet) return;
        const CellId a = facet->cell;
        const CellId b = context.delaunay.cell(a).neighbor[static_cast<std::size_t>(facet->index)];
        close(a, facet->index, closes);
        close(b, context.delaunay.cell(b).index_of_neighbor(a), closes);
        for (const CellId cell : {a, b}) {
            if (!outer(cell)) continue;
            if (closes) {
                suspects_.push_back(node(cell));
            } else {
                stack_.push_back(cell);
            }
        }
    };
    for (const SimplexIndex triangle : context.peeling.entered()) visit(triangle, true);
    for (const SimplexIndex triangle : context.peeling.left()) visit(triangle, false);
}

bool OuterRegion::flood(const Context& context, Slice& slice) {
    while (!stack_.empty()) {
        if (slice.used_up()) return false;
        const CellId cell = stack_.back();
        stack_.pop_back();
        if (!outer(cell)) continue;  // it was cut off at this step
        for (int i = 0; i < 4; ++i) {
            const CellId neighbor = context.delaunay.cell(cell).neighbor[static_cast<std::size_t>(i)];
            if (closed(cell, i) || outer(neighbor)) continue;
            set_outer(neighbor, true, context.step);
            stack_.push_back(neighbor);
        }
    }
    return true;
}

void OuterRegion::close(CellId cell, int index, bool closed) {
    const auto bit = static_cast<std::uint8_t>(1u << index);
    std::uint8_t& bits = cells_[cell].closed;
    bits = static_cast<std::uint8_t>(closed ? bits | bit : bits & ~bit);
}

void OuterRegion::set_outer(CellId id, bool is_outer, Step step) {
    Cell& cell = cells_[id];
    if (cell.touched != step && cell.born != step) {
        cell.touched = step;
        cell.was_outer = cell.outer;
        touched_.push_back(id);
    }
    cell.outer = is_outer;
}

}  // namespace plateau
