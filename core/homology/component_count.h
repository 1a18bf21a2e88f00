#pragma once

#include <cstdint>
#include <vector>

#include "base/deadline.h"
#include "homology/temporal_graph.h"

namespace plateau {

/// The number of connected components of a TemporalGraph at each step of a block, in slices of work.
///
/// What lives through the block is contracted; the rest goes through divide and conquer over the steps with a
/// union-find that can be rolled back. Cost: O(live + changes log(block)) times union-find, a deadline passed is
/// noticed within some thousand operations.
class ComponentCount {
public:
    /// Counts at the steps first .. last. `graph` must outlive this and not change until it is done.
    ComponentCount(const TemporalGraph& graph, Step first, Step last);

    /// Works until the deadline; true when every step is counted.
    bool advance(const Deadline& deadline);
    /// One number a step; complete once advance() has returned true.
    const std::vector<std::uint32_t>& components() const { return components_; }

private:
    using Node = TemporalGraph::Node;
    enum class Phase : std::uint8_t { Contract, Relabel, Nodes, Divide, Done };
    struct BlockEdge {
        Node a, b;
        TemporalGraph::Span span;
    };
    /// Steps first .. last, the edges [begin, end) that live in a part of them, and where the work on them stands.
    struct Frame {
        Step first, last;
        std::size_t begin, end;
        std::size_t next;       // edge to look at
        std::size_t own_begin;  // where the edges that live in a part only are put
        std::size_t mark;       // of the union-find
        std::uint32_t merged;   // unions in force
        std::uint8_t halves_done;
    };

    bool lives_in(const TemporalGraph::Span& span, Step first, Step last) const {
        return span.from < span.to && span.from <= last && span.to > first;
    }
    bool lives_throughout(const TemporalGraph::Span& span, Step first, Step last) const {
        return span.from <= first && span.to > last;
    }
    void contract(TemporalGraph::Edge edge);
    void relabel(std::size_t place);
    void count_node(Node node);
    void begin_dividing();
    void divide_on();
    void push(Step first, Step last, std::size_t begin, std::size_t end, std::uint32_t merged);

    Node find(Node node) const {
        while (parent_[node] != node) node = parent_[node];
        return node;
    }
    Node find_halving(Node node) {
        while (parent_[node] != node) node = parent_[node] = parent_[parent_[node]];
        return node;
    }
    bool unite_roots(Node a, Node b, bool undoable);
    void roll_back(std::size_t mark);

    const TemporalGraph* graph_;
    Step first_, last_;
    Phase phase_ = Phase::Contract;
    std::size_t cursor_ = 0;    // within the phase
    std::vector<Node> parent_;  // union by size
    std::vector<std::uint32_t> size_;
    std::vector<Node> undo_;  // roots that were put under another
    std::uint32_t merged_throughout_ = 0;
    std::vector<BlockEdge> partial_;          // edges that live in a part of the block; frames append theirs
    std::vector<std::int64_t> alive_change_;  // nodes that come minus nodes that go, by step
    std::vector<Frame> frames_;
    std::vector<std::uint32_t> components_;  // first the unions at each step, in the end the components
};

}  // namespace plateau
