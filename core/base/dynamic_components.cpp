#include "base/dynamic_components.h"

namespace plateau {

namespace {
constexpr std::uint32_t kNone = 0xFFFFFFFFu;
}

std::uint32_t DynamicComponents::add_slot(Node node) {
    const auto fresh = static_cast<std::uint32_t>(slots_.size());
    states_[node].slot = fresh;
    slots_.push_back({node, fresh, fresh, ComponentLabels::kNone, kNone, false, Fate::Stays});
    return fresh;
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
