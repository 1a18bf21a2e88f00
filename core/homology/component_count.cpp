#include "homology/component_count.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace plateau {

ComponentCount::ComponentCount(const TemporalGraph& graph, Step first, Step last)
    : graph_(&graph),
      first_(first),
      last_(last),
      parent_(graph.nodes_.size()),
      size_(graph.nodes_.size(), 1),
      alive_change_(last - first + 2, 0),
      components_(last - first + 1, 0) {
    std::iota(parent_.begin(), parent_.end(), 0u);
}

bool ComponentCount::advance(const Deadline& deadline) {
    constexpr std::size_t kBetweenLooks = 2048;
    for (std::size_t i = 1; phase_ != Phase::Done; ++i) {
        if (i % kBetweenLooks == 0 && deadline.passed()) return false;
        const std::size_t at = cursor_++;
        switch (phase_) {
            case Phase::Contract:
                if (at < graph_->edge_spans_.size()) {
                    contract(static_cast<TemporalGraph::Edge>(at));
                } else {
                    phase_ = Phase::Relabel;
                    cursor_ = 0;
                }
                break;
            case Phase::Relabel:
                if (at < partial_.size()) {
                    relabel(at);
                } else {
                    phase_ = Phase::Nodes;
                    cursor_ = 0;
                }
                break;
            case Phase::Nodes:
                if (at < graph_->nodes_.size()) {
                    count_node(static_cast<Node>(at));
                } else {
                    phase_ = Phase::Divide;
                    begin_dividing();
                }
                break;
            case Phase::Divide:
                divide_on();
                break;
            case Phase::Done:
                break;
        }
    }
    return true;
}

void ComponentCount::contract(TemporalGraph::Edge edge) {
    const auto& span = graph_->edge_spans_[edge];
    if (!lives_in(span, first_, last_)) return;
    const auto& ends = graph_->edge_ends_[edge];
    if (!lives_throughout(span, first_, last_)) {
        partial_.push_back({ends.a, ends.b, span});
    } else if (unite_roots(find_halving(ends.a), find_halving(ends.b), false)) {
        ++merged_throughout_;
    }
}

void ComponentCount::relabel(std::size_t place) {
    BlockEdge& edge = partial_[place];
    edge.a = find_halving(edge.a);
    edge.b = find_halving(edge.b);
}

void ComponentCount::count_node(Node node) {
    const auto& span = graph_->nodes_[node];
    if (!lives_in(span, first_, last_)) return;
    ++alive_change_[std::max(span.from, first_) - first_];
    if (span.to <= last_) --alive_change_[span.to - first_];
}

void ComponentCount::begin_dividing() {
    std::erase_if(partial_, [](const BlockEdge& edge) { return edge.a == edge.b; });
    push(first_, last_, 0, partial_.size(), merged_throughout_);
}

void ComponentCount::push(Step first, Step last, std::size_t begin, std::size_t end, std::uint32_t merged) {
    frames_.push_back({first, last, begin, end, begin, partial_.size(), undo_.size(), merged, 0});
}

// One edge of the innermost frame, or one of its halves, or its end.
void ComponentCount::divide_on() {
    Frame& frame = frames_.back();
    if (frame.next < frame.end) {
        const BlockEdge edge = partial_[frame.next++];
        if (lives_throughout(edge.span, frame.first, frame.last)) {
            if (unite_roots(find(edge.a), find(edge.b), true)) ++frame.merged;
        } else if (lives_in(edge.span, frame.first, frame.last)) {
            partial_.push_back(edge);
        }
        return;
    }
    const std::size_t own_end = partial_.size();
    if (own_end == frame.own_begin) {
        for (Step step = frame.first; step <= frame.last; ++step) components_[step - first_] = frame.merged;
    } else if (frame.halves_done < 2) {
        const Step middle = frame.first + (frame.last - frame.first) / 2;
        const bool left = frame.halves_done++ == 0;
        push(left ? frame.first : middle + 1, left ? middle : frame.last, frame.own_begin, own_end, frame.merged);
        return;
    }
    partial_.resize(frame.own_begin);
    roll_back(frame.mark);
    frames_.pop_back();
    if (!frames_.empty()) return;
    std::int64_t nodes = 0;
    for (std::size_t i = 0; i < components_.size(); ++i) {
        nodes += alive_change_[i];
        components_[i] = static_cast<std::uint32_t>(nodes - components_[i]);
    }
    phase_ = Phase::Done;
}

// True if two sets became one.
bool ComponentCount::unite_roots(Node a, Node b, bool undoable) {
    if (a == b) return false;
    if (size_[a] < size_[b]) std::swap(a, b);
    parent_[b] = a;
    size_[a] += size_[b];
    if (undoable) undo_.push_back(b);
    return true;
}

void ComponentCount::roll_back(std::size_t mark) {
    for (; undo_.size() > mark; undo_.pop_back()) {
        const Node child = undo_.back();
        size_[parent_[child]] -= size_[child];
        parent_[child] = child;
    }
}

}  // namespace plateau
