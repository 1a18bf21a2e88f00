#pragma once

#include <cstdint>
#include <vector>

#include "complex/simplex_table.h"

namespace plateau {

/// A graph whose nodes and edges come and go with the steps. Lifespans are half-open: [from, to). ComponentCount counts
/// its components over blocks of steps.
class TemporalGraph {
public:
    using Node = std::uint32_t;
    using Edge = std::uint32_t;
    static constexpr std::uint32_t kNone = 0xFFFFFFFFu;

    Node add_node(Step from);
    void end_node(Node node, Step to);
    /// Both nodes must live as long as the edge. A loop is not kept: kNone.
    Edge add_edge(Node a, Node b, Step from);
    /// Ends an edge once; later calls and kNone do nothing.
    void end_edge(Edge edge, Step to);

    /// Forgets what has ended; after the steps so far have been counted.
    void forget_ended();

    /// Size of what lives now, and the number of changes since the last count: what decides the length of a block.
    std::uint64_t live() const { return live_nodes_ + live_edges_; }
    std::uint64_t changes() const { return changes_; }
    std::uint64_t memory() const;

private:
    friend class ComponentCount;
    struct Span {
        Step from = 0, to = 0;  // an empty span is a free slot
    };
    struct Ends {
        Node a = 0, b = 0;
    };
    std::vector<Span> nodes_;
    std::vector<Span> edge_spans_;
    std::vector<Ends> edge_ends_;
    std::vector<Node> free_nodes_, ended_nodes_;
    std::vector<Edge> free_edges_, ended_edges_;
    std::uint64_t live_nodes_ = 0, live_edges_ = 0, changes_ = 0;
};

}  // namespace plateau
