#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "homology/component_count.h"
#include "homology/temporal_graph.h"
#include "surface/surface_tracker.h"

namespace plateau {

/// Betti numbers of the extracted surface at every step. It is closed, so beta_0 = beta_2 = its components and
/// beta_1 = 2 beta_0 - chi.
class SurfaceBetti {
public:
    /// Follows one step of the tracker. `rows` is the number of rows so far.
    void record(Step step, const SurfaceTracker& surface, std::uint32_t rows);

    /// Works until the deadline on the recorded steps that have not been evaluated yet; nothing may be recorded before
    /// it is done. True when done: then beta_0, beta_1, beta_2 of each have been appended, 0, 0, 0 where it is empty.
    bool evaluate(const Deadline& deadline, std::vector<std::uint32_t>& betti);

    std::uint64_t live() const { return graph_.live(); }
    std::uint64_t changes() const { return graph_.changes(); }
    std::uint64_t memory() const;

private:
    TemporalGraph graph_;                                    // nodes: rows; edges: what is glued
    std::vector<TemporalGraph::Node> node_;                  // by row
    std::vector<std::array<TemporalGraph::Edge, 3>> glued_;  // by row and corner
    std::optional<ComponentCount> count_;                    // of an evaluation under way
    Step first_pending_ = 1;
    std::vector<std::int64_t> euler_;
};

}  // namespace plateau
