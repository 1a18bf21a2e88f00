#include "homology/surface_betti.h"

namespace plateau {

void SurfaceBetti::update(const SurfaceTracker& surface, std::uint32_t rows) {
    while (label_.size() < rows) {
        label_.push_back(labels_.make());
        labels_.add(label_.back());
    }
    search_.resize(rows);
    for (const GlueChange& change : surface.glue_changes()) {
        if (change.begins) labels_.join(label_[change.row_a], label_[change.row_b]);
    }
    for (const std::uint32_t row : surface.ended_rows()) {
        labels_.remove(label_[row]);
        label_[row] = ComponentLabels::kNone;
    }
    // Every piece that came off holds a row that lost a partner.
    suspects_.clear();
    for (const GlueChange& change : surface.glue_changes()) {
        if (change.begins) continue;
        for (const std::uint32_t row : {change.row_a, change.row_b}) {
            if (label_[row] != ComponentLabels::kNone) suspects_.push_back(row);
        }
    }
    const auto label_of = [&](std::uint32_t row) -> ComponentLabels::Label& { return label_[row]; };
    const auto visit_neighbors = [&](std::uint32_t row, const auto& use) {
        for (std::uint32_t corner = 0; corner < 3; ++corner) use(surface.partner(row, corner));
    };
    const auto endless = [](std::uint32_t) { return false; };
    labels_.for_each_shared(suspects_, label_of, [&](std::span<const std::uint32_t> suspects) {
        search_.run(suspects, visit_neighbors, endless, [&](const auto& piece) { labels_.cut_off(piece, label_of); });
    });
    // 3 T = 2 E on a closed surface.
    const auto euler = std::int64_t{surface.vertex_count()} - std::int64_t{surface.triangle_count()} / 2;
    beta1_ = static_cast<std::uint32_t>(2 * std::int64_t{labels_.count()} - euler);
}

std::uint64_t SurfaceBetti::memory() const {
    return label_.capacity() * sizeof(label_[0]) + labels_.memory() + search_.memory();
}

}  // namespace plateau
