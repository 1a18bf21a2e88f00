#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace plateau {

/// Finds which pieces a removal has cut off a connected part of a graph, at about the cost of the pieces.
///
/// Searches run in turn, a node each, from every suspect. Where two meet they go on as one; one that has nothing left
/// to visit has found a whole piece. The last one still going is the rest, and is not walked any further [Even and
/// Shiloach, An on-line edge-deletion problem, 1981].
class PartSearch {
public:
    using Node = std::uint32_t;
    static constexpr Node kNoNode = 0xFFFFFFFFu;

    /// For nodes 0 .. count-1.
    void resize(std::size_t count) {
        seen_.resize(count, 0);
        group_.resize(count);
        next_.resize(count);
    }

    /// `suspects`: nodes of what was one part, such that every piece of it holds a suspect.
    /// `visit_neighbors(node, use)` calls use(neighbor). `endless`: a node that is reached but not walked on from, or
    /// kNoNode. `piece(visit)` is called for every piece but the rest; its `visit(use)` calls use(node) for all nodes
    /// of the piece.
    template <class VisitNeighbors, class Piece>
    void run(std::span<const Node> suspects, const VisitNeighbors& visit_neighbors, Node endless, const Piece& piece) {
        ++now_;
        groups_.clear();
        endless_group_ = kNone;
        open_ = 0;
        for (const Node node : suspects) {
            if (seen_[node] == now_) continue;
            groups_.push_back({static_cast<std::uint32_t>(groups_.size()), {}, {}, false});
            ++open_;
            reach(node, groups_.back().into, endless);
        }
        while (open_ > 1) {
            for (std::uint32_t g = 0; g < groups_.size() && open_ > 1; ++g) {
                if (groups_[g].into != g || g == endless_group_ || groups_[g].whole) continue;
                const Node node = groups_[g].waiting.first;
                groups_[g].waiting.first = next_[node];
                append(groups_[g].walked, node);
                std::uint32_t own = g;
                visit_neighbors(node, [&](Node neighbor) {
                    if (seen_[neighbor] != now_) {
                        reach(neighbor, own, endless);
                    } else {
                        merge(root(group_[neighbor]), own);
                    }
                    own = root(own);
                });
                const bool whole = own != endless_group_ && groups_[own].waiting.first == kNone;
                if (!whole) continue;
                groups_[own].whole = true;
                --open_;
            }
        }
        for (const Group& group : groups_) {
            if (!group.whole) continue;
            piece([&](const auto& use) {
                for (Node node = group.walked.first; node != kNone; node = next_[node]) use(node);
            });
        }
    }

    std::uint64_t memory() const { return 3 * seen_.capacity() * sizeof(std::uint32_t); }

private:
    static constexpr std::uint32_t kNone = 0xFFFFFFFFu;
    struct List {  // linked through next_
        Node first = kNone, last = kNone;
    };
    struct Group {
        std::uint32_t into;  // itself, or the group that it has joined
        List walked, waiting;
        bool whole;  // nothing left to visit
    };

    std::uint32_t root(std::uint32_t group) {
        while (groups_[group].into != group) group = groups_[group].into = groups_[groups_[group].into].into;
        return group;
    }
    void append(List& list, Node node) {
        next_[node] = kNone;
        (list.first == kNone ? list.first : next_[list.last]) = node;
        list.last = node;
    }
    void append(List& list, const List& other) {
        if (other.first == kNone) return;
        (list.first == kNone ? list.first : next_[list.last]) = other.first;
        list.last = other.last;
    }
    void reach(Node node, std::uint32_t group, Node endless) {
        seen_[node] = now_;
        group_[node] = group;
        if (node == endless) {
            endless_group_ = group;
        } else {
            append(groups_[group].waiting, node);
        }
    }
    // Both are roots, and neither is whole: a whole piece meets nobody.
    void merge(std::uint32_t from, std::uint32_t into) {
        if (from == into) return;
        groups_[from].into = into;
        append(groups_[into].walked, groups_[from].walked);
        append(groups_[into].waiting, groups_[from].waiting);
        if (endless_group_ == from) endless_group_ = into;
        --open_;
    }

    std::vector<std::uint32_t> seen_, group_;  // by node
    std::vector<Node> next_;
    std::vector<Group> groups_;
    std::uint32_t endless_group_ = kNone;
    std::uint32_t open_ = 0;  // groups that are neither whole nor joined to another
    std::uint32_t now_ = 0;
};

}  // namespace plateau
