#include "inspect/surface_place.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "delaunay/predicates.h"

namespace plateau {

namespace {

using Triangle = std::span<const Step>;

/// The largest set of triangles without sharp edges, by deleting what hangs on one until none is left.
class KeptTriangles {
public:
    KeptTriangles(std::vector<Triangle> triangles, const LandmarkPoints& points)
        : triangles_(std::move(triangles)), points_(&points), kept_(triangles_.size(), true) {
        for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
            for (std::size_t corner = 0; corner < 3; ++corner) sides_.push_back({edge(t, corner), t});
        }
        std::sort(sides_.begin(), sides_.end());
        std::vector<Edge> pending;
        for (const Side& side : sides_) pending.push_back(side.edge);
        while (!pending.empty()) {
            const Edge next = pending.back();
            pending.pop_back();
            if (!is_sharp(next)) continue;
            for_each_at(next, [&](std::uint32_t t) {
                kept_[t] = false;
                for (std::size_t corner = 0; corner < 3; ++corner) pending.push_back(edge(t, corner));
            });
        }
    }

    /// Whether one of them has all vertices of the simplex.
    bool have(std::span<const Step> simplex) const {
        for (std::size_t t = 0; t < triangles_.size(); ++t) {
            const Triangle triangle = triangles_[t];
            if (kept_[t] && std::includes(triangle.begin(), triangle.end(), simplex.begin(), simplex.end())) {
                return true;
            }
        }
        return false;
    }

private:
    using Edge = std::array<Step, 2>;
    struct Side {
        Edge edge;
        std::uint32_t triangle;
        bool operator<(const Side& other) const {
            return edge != other.edge ? edge < other.edge : triangle < other.triangle;
        }
    };

    Edge edge(std::uint32_t triangle, std::size_t corner) const {
        const Triangle t = triangles_[triangle];
        return {t[corner == 0 ? 1 : 0], t[corner == 2 ? 1 : 2]};
    }
    template <class Use>
    void for_each_at(const Edge& edge, const Use& use) const {
        for (auto side = std::lower_bound(sides_.begin(), sides_.end(), Side{edge, 0});
             side != sides_.end() && side->edge == edge; ++side) {
            if (kept_[side->triangle]) use(side->triangle);
        }
    }
    bool is_sharp(const Edge& edge) const {
        std::vector<Step> thirds;
        for_each_at(edge, [&](std::uint32_t t) {
            for (const Step vertex : triangles_[t]) {
                if (vertex != edge[0] && vertex != edge[1]) thirds.push_back(vertex);
            }
        });
        const LandmarkPoints& at = *points_;
        for (std::size_t i = 0; i < thirds.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                if (sign_of_wedge(at[edge[0]], at[edge[1]], at[thirds[i]], at[thirds[j]]) < 0) return false;
            }
        }
        return true;
    }

    std::vector<Triangle> triangles_;
    const LandmarkPoints* points_;
    std::vector<bool> kept_;
    std::vector<Side> sides_;
};

}  // namespace

SurfacePlace surface_place(const Timeline& timeline, const LandmarkPoints& points, double rho, Step step,
                           std::span<const Step> simplex) {
    const auto has = [&](Triangle triangle) {
        return std::includes(triangle.begin(), triangle.end(), simplex.begin(), simplex.end());
    };
    if (timeline.shown_family[step - 1] != Family::Surface) return SurfacePlace::NoSurface;
    if (simplex.size() > 3) return SurfacePlace::Solid;
    const SimplexTable& table = timeline.table(2);
    for (const std::uint32_t row : timeline.surface_rows(step)) {
        if (has(table.tuple(timeline.surface[row].triangle))) return SurfacePlace::On;
    }
    std::vector<Triangle> allowed;
    bool has_triangle = false;
    bool has_allowed = false;
    for (const SimplexIndex index : timeline.living(2, 0, step)) {
        const Triangle triangle = table.tuple(index);
        const bool is_too_long =
            rho > 0 && radius_edge_ratio_exceeds(rho, points[triangle[0]], points[triangle[1]], points[triangle[2]]);
        if (!is_too_long) allowed.push_back(triangle);
        if (!has(triangle)) continue;
        has_triangle = true;
        has_allowed = has_allowed || !is_too_long;
    }
    if (!has_triangle) return SurfacePlace::Bare;
    if (!has_allowed) return SurfacePlace::TooLong;
    const KeptTriangles kept(std::move(allowed), points);
    return kept.have(simplex) ? SurfacePlace::Inside : SurfacePlace::Peeled;
}

}  // namespace plateau
