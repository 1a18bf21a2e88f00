#include "surface/gluing.h"

#include "delaunay/predicates.h"

namespace plateau {

std::vector<std::pair<std::uint32_t, std::uint32_t>> pair_sides(std::span<const EdgeSide> sides, Step u, Step v,
                                                                const LandmarkPoints& points) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    const auto count = static_cast<std::uint32_t>(sides.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        if (!sides[i].forward) continue;
        const Step x = sides[i].third;
        // Turning from x about the axis u -> v, counter-clockwise: is y met before z?
        const auto before = [&](Step y, Step z) {
            const int half_y = orientation(points[u], points[v], points[x], points[y]) > 0 ? 0 : 1;
            const int half_z = orientation(points[u], points[v], points[x], points[z]) > 0 ? 0 : 1;
            // A triangle opposite to x (angle pi) opens the second half; x itself closes it (angle 2 pi).
            if (half_y != half_z) return half_y < half_z;
            if (y == x || z == x) return z == x;
            return orientation(points[u], points[v], points[y], points[z]) > 0;
        };
        std::uint32_t best = count;
        for (std::uint32_t j = 0; j < count; ++j) {
            if (sides[j].forward) continue;
            if (best == count || before(sides[j].third, sides[best].third)) best = j;
            if (count == 2) break;
        }
        if (best != count) pairs.emplace_back(i, best);
    }
    return pairs;
}

}  // namespace plateau
