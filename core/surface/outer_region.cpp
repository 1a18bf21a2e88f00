#include "surface/outer_region.h"

#include <numeric>

namespace plateau {

void OuterRegion::update(const Delaunay& delaunay, const DelaunayChange& change, const DelaunayFaces& faces,
                         const Peeling& peeling, bool all) {
    const Context context{delaunay, faces, peeling};
    ++now_;
    touched_.clear();
    flipped_.clear();
    const auto capacity = delaunay.cell_capacity();
    outer_.resize(capacity, 0);
    was_outer_.resize(capacity, 0);
    touched_at_.resize(capacity, 0);
    seen_at_.resize(capacity, 0);
    group_.resize(capacity, 0);
    born_at_.resize(capacity, 0);

    for (const CellId cell : change.born) {
        born_at_[cell] = now_;
        outer_[cell] = delaunay.cell(cell).finite(3) ? 0 : 1;
    }
    std::vector<CellId> stack;
    if (all) {
        for (const CellId cell : change.born) {
            if (outer(cell)) stack.push_back(cell);
        }
        flood(context, stack);
        return;
    }

    // Next to a cut: cells around the hole of the insertion, and both sides of facets that entered K.
    std::vector<CellId> suspects;
    const auto suspect = [&](CellId cell) {
        if (born_at_[cell] != now_ && outer(cell)) suspects.push_back(cell);
    };
    for (const CellId cell : change.born) {
        for (const CellId neighbor : delaunay.cell(cell).neighbor) suspect(neighbor);
    }
    for (const SimplexIndex triangle : peeling.entered()) {
        const auto facet = faces.facet(triangle);
        suspect(facet.cell);
        suspect(delaunay.cell(facet.cell).neighbor[static_cast<std::size_t>(facet.index)]);
    }
    find_enclosed(context, suspects);

    // Where an outer cell opens to one that is not: at the new cells and at facets that left K.
    const auto seed = [&](CellId cell, int index) {
        const CellId neighbor = delaunay.cell(cell).neighbor[static_cast<std::size_t>(index)];
        if (outer(cell) == outer(neighbor) || !context.open(cell, index)) return;
        stack.push_back(outer(cell) ? cell : neighbor);
    };
    for (const CellId cell : change.born) {
        for (int i = 0; i < 4; ++i) seed(cell, i);
    }
    for (const SimplexIndex triangle : peeling.left()) {
        const auto facet = faces.facet(triangle);
        const bool in_delaunay = delaunay.cell(facet.cell).alive && faces.triangle(facet.cell, facet.index) == triangle;
        if (in_delaunay) seed(facet.cell, facet.index);
    }
    flood(context, stack);
    for (const CellId cell : touched_) {
        if (born_at_[cell] != now_ && outer_[cell] != was_outer_[cell]) flipped_.push_back(cell);
    }
}

// Searches in turn from every suspect through outer and new cells. A part without a way to an infinite cell is
// enclosed.
void OuterRegion::find_enclosed(const Context& context, const std::vector<CellId>& suspects) {
    struct Group {
        std::vector<CellId> cells;  // a queue; `next` is its head
        std::size_t next = 0;
        bool reaches_infinity = false;
    };
    std::vector<Group> groups;
    std::vector<std::uint32_t> parent;
    const auto root = [&](std::uint32_t group) {
        while (parent[group] != group) group = parent[group] = parent[parent[group]];
        return group;
    };
    std::uint32_t open_groups = 0;  // neither exhausted nor known to reach infinity
    bool infinity_found = false;
    const auto settle = [&](Group& group) {
        group.reaches_infinity = true;
        infinity_found = true;
        --open_groups;
    };
    const auto visit = [&](CellId cell, std::uint32_t group) {
        seen_at_[cell] = now_;
        group_[cell] = group;
        groups[group].cells.push_back(cell);
        if (!groups[group].reaches_infinity && !context.delaunay.cell(cell).finite(3)) settle(groups[group]);
    };

    for (const CellId cell : suspects) {
        if (seen_at_[cell] == now_) continue;
        const auto group = static_cast<std::uint32_t>(groups.size());
        parent.push_back(group);
        groups.emplace_back();
        ++open_groups;
        visit(cell, group);
    }
    // The outer region was in one piece and every piece of the rest touches the cut, so the last group is the one that
    // reaches infinity if no other does.
    while (open_groups > (infinity_found ? 0u : 1u)) {
        for (std::uint32_t g = 0; g < groups.size(); ++g) {
            if (parent[g] != g || groups[g].reaches_infinity || groups[g].next == groups[g].cells.size()) continue;
            const CellId cell = groups[g].cells[groups[g].next++];
            std::uint32_t own = g;
            for (int i = 0; i < 4; ++i) {
                const CellId neighbor = context.delaunay.cell(cell).neighbor[static_cast<std::size_t>(i)];
                const bool passable = (born_at_[neighbor] == now_ || outer(neighbor)) && context.open(cell, i);
                if (!passable) continue;
                if (seen_at_[neighbor] != now_) {
                    visit(neighbor, own);
                    continue;
                }
                std::uint32_t other = root(group_[neighbor]);
                if (other == own) continue;
                if (groups[own].cells.size() > groups[other].cells.size()) std::swap(own, other);
                Group& into = groups[other];
                Group& from = groups[own];
                if (!into.reaches_infinity && !from.reaches_infinity) {
                    --open_groups;
                } else if (!into.reaches_infinity) {
                    settle(into);
                } else if (!from.reaches_infinity) {
                    --open_groups;
                }
                // Heads first, so that what was expanded stays before the head.
                into.cells.insert(into.cells.begin() + static_cast<std::ptrdiff_t>(into.next), from.cells.begin(),
                                  from.cells.begin() + static_cast<std::ptrdiff_t>(from.next));
                into.next += from.next;
                into.cells.insert(into.cells.end(), from.cells.begin() + static_cast<std::ptrdiff_t>(from.next),
                                  from.cells.end());
                from = {};
                parent[own] = other;
                own = other;
            }
            Group& group = groups[root(own)];
            if (!group.reaches_infinity && group.next == group.cells.size()) --open_groups;
            if (open_groups <= (infinity_found ? 0u : 1u)) break;
        }
    }
    for (std::uint32_t g = 0; g < groups.size(); ++g) {
        if (parent[g] != g || groups[g].reaches_infinity) continue;
        const bool exhausted = groups[g].next == groups[g].cells.size();
        for (const CellId cell : groups[g].cells) set_outer(cell, !exhausted);
    }
    for (const Group& group : groups) {
        if (!group.reaches_infinity) continue;
        for (const CellId cell : group.cells) set_outer(cell, true);
    }
}

void OuterRegion::flood(const Context& context, std::vector<CellId>& stack) {
    while (!stack.empty()) {
        const CellId cell = stack.back();
        stack.pop_back();
        for (int i = 0; i < 4; ++i) {
            const CellId neighbor = context.delaunay.cell(cell).neighbor[static_cast<std::size_t>(i)];
            if (outer(neighbor) || !context.open(cell, i)) continue;
            set_outer(neighbor, true);
            stack.push_back(neighbor);
        }
    }
}

void OuterRegion::set_outer(CellId cell, bool is_outer) {
    if (touched_at_[cell] != now_) {
        touched_at_[cell] = now_;
        was_outer_[cell] = outer_[cell];
        touched_.push_back(cell);
    }
    outer_[cell] = is_outer ? 1 : 0;
}

}  // namespace plateau
