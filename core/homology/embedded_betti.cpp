#include "homology/embedded_betti.h"

namespace plateau {

void EmbeddedBetti::update(Step step, const std::vector<SimplexTable>& tables, std::span<const Death> deaths,
                           const Delaunay& delaunay, const DelaunayChange& change, const DelaunayFaces& faces) {
    counts_.update(step, tables, deaths);
    dimension_ = change.dimension;
    skeleton_.update(step, tables[0], deaths);
    if (dimension_ == 3) complement_.update(step, tables, deaths, delaunay, change, faces);
}

std::array<std::uint32_t, 3> EmbeddedBetti::numbers() const {
    const std::int64_t beta0 = skeleton_.count();
    const std::int64_t beta2 = dimension_ == 3 ? std::int64_t{complement_.count()} - 1 : 0;
    return {static_cast<std::uint32_t>(beta0), static_cast<std::uint32_t>(beta0 + beta2 - counts_.euler()),
            static_cast<std::uint32_t>(beta2)};
}

}  // namespace plateau
