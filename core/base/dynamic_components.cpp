#include "base/dynamic_components.h"

namespace plateau {

namespace {
constexpr std::uint32_t kNone = 0xFFFFFFFFu;
}

std::uint32_t DynamicComponents::slot(Node node) {
    State& state = states_[node];
    if (state.seen != now_) {
        state.seen = now_;
        state.slot = static_cast<std::uint32_t>(slots_.size());
        slots_.push_back({node, state.slot, state.slot, ComponentLabels::kNone, kNone, false, Fate::Stays});
    }
    return state.slot;
}

std::uint32_t DynamicComponents::root(std::uint32_t Slot::*parent, std::uint32_t slot) {
    while (slots_[slot].*parent != slot) slot = slots_[slot].*parent = slots_[slots_[slot].*parent].*parent;
    return slot;
}

void DynamicComponents::unite(std::uint32_t Slot::*parent, std::uint32_t a, std::uint32_t b) {
    slots_[root(parent, a)].*parent = root(parent, b);
}

// What is joined by added edges shares the labels of the nodes that were there before.
void DynamicComponents::label_added() {
    for (std::uint32_t s = 0; s < slots_.size(); ++s) {
        if (slots_[s].fate != Fate::Stays) continue;
        const auto label = states_[slots_[s].node].label;
        auto& shared = slots_[root(&Slot::added, s)].label;
        if (shared == ComponentLabels::kNone) {
            shared = label;
        } else {
            labels_.join(shared, label);
        }
    }
    for (std::uint32_t s = 0; s < slots_.size(); ++s) {
        auto& label = states_[slots_[s].node].label;
        if (slots_[s].fate == Fate::Added) {
            auto& shared = slots_[root(&Slot::added, s)].label;
            if (shared == ComponentLabels::kNone) shared = labels_.make();
            label = shared;
            labels_.add(label);
        } else if (slots_[s].fate == Fate::Removed) {
            labels_.remove(label);
        }
    }
}

// Nodes that removed edges joined, one of each set that added edges join: where there are two, a piece may have come
// off, and each piece holds one.
void DynamicComponents::find_suspects() {
    suspects_.clear();
    for (std::uint32_t s = 0; s < slots_.size(); ++s) {
        if (slots_[s].fate != Fate::Stays) continue;
        Slot& set = slots_[root(&Slot::removed, s)];
        if (set.first == kNone) set.first = s;
        if (root(&Slot::added, s) == root(&Slot::added, set.first)) continue;
        if (!set.apart) suspects_.push_back(slots_[set.first].node);
        set.apart = true;
        suspects_.push_back(slots_[s].node);
    }
}

std::uint64_t DynamicComponents::memory() const {
    return states_.capacity() * sizeof(State) + labels_.memory() + search_.memory();
}

}  // namespace plateau
