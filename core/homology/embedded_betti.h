#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "complex/delaunay_faces.h"
#include "complex/simplex_table.h"
#include "delaunay/delaunay.h"
#include "homology/component_count.h"
#include "homology/temporal_graph.h"

namespace plateau {

/// Betti numbers of one track of C_nu^W within D(L), at every step, without matrices: the complex is embedded, so
/// beta_0 counts the components of its edges, beta_2 the bounded components of its complement in the dual graph of D(L)
/// (Alexander duality), and beta_1 follows from the Euler characteristic. While D(L) is flat beta_2 is 0.
class EmbeddedBetti {
public:
    /// `ambient_dimension` 2 or 3.
    EmbeddedBetti(int track, int ambient_dimension);

    /// Follows one insertion, after complex and faces have followed it. `deaths` of this step.
    void record(Step step, const std::vector<SimplexTable>& tables, std::span<const Death> deaths,
                const Delaunay& delaunay, const DelaunayChange& change, const DelaunayFaces& faces);

    /// Works until the deadline on the recorded steps that have not been evaluated yet; nothing may be recorded before
    /// it is done. True when done: then beta_0 .. beta_{d-1} of each of these steps have been appended to `betti`.
    bool evaluate(const Deadline& deadline, std::vector<std::uint32_t>& betti);

    std::uint64_t live() const { return skeleton_.live() + complement_.live(); }
    std::uint64_t changes() const { return skeleton_.changes() + complement_.changes(); }
    std::uint64_t memory() const;

private:
    void record_skeleton(Step step, const std::vector<SimplexTable>& tables, std::span<const Death> deaths);
    void record_complement(Step step, const std::vector<SimplexTable>& tables, std::span<const Death> deaths,
                           const Delaunay& delaunay, const DelaunayChange& change, const DelaunayFaces& faces);
    void open_facet(Step step, CellId cell, int index, const Delaunay& delaunay);

    int track_;
    int ambient_dimension_;
    Step first_pending_ = 1;
    std::vector<std::int64_t> euler_;  // of the pending steps
    std::vector<int> dimension_;       // of D(L) at the pending steps
    std::int64_t euler_now_ = 0;

    std::optional<ComponentCount> skeleton_count_, complement_count_;  // of an evaluation under way

    TemporalGraph skeleton_;
    std::vector<TemporalGraph::Edge> skeleton_edge_;  // by edge index

    TemporalGraph complement_;
    TemporalGraph::Node outside_ = TemporalGraph::kNone;  // all infinite cells
    std::vector<TemporalGraph::Node> cell_node_;
    std::vector<std::array<TemporalGraph::Edge, 4>> facet_edge_;
};

}  // namespace plateau
