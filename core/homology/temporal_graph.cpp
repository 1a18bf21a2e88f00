#include "homology/temporal_graph.h"

#include <algorithm>
#include <numeric>

namespace plateau {

/// Union by size without path compression, so that unions can be undone; `compress` halves paths while none will be.
class TemporalGraph::UnionFind {
public:
    explicit UnionFind(std::size_t size) : parent_(size), size_(size, 1) {
        std::iota(parent_.begin(), parent_.end(), 0u);
    }

    Node find(Node node) const {
        while (parent_[node] != node) node = parent_[node];
        return node;
    }
    Node compress(Node node) {
        while (parent_[node] != node) node = parent_[node] = parent_[parent_[node]];
        return node;
    }
    /// True if two sets became one.
    bool unite_roots(Node a, Node b, bool undoable) {
        if (a == b) return false;
        if (size_[a] < size_[b]) std::swap(a, b);
        parent_[b] = a;
        size_[a] += size_[b];
        if (undoable) undo_.push_back(b);
        return true;
    }
    std::size_t mark() const { return undo_.size(); }
    void roll_back(std::size_t mark) {
        for (; undo_.size() > mark; undo_.pop_back()) {
            const Node child = undo_.back();
            size_[parent_[child]] -= size_[child];
            parent_[child] = child;
        }
    }

private:
    std::vector<Node> parent_;
    std::vector<std::uint32_t> size_;
    std::vector<Node> undo_;
};

TemporalGraph::Node TemporalGraph::add_node(Step from) {
    ++live_nodes_;
    ++changes_;
    if (free_nodes_.empty()) {
        nodes_.push_back({from, kNever});
        return static_cast<Node>(nodes_.size() - 1);
    }
    const Node node = free_nodes_.back();
    free_nodes_.pop_back();
    nodes_[node] = {from, kNever};
    return node;
}

void TemporalGraph::end_node(Node node, Step to) {
    nodes_[node].to = to;
    ended_nodes_.push_back(node);
    --live_nodes_;
    ++changes_;
}

TemporalGraph::Edge TemporalGraph::add_edge(Node a, Node b, Step from) {
    if (a == b) return kNone;
    ++live_edges_;
    ++changes_;
    if (free_edges_.empty()) {
        edge_spans_.push_back({from, kNever});
        edge_ends_.push_back({a, b});
        return static_cast<Edge>(edge_spans_.size() - 1);
    }
    const Edge edge = free_edges_.back();
    free_edges_.pop_back();
    edge_spans_[edge] = {from, kNever};
    edge_ends_[edge] = {a, b};
    return edge;
}

void TemporalGraph::end_edge(Edge edge, Step to) {
    if (edge == kNone || edge_spans_[edge].to != kNever) return;
    edge_spans_[edge].to = to;
    ended_edges_.push_back(edge);
    --live_edges_;
    ++changes_;
}

std::vector<std::uint32_t> TemporalGraph::count_components(Step first, Step last) {
    const std::size_t steps = last - first + 1;
    UnionFind sets(nodes_.size());

    std::uint32_t merged_throughout = 0;
    std::vector<BlockEdge> partial;
    for (Edge edge = 0; edge < edge_spans_.size(); ++edge) {
        const Span span = edge_spans_[edge];
        if (span.from >= span.to || span.from > last || span.to <= first) continue;
        const Ends ends = edge_ends_[edge];
        if (span.from <= first && span.to > last) {
            if (sets.unite_roots(sets.compress(ends.a), sets.compress(ends.b), false)) ++merged_throughout;
        } else {
            partial.push_back({ends.a, ends.b, span});
        }
    }
    for (BlockEdge& edge : partial) edge = {sets.compress(edge.a), sets.compress(edge.b), edge.span};
    std::erase_if(partial, [](const BlockEdge& edge) { return edge.a == edge.b; });

    std::vector<std::uint32_t> alive(steps + 1, 0);
    for (const Span& span : nodes_) {
        if (span.from >= span.to || span.from > last || span.to <= first) continue;
        ++alive[std::max(span.from, first) - first];
        if (span.to <= last) --alive[span.to - first];
    }
    std::vector<std::uint32_t> merged(steps, 0);
    divide(first, last, partial, 0, partial.size(), sets, merged_throughout, merged, first);

    std::vector<std::uint32_t> components(steps);
    std::uint32_t nodes = 0;
    for (std::size_t i = 0; i < steps; ++i) {
        nodes += alive[i];
        components[i] = nodes - merged[i];
    }

    for (const Node node : ended_nodes_) nodes_[node] = {};
    for (const Edge edge : ended_edges_) edge_spans_[edge] = {};
    free_nodes_.insert(free_nodes_.end(), ended_nodes_.begin(), ended_nodes_.end());
    free_edges_.insert(free_edges_.end(), ended_edges_.begin(), ended_edges_.end());
    ended_nodes_.clear();
    ended_edges_.clear();
    changes_ = 0;
    return components;
}

// Edges [begin, end) are those that live in a part of first .. last; `merged` counts the unions made above.
void TemporalGraph::divide(Step first, Step last, std::vector<BlockEdge>& edges, std::size_t begin, std::size_t end,
                           UnionFind& sets, std::uint32_t merged, std::vector<std::uint32_t>& merged_at,
                           Step block_first) {
    const std::size_t mark = sets.mark();
    const std::size_t own_begin = edges.size();
    for (std::size_t i = begin; i < end; ++i) {
        const BlockEdge edge = edges[i];
        if (edge.span.from <= first && edge.span.to > last) {
            if (sets.unite_roots(sets.find(edge.a), sets.find(edge.b), true)) ++merged;
        } else if (edge.span.from <= last && edge.span.to > first) {
            edges.push_back(edge);
        }
    }
    const std::size_t own_end = edges.size();
    if (own_begin == own_end) {
        for (Step step = first; step <= last; ++step) merged_at[step - block_first] = merged;
    } else {
        const Step middle = first + (last - first) / 2;
        divide(first, middle, edges, own_begin, own_end, sets, merged, merged_at, block_first);
        divide(middle + 1, last, edges, own_begin, own_end, sets, merged, merged_at, block_first);
    }
    edges.resize(own_begin);
    sets.roll_back(mark);
}

std::uint64_t TemporalGraph::memory() const {
    return (nodes_.capacity() + edge_spans_.capacity()) * sizeof(Span) + edge_ends_.capacity() * sizeof(Ends) +
           (free_nodes_.capacity() + free_edges_.capacity() + ended_nodes_.capacity() + ended_edges_.capacity()) *
               sizeof(std::uint32_t);
}

}  // namespace plateau
