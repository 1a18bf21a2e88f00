#include "homology/surface_betti.h"

namespace plateau {

void SurfaceBetti::record(Step step, const SurfaceTracker& surface, std::uint32_t rows) {
    constexpr auto kNone = TemporalGraph::kNone;
    while (node_.size() < rows) {
        node_.push_back(graph_.add_node(step));
        glued_.push_back({kNone, kNone, kNone});
    }
    for (const GlueChange& change : surface.glue_changes()) {
        auto& at_a = glued_[change.row_a][change.corner_a];
        auto& at_b = glued_[change.row_b][change.corner_b];
        if (change.begins) {
            at_a = at_b = graph_.add_edge(node_[change.row_a], node_[change.row_b], step);
        } else {
            graph_.end_edge(at_a, step);
            at_a = at_b = kNone;
        }
    }
    for (const std::uint32_t row : surface.ended_rows()) graph_.end_node(node_[row], step);
    // 3 T = 2 E on a closed surface.
    euler_.push_back(std::int64_t{surface.vertex_count()} - std::int64_t{surface.triangle_count()} / 2);
}

bool SurfaceBetti::evaluate(const Deadline& deadline, std::vector<std::uint32_t>& betti) {
    if (euler_.empty()) return true;
    const Step last = first_pending_ + static_cast<Step>(euler_.size()) - 1;
    if (!count_) count_.emplace(graph_, first_pending_, last);
    if (!count_->advance(deadline)) return false;
    for (std::size_t i = 0; i < euler_.size(); ++i) {
        const std::uint32_t components = count_->components()[i];
        betti.push_back(components);
        betti.push_back(static_cast<std::uint32_t>(2 * std::int64_t{components} - euler_[i]));
        betti.push_back(components);
    }
    count_.reset();
    graph_.forget_ended();
    first_pending_ = last + 1;
    euler_.clear();
    return true;
}

std::uint64_t SurfaceBetti::memory() const {
    return graph_.memory() + node_.capacity() * sizeof(node_[0]) + glued_.capacity() * sizeof(glued_[0]);
}

}  // namespace plateau
