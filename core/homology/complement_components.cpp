#include "homology/complement_components.h"

namespace plateau {

void ComplementComponents::update(Step step, const std::vector<SimplexTable>& tables, std::span<const Death> deaths,
                                  const Delaunay& delaunay, const DelaunayChange& change, const DelaunayFaces& faces) {
    const Context context{step, tables, delaunay, change, faces};
    flags_.resize(delaunay.cell_capacity(), 0);
    components_.resize(delaunay.cell_capacity() + std::size_t{1});
    if (started_) {
        remove_died(context);
    } else {
        components_.add_node(kOutside);
    }
    add_born(context);
    if (started_) open_deaths(context, deaths);
    started_ = true;
    components_.settle([&](Node one, const auto& use) {
        const DelaunayCell& cell = delaunay.cell(one - 1);
        for (std::size_t i = 0; i < 4; ++i) {
            if (open(one - 1, i)) use(node(cell.neighbor[i]));
        }
    });
}

void ComplementComponents::remove_died(const Context& context) {
    for (const CellId id : context.change.died) {
        if (solid(id)) continue;
        if (node(id) != kOutside) components_.remove_node(node(id));
        for (std::size_t i = 0; i < 4; ++i) {
            const CellId neighbor = context.delaunay.cell(id).neighbor[i];
            const bool seen = neighbor < id && !context.delaunay.cell(neighbor).alive;  // from its other side
            if (open(id, i) && !seen) components_.remove_edge(node(id), node(neighbor));
        }
    }
}

// What lost its last witness but is still in D(L).
void ComplementComponents::open_deaths(const Context& context, std::span<const Death> deaths) {
    for (const Death& death : deaths) {
        if (death.track != track_ || death.dimension == 1) continue;
        if (death.dimension == 3) {
            const CellId cell = context.faces.cell(death.simplex);
            const bool there = context.delaunay.cell(cell).alive && context.faces.tetrahedron(cell) == death.simplex;
            if (!there) continue;
            flags_[cell] &= static_cast<std::uint8_t>(~kSolid);
            components_.add_node(node(cell));
        } else {
            const auto facet = context.faces.facet_in(context.delaunay, death.simplex);
            if (!facet) continue;
            const auto [cell, index] = *facet;
            const CellId neighbor = context.delaunay.cell(cell).neighbor[static_cast<std::size_t>(index)];
            const int mirror = context.delaunay.cell(neighbor).index_of_neighbor(cell);
            flags_[cell] &= static_cast<std::uint8_t>(~(1u << index));
            flags_[neighbor] &= static_cast<std::uint8_t>(~(1u << mirror));
            components_.add_edge(node(cell), node(neighbor));
        }
    }
}

void ComplementComponents::add_born(const Context& context) {
    const auto lives = [&](int dimension, SimplexIndex simplex) {
        return simplex != kNoSimplex &&
               context.tables[static_cast<std::size_t>(dimension - 1)].death[track_][simplex] == kNever;
    };
    for (const CellId id : context.change.born) {
        std::uint32_t flags = 0;
        if (!context.delaunay.cell(id).finite(3)) flags = kInfinite;
        if (lives(3, context.faces.tetrahedron(id))) flags = kSolid;
        for (int i = 0; i < 4; ++i) {
            if (lives(2, context.faces.triangle(id, i))) flags |= 1u << i;
        }
        flags_[id] = static_cast<std::uint8_t>(flags);
        if (flags < kSolid) components_.add_node(node(id));
    }
    for (const CellId id : context.change.born) {
        if (solid(id)) continue;
        for (std::size_t i = 0; i < 4; ++i) {
            const DelaunayCell& cell = context.delaunay.cell(id);
            const CellId neighbor = cell.neighbor[i];
            const bool is_new = cell.vertex[i] != context.step || context.change.dimension_rose;
            const bool seen = neighbor < id && is_new;  // from its other side
            if (open(id, i) && !seen) components_.add_edge(node(id), node(neighbor));
        }
    }
}

}  // namespace plateau
