#include "surface/outer_region.h"

namespace plateau {

void OuterRegion::update(Step step, const Delaunay& delaunay, const DelaunayChange& change, const DelaunayFaces& faces,
                         const Peeling& peeling, bool all) {
    const Context context{step, delaunay, change, faces, peeling};
    touched_.clear();
    flipped_.clear();
    stack_.clear();
    cells_.resize(delaunay.cell_capacity());
    components_.resize(delaunay.cell_capacity() + std::size_t{1});
    if (all) {
        components_.add_node(kOutside);
    } else {
        remove_died(context);
    }
    add_born(context);
    if (!all) change_facets(context);

    const auto visit_neighbors = [&](Node one, const auto& use) {
        for (int i = 0; i < 4; ++i) {
            const CellId neighbor = delaunay.cell(one - 1).neighbor[static_cast<std::size_t>(i)];
            if (context.open(one - 1, i)) use(node(neighbor));
        }
    };
    components_.settle(visit_neighbors, [&](const auto& visit_piece) {
        visit_piece([&](Node one) { set_outer(one - 1, false, step); });
    });
    flood(context);
    for (const CellId cell : touched_) {
        if (cells_[cell].outer != cells_[cell].was_outer) flipped_.push_back(cell);
    }
}

void OuterRegion::remove_died(const Context& context) {
    for (const CellId id : context.change.died) {
        if (!cells_[id].infinite) components_.remove_node(node(id));
        for (int i = 0; i < 4; ++i) {
            const CellId neighbor = context.delaunay.cell(id).neighbor[static_cast<std::size_t>(i)];
            const bool seen = neighbor < id && !context.delaunay.cell(neighbor).alive;  // from its other side
            if (!seen && context.was_open(id, i)) components_.remove_edge(node(id), node(neighbor));
        }
    }
}

void OuterRegion::add_born(const Context& context) {
    for (const CellId id : context.change.born) {
        const bool infinite = !context.delaunay.cell(id).finite(3);
        cells_[id] = {context.step, 0, infinite, infinite, infinite};
        if (!infinite) components_.add_node(node(id));
    }
    for (const CellId id : context.change.born) {
        for (int i = 0; i < 4; ++i) {
            const CellId neighbor = context.delaunay.cell(id).neighbor[static_cast<std::size_t>(i)];
            if (!context.open(id, i)) continue;
            const bool seen = neighbor < id && cells_[neighbor].born == context.step;
            if (!seen) components_.add_edge(node(id), node(neighbor));
            if (outer(neighbor)) stack_.push_back(neighbor);
        }
    }
}

// Facets between cells that stay.
void OuterRegion::change_facets(const Context& context) {
    const auto stays = [&](CellId cell) { return cells_[cell].born != context.step; };
    const auto visit = [&](SimplexIndex triangle, const auto& use) {
        const auto facet = context.faces.facet_in(context.delaunay, triangle);
        if (!facet) return;
        const CellId neighbor = context.delaunay.cell(facet->cell).neighbor[static_cast<std::size_t>(facet->index)];
        if (stays(facet->cell) && stays(neighbor)) use(facet->cell, neighbor);
    };
    for (const SimplexIndex triangle : context.peeling.entered()) {
        visit(triangle, [&](CellId a, CellId b) { components_.remove_edge(node(a), node(b)); });
    }
    for (const SimplexIndex triangle : context.peeling.left()) {
        visit(triangle, [&](CellId a, CellId b) {
            components_.add_edge(node(a), node(b));
            if (outer(a)) stack_.push_back(a);
            if (outer(b)) stack_.push_back(b);
        });
    }
}

void OuterRegion::flood(const Context& context) {
    while (!stack_.empty()) {
        const CellId cell = stack_.back();
        stack_.pop_back();
        if (!outer(cell)) continue;  // it was cut off at this step
        for (int i = 0; i < 4; ++i) {
            const CellId neighbor = context.delaunay.cell(cell).neighbor[static_cast<std::size_t>(i)];
            if (outer(neighbor) || !context.open(cell, i)) continue;
            set_outer(neighbor, true, context.step);
            stack_.push_back(neighbor);
        }
    }
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
