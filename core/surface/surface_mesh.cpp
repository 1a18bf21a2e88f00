#include "surface/surface_mesh.h"

#include <algorithm>
#include <numeric>

#include "surface/gluing.h"

namespace plateau {

namespace {

struct RowEdge {
    Step u = 0, v = 0;
    EdgeSide side;
};

// The sides of the given rows at their edges, those of one edge next to each other.
std::vector<RowEdge> sorted_row_edges(const Timeline& timeline, const std::vector<std::uint32_t>& rows) {
    std::vector<RowEdge> edges;
    for (std::uint32_t index = 0; index < rows.size(); ++index) {
        const SurfaceRow& row = timeline.surface[rows[index]];
        const auto tuple = timeline.table(2).tuple(row.triangle);
        for (std::uint32_t corner = 0; corner < 3; ++corner) {
            const Step u = tuple[corner == 0 ? 1 : 0];
            const Step v = tuple[corner == 2 ? 1 : 2];
            edges.push_back({u, v, {index, corner, tuple[corner], runs_forward(row.side, corner)}});
        }
    }
    std::sort(edges.begin(), edges.end(), [](const RowEdge& a, const RowEdge& b) {
        if (a.u != b.u) return a.u < b.u;
        if (a.v != b.v) return a.v < b.v;
        return a.side.row < b.side.row;
    });
    return edges;
}

// Union-find over the corners of the rows: corners that are glued are one mesh vertex.
class Corners {
public:
    explicit Corners(std::size_t rows) : parent_(3 * rows) { std::iota(parent_.begin(), parent_.end(), 0u); }
    std::uint32_t find(std::uint32_t corner) {
        while (parent_[corner] != corner) corner = parent_[corner] = parent_[parent_[corner]];
        return corner;
    }
    void unite(std::uint32_t a, std::uint32_t b) { parent_[find(a)] = find(b); }

private:
    std::vector<std::uint32_t> parent_;
};

}  // namespace

SurfaceMesh surface_mesh(const PointCloud& cloud, const Timeline& timeline, Step step) {
    const LandmarkPoints points{&cloud, &timeline.landmarks};
    const auto rows = timeline.surface_rows(step);
    const auto edges = sorted_row_edges(timeline, rows);
    Corners corners(rows.size());
    for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
        std::vector<EdgeSide> sides;
        for (end = begin; end < edges.size() && edges[end].u == edges[begin].u && edges[end].v == edges[begin].v;
             ++end) {
            sides.push_back(edges[end].side);
        }
        for (const auto& [i, j] : pair_sides(sides, edges[begin].u, edges[begin].v, points)) {
            // Places of u and v in each tuple: the two that are not the corner, in order.
            const auto place = [](const EdgeSide& side, std::uint32_t which) {
                const std::uint32_t low = side.corner == 0 ? 1 : 0;
                const std::uint32_t high = side.corner == 2 ? 1 : 2;
                return 3 * side.row + (which == 0 ? low : high);
            };
            for (const std::uint32_t which : {0u, 1u}) corners.unite(place(sides[i], which), place(sides[j], which));
        }
    }

    SurfaceMesh mesh;
    constexpr std::uint32_t kUnnumbered = 0xFFFFFFFFu;
    std::vector<std::uint32_t> number(3 * rows.size(), kUnnumbered);
    for (std::uint32_t index = 0; index < rows.size(); ++index) {
        const SurfaceRow& row = timeline.surface[rows[index]];
        const auto tuple = timeline.table(2).tuple(row.triangle);
        std::array<std::uint32_t, 3> triangle{};
        for (std::uint32_t corner = 0; corner < 3; ++corner) {
            std::uint32_t& vertex = number[corners.find(3 * index + corner)];
            if (vertex == kUnnumbered) {
                vertex = static_cast<std::uint32_t>(mesh.vertex_landmark.size());
                mesh.vertex_landmark.push_back(tuple[corner]);
            }
            triangle[corner] = vertex;
        }
        if (row.side == 1) std::swap(triangle[1], triangle[2]);
        mesh.triangles.push_back(triangle);
    }
    return mesh;
}

}  // namespace plateau
