#include "homology/surface_betti.h"

namespace plateau {

void SurfaceBetti::update(const SurfaceTracker& surface, std::uint32_t rows) {
    components_.resize(rows);
    for (; rows_ < rows; ++rows_) components_.add_node(rows_);
    for (const std::uint32_t row : surface.ended_rows()) components_.remove_node(row);
    for (const GlueChange& change : surface.glue_changes()) {
        if (change.begins) {
            components_.add_edge(change.row_a, change.row_b);
        } else {
            components_.remove_edge(change.row_a, change.row_b);
        }
    }
    components_.settle([&](std::uint32_t row, const auto& use) {
        for (std::uint32_t corner = 0; corner < 3; ++corner) use(surface.partner(row, corner));
    });
    // 3 T = 2 E on a closed surface.
    const auto euler = std::int64_t{surface.vertex_count()} - std::int64_t{surface.triangle_count()} / 2;
    beta1_ = static_cast<std::uint32_t>(2 * std::int64_t{components_.count()} - euler);
}

}  // namespace plateau
