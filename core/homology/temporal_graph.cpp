#include "homology/temporal_graph.h"

namespace plateau {

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

void TemporalGraph::forget_ended() {
    for (const Node node : ended_nodes_) nodes_[node] = {};
    for (const Edge edge : ended_edges_) edge_spans_[edge] = {};
    free_nodes_.insert(free_nodes_.end(), ended_nodes_.begin(), ended_nodes_.end());
    free_edges_.insert(free_edges_.end(), ended_edges_.begin(), ended_edges_.end());
    ended_nodes_.clear();
    ended_edges_.clear();
    changes_ = 0;
}

std::uint64_t TemporalGraph::memory() const {
    return (nodes_.capacity() + edge_spans_.capacity()) * sizeof(Span) + edge_ends_.capacity() * sizeof(Ends) +
           (free_nodes_.capacity() + free_edges_.capacity() + ended_nodes_.capacity() + ended_edges_.capacity()) *
               sizeof(std::uint32_t);
}

}  // namespace plateau
