#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace plateau {

/// How many connected components a graph has while nodes come and go: every node carries a label, two labels that were
/// joined are one, and a component is a label that some node carries. The owner of the graph keeps the nodes' labels.
class ComponentLabels {
public:
    using Label = std::uint32_t;
    static constexpr Label kNone = 0xFFFFFFFFu;

    /// A label that no node carries yet.
    Label make() {
        parent_.push_back(static_cast<Label>(parent_.size()));
        carriers_.push_back(0);
        return parent_.back();
    }
    Label find(Label label) {
        while (parent_[label] != label) label = parent_[label] = parent_[parent_[label]];
        return label;
    }
    /// Both are carried by nodes.
    void join(Label a, Label b) {
        a = find(a);
        b = find(b);
        if (a == b) return;
        if (carriers_[a] < carriers_[b]) std::swap(a, b);
        --count_;
        carriers_[a] += carriers_[b];
        parent_[b] = a;
    }
    /// A node begins to carry the label.
    void add(Label label) {
        if (carriers_[find(label)]++ == 0) ++count_;
    }
    /// A node carries it no longer.
    void remove(Label label) {
        if (--carriers_[find(label)] == 0) --count_;
    }
    /// A piece has come off: its nodes, which `visit(use)` names, carry a new label. `label_of(node)` is where the
    /// node's label is kept.
    template <class Visit, class LabelOf>
    void cut_off(const Visit& visit, const LabelOf& label_of) {
        const Label fresh = make();
        visit([&](std::uint32_t node) {
            Label& label = label_of(node);
            remove(label);
            add(fresh);
            label = fresh;
        });
    }
    /// Calls use(nodes) for the nodes of each component that holds more than one of these; sorts `nodes`.
    template <class LabelOf, class Use>
    void for_each_shared(std::vector<std::uint32_t>& nodes, const LabelOf& label_of, const Use& use) {
        const auto root = [&](std::uint32_t node) { return find(label_of(node)); };
        std::sort(nodes.begin(), nodes.end(), [&](std::uint32_t a, std::uint32_t b) {
            const Label x = root(a);
            const Label y = root(b);
            return x != y ? x < y : a < b;
        });
        for (std::size_t begin = 0, end = 0; begin < nodes.size(); begin = end) {
            while (end < nodes.size() && root(nodes[end]) == root(nodes[begin])) ++end;
            if (end - begin > 1) use(std::span<const std::uint32_t>(nodes.data() + begin, end - begin));
        }
    }
    /// Components: labels in use.
    std::uint32_t count() const { return count_; }
    std::uint64_t memory() const { return 2 * parent_.capacity() * sizeof(Label); }

private:
    std::vector<Label> parent_;            // union by number of carriers
    std::vector<std::uint32_t> carriers_;  // at roots
    std::uint32_t count_ = 0;
};

}  // namespace plateau
