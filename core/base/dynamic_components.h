#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/component_labels.h"
#include "base/part_search.h"
#include "base/prefetch.h"

namespace plateau {

/// Connected components of a graph that changes step by step: a step names the nodes and edges that come and go, each
/// once, then settles. Neither kept nor copied here is the graph itself: a search asks for the neighbors that a node
/// has now.
///
/// What a step removes has mostly a stand-in in what it adds: all that was joined through removed edges is joined
/// through added ones. Only where that fails may something have come apart, and a search decides.
/// Cost: the changes, and where pieces may have come off about their size, or the way around.
class DynamicComponents {
public:
    using Node = PartSearch::Node;
    static constexpr Node kNoNode = PartSearch::kNoNode;

    /// `endless`: a node with neighbors too many to visit; searches end there. Its neighbors visit it.
    explicit DynamicComponents(Node endless = kNoNode) : endless_(endless) {}

    /// Nodes are 0 .. count-1; none is there before it is added.
    void resize(std::size_t count) {
        search_.resize(count);
        states_.resize(count);
    }
    /// Asks for a node that this step will concern.
    void expect(Node node) const {
        if (node < states_.size()) prefetch(&states_[node]);
    }
    void add_node(Node node) { slots_[slot(node)].fate = Fate::Added; }
    /// With all its edges, which are to be removed one by one.
    void remove_node(Node node) { slots_[slot(node)].fate = Fate::Removed; }
    void add_edge(Node a, Node b) { unite(&Slot::added, slot(a), slot(b)); }
    void remove_edge(Node a, Node b) { unite(&Slot::removed, slot(a), slot(b)); }

    /// Ends the step: all changes are named. `visit_neighbors(node, use)` calls use(neighbor) by the graph as it is
    /// now.
    template <class VisitNeighbors>
    void settle(const VisitNeighbors& visit_neighbors) {
        label_added();
        find_suspects();
        const auto label_of = [&](Node node) -> ComponentLabels::Label& { return states_[node].label; };
        labels_.for_each_shared(suspects_, label_of, [&](std::span<const Node> suspects) {
            search_.run(suspects, visit_neighbors, endless_,
                        [&](const auto& visit_piece) { labels_.cut_off(visit_piece, label_of); });
        });
        slots_.clear();
    }

    /// Number of components after the last settled step.
    std::uint32_t count() const { return labels_.count(); }
    std::uint64_t memory() const;

private:
    enum class Fate : std::uint8_t { Stays, Added, Removed };
    /// A node that this step concerns, in two union-finds: by the edges removed, and by those added.
    struct Slot {
        Node node;
        std::uint32_t removed, added;  // parents
        ComponentLabels::Label label;  // at roots of `added`: of the nodes that were there
        std::uint32_t first;           // at roots of `removed`: the first slot of the set that stays
        bool apart;                    // at roots of `removed`: added edges do not join all of them
        Fate fate;
    };
    struct State {
        ComponentLabels::Label label = ComponentLabels::kNone;
        std::uint32_t slot = 0;  // of this step, if that slot is the node's
    };

    std::uint32_t slot(Node node) {
        const std::uint32_t known = states_[node].slot;
        return known < slots_.size() && slots_[known].node == node ? known : add_slot(node);
    }
    std::uint32_t add_slot(Node node);
    std::uint32_t root(std::uint32_t Slot::*parent, std::uint32_t slot) {
        while (slots_[slot].*parent != slot) slot = slots_[slot].*parent = slots_[slots_[slot].*parent].*parent;
        return slot;
    }
    void unite(std::uint32_t Slot::*parent, std::uint32_t a, std::uint32_t b) {
        slots_[root(parent, a)].*parent = root(parent, b);
    }
    void label_added();
    void find_suspects();

    Node endless_;
    std::vector<State> states_;  // by node
    std::vector<Slot> slots_;
    std::vector<Node> suspects_;
    ComponentLabels labels_;
    PartSearch search_;
};

}  // namespace plateau
