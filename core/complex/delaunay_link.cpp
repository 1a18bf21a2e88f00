#include "complex/delaunay_link.h"

#include <algorithm>

#include "base/few.h"
#include "complex/delaunay_faces.h"

namespace plateau {

void DelaunayLink::build(Step step, const Delaunay& delaunay, const DelaunayChange& change, const DelaunayFaces& faces,
                         const std::vector<SimplexTable>& tables) {
    step_ = step;
    vertices_.clear();
    edges_.clear();
    triangles_.clear();
    collect_vertices(delaunay, change);
    if (change.dimension < 2) return;
    reserve_edges(3 * change.born.size());
    if (change.dimension == 2) {
        build_flat(delaunay, change, faces, tables);
    } else {
        build_spatial(delaunay, change, faces, tables);
    }
}

void DelaunayLink::collect_vertices(const Delaunay& delaunay, const DelaunayChange& change) {
    steps_.clear();
    place_.resize(step_ + std::size_t{1});
    const auto corners = static_cast<std::size_t>(change.dimension) + 1;
    for (const CellId id : change.born) {
        const DelaunayCell& cell = delaunay.cell(id);
        for (std::size_t i = 0; i < corners; ++i) {
            const Step landmark = cell.vertex[i];
            if (landmark == kInfiniteVertex || landmark == step_ || place_[landmark].step == step_) continue;
            place_[landmark].step = step_;
            steps_.push_back(landmark);
        }
    }
    std::sort(steps_.begin(), steps_.end());
    for (const Step landmark : steps_) {
        place_[landmark].place = static_cast<std::uint32_t>(vertices_.size());
        vertices_.push_back({landmark});
    }
}

// The cell behind the link is older than p and knows its faces, unless D(L) has just become a cone over itself.
void DelaunayLink::build_flat(const Delaunay& delaunay, const DelaunayChange& change, const DelaunayFaces& faces,
                              const std::vector<SimplexTable>& tables) {
    for (const CellId id : change.born) {
        const DelaunayCell& cell = delaunay.cell(id);
        if (!cell.finite(2)) continue;
        const auto apex = static_cast<std::size_t>(cell.index_of_vertex(step_));
        const std::size_t i = apex == 0 ? 1 : 0;
        const std::size_t j = 3 - apex - i;
        const std::array<Step, 2> tuple{std::min(cell.vertex[i], cell.vertex[j]),
                                        std::max(cell.vertex[i], cell.vertex[j])};
        SimplexIndex& base = edges_[find_or_add_edge(vertex(tuple[0]), vertex(tuple[1]))].base;
        if (change.dimension_rose) {
            base = tables[0].find(tuple);
        } else {
            const CellId behind = cell.neighbor[apex];
            const DelaunayCell& old = delaunay.cell(behind);
            base = faces.edge(behind, static_cast<std::size_t>(old.index_of_vertex(tuple[0])),
                              static_cast<std::size_t>(old.index_of_vertex(tuple[1])));
        }
    }
}

void DelaunayLink::build_spatial(const Delaunay& delaunay, const DelaunayChange& change, const DelaunayFaces& faces,
                                 const std::vector<SimplexTable>& tables) {
    for (const CellId id : change.born) {
        const DelaunayCell& cell = delaunay.cell(id);
        if (change.dimension_rose && !cell.finite(3)) continue;  // it need not contain p
        const auto t = static_cast<std::uint32_t>(triangles_.size());
        Triangle& triangle = triangles_.emplace_back();
        triangle.apex = static_cast<std::uint8_t>(cell.index_of_vertex(step_));
        std::array<std::uint64_t, 3> corners{};  // place and corner of the cell; infinity is the last
        for (std::size_t j = 0, i = 0; j < 3; ++i) {
            if (i != triangle.apex) corners[j++] = std::uint64_t{vertex(cell.vertex[i])} << 2 | i;
        }
        sort_three(corners);

        const CellId behind = cell.neighbor[triangle.apex];
        const DelaunayCell& old = delaunay.cell(behind);
        std::array<std::size_t, 3> corner_behind{};
        for (std::size_t j = 0; j < 3; ++j) {
            triangle.vertex[j] = static_cast<std::uint32_t>(corners[j] >> 2);
            triangle.corner[j] = static_cast<std::uint8_t>(corners[j] & 3u);
            corner_behind[j] = static_cast<std::size_t>(old.index_of_vertex(cell.vertex[triangle.corner[j]]));
        }
        const auto tuple_of = [&](std::size_t j) { return cell.vertex[triangle.corner[j]]; };
        for (std::size_t lacking = 0; lacking < 3; ++lacking) {
            const std::size_t i = lacking == 0 ? 1 : 0;
            const std::size_t j = lacking == 2 ? 1 : 2;
            if (triangle.vertex[j] == kNone) {
                triangle.edge[lacking] = kNone;
                continue;
            }
            const std::uint32_t place = find_or_add_edge(triangle.vertex[i], triangle.vertex[j]);
            triangle.edge[lacking] = place;
            Edge& edge = edges_[place];
            if (edge.triangle[0] != kNone) {
                edge.triangle[1] = t;
                continue;
            }
            edge.triangle[0] = t;
            edge.base = change.dimension_rose ? tables[0].find(std::array{tuple_of(i), tuple_of(j)})
                                              : faces.edge(behind, corner_behind[i], corner_behind[j]);
        }
        if (!change.dimension_rose) {
            triangle.base = faces.triangle(behind, old.index_of_neighbor(id));
        } else {
            triangle.base = tables[1].find(std::array{tuple_of(0), tuple_of(1), tuple_of(2)});
        }
    }
}

std::uint32_t DelaunayLink::triangle(std::uint32_t edge, std::uint32_t third) const {
    if (edge == kNone) return kNone;
    const Edge& base = edges_[edge];
    for (const std::uint32_t place : base.triangle) {
        if (place == kNone) continue;
        const auto& vertex = triangles_[place].vertex;
        // The vertices sum up, so the third is what a and b leave.
        if (vertex[0] + vertex[1] + vertex[2] - base.a - base.b == third) return place;
    }
    return kNone;
}

// With a < b.
std::uint32_t DelaunayLink::find_or_add_edge(std::uint32_t a, std::uint32_t b) {
    std::size_t slot = hash(a, b);
    for (; slots_[slot].step == step_; slot = (slot + 1) & mask_) {
        const Edge& known = edges_[slots_[slot].place];
        if (known.a == a && known.b == b) return slots_[slot].place;
    }
    const auto place = static_cast<std::uint32_t>(edges_.size());
    slots_[slot] = {step_, place};
    edges_.push_back({a, b});
    for (std::size_t track = 0; track < kMaxTracks; ++track) {
        vertices_[a].waiting[track] |= bit(b);
        vertices_[b].waiting[track] |= bit(a);
    }
    return place;
}

void DelaunayLink::reserve_edges(std::size_t count) {
    std::size_t size = slots_.size() < 256 ? 256 : slots_.size();
    while (size < 2 * count) size *= 2;
    if (size != slots_.size()) slots_.assign(size, {});
    mask_ = size - 1;
}

}  // namespace plateau
