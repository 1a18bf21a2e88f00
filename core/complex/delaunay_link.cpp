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
    steps_.clear();
    place_.resize(step + std::size_t{1});
    const auto corners = static_cast<std::size_t>(change.dimension) + 1;
    for (const CellId id : change.born) {
        const DelaunayCell& cell = delaunay.cell(id);
        for (std::size_t i = 0; i < corners; ++i) {
            const Step landmark = cell.vertex[i];
            if (landmark == kInfiniteVertex || landmark == step || place_[landmark].step == step) continue;
            place_[landmark].step = step;
            steps_.push_back(landmark);
        }
    }
    std::sort(steps_.begin(), steps_.end());
    for (const Step landmark : steps_) {
        place_[landmark].place = static_cast<std::uint32_t>(vertices_.size());
        vertices_.push_back({landmark});
    }
    if (change.dimension < 2) return;

    reserve_edges(3 * change.born.size());
    for (const CellId id : change.born) {
        const DelaunayCell& cell = delaunay.cell(id);
        if (!cell.finite(change.dimension)) continue;
        std::array<std::uint32_t, 3> vertex{};
        std::size_t count = 0;
        for (std::size_t i = 0; i < corners; ++i) {
            if (cell.vertex[i] != step) vertex[count++] = place_[cell.vertex[i]].place;
        }
        sort_few(vertex.data(), count);
        // The cell behind the link is older than p, unless D(L) has just become a cone over itself.
        const int apex = cell.index_of_vertex(step);
        const CellId behind = cell.neighbor[static_cast<std::size_t>(apex)];
        const DelaunayCell& old = delaunay.cell(behind);
        const auto base_edge = [&](std::uint32_t a, std::uint32_t b) {
            const std::array<Step, 2> tuple{vertices_[a].step, vertices_[b].step};
            if (change.dimension_rose) return tables[0].find(tuple);
            return faces.edge(behind, static_cast<std::size_t>(old.index_of_vertex(tuple[0])),
                              static_cast<std::size_t>(old.index_of_vertex(tuple[1])));
        };
        const auto edge_of = [&](std::uint32_t a, std::uint32_t b) {
            const std::uint32_t known = edge(a, b);
            if (known != kNone) return known;
            const std::uint32_t place = add_edge(a, b);
            edges_[place].base = base_edge(a, b);
            return place;
        };
        if (count == 2) {
            edge_of(vertex[0], vertex[1]);
            continue;
        }
        Triangle triangle;
        triangle.vertex = vertex;
        triangle.edge = {edge_of(vertex[1], vertex[2]), edge_of(vertex[0], vertex[2]), edge_of(vertex[0], vertex[1])};
        if (change.dimension_rose) {
            const std::array<Step, 3> tuple{vertices_[vertex[0]].step, vertices_[vertex[1]].step,
                                            vertices_[vertex[2]].step};
            triangle.base = tables[1].find(tuple);
        } else {
            triangle.base = faces.triangle(behind, old.index_of_neighbor(id));
        }
        const auto place = static_cast<std::uint32_t>(triangles_.size());
        for (const std::uint32_t e : triangle.edge) {
            auto& around = edges_[e].triangle;
            around[around[0] == kNone ? 0 : 1] = place;
        }
        triangles_.push_back(triangle);
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

std::uint32_t DelaunayLink::add_edge(std::uint32_t a, std::uint32_t b) {
    const auto place = static_cast<std::uint32_t>(edges_.size());
    std::size_t slot = hash(a, b);
    while (slots_[slot].step == step_) slot = (slot + 1) & mask_;
    slots_[slot] = {step_, place};
    edges_.push_back({a, b});
    for (std::size_t track = 0; track < kMaxTracks; ++track) {
        vertices_[a].waiting[track] |= std::uint64_t{1} << (b % 64);
        vertices_[b].waiting[track] |= std::uint64_t{1} << (a % 64);
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
