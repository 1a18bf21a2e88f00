#include "complex/watched_witnesses.h"

#include <algorithm>

namespace plateau {

namespace {

constexpr std::size_t kFour = 4;
using Four = Step __attribute__((vector_size(kFour * sizeof(Step))));

// Whether all four are in the list. Without branches: what a list holds cannot be foreseen.
bool holds_all(std::span<const Step> list, const Four& vertices) {
    Four found{};
    for (const Step landmark : list) found |= reinterpret_cast<Four>(vertices == landmark);
    return (found[0] & found[1] & found[2] & found[3]) != 0;
}

bool holds_all(std::span<const Step> list, std::span<const Step> vertices) {
    return std::all_of(vertices.begin(), vertices.end(),
                       [&](Step vertex) { return std::find(list.begin(), list.end(), vertex) != list.end(); });
}

}  // namespace

WatchedWitnesses::WatchedWitnesses(std::size_t track_count, std::size_t dimension_count, std::uint32_t witness_count)
    : watches_(track_count, std::vector<PagedTable<Watch>>(dimension_count)),
      first_(track_count, std::vector<std::uint32_t>(witness_count, kEnd)) {}

void WatchedWitnesses::begin_step(std::span<const ListEntry> entries) {
    for (const ListEntry& entry : entries) entered_.push_back(entry.witness);
    first_entered_.push_back(entered_.size());
}

void WatchedWitnesses::add(int k) {
    for (auto& track : watches_) track[static_cast<std::size_t>(k - 1)].push_back({});
}

void WatchedWitnesses::watch(int track, int k, SimplexIndex simplex, Step birth, std::uint32_t place) {
    std::uint32_t& first = first_[static_cast<std::size_t>(track)][entered_[first_entered_[birth] + place]];
    watch_of(track, k)[simplex] = {first, place};
    first = simplex << kDimensionBits | static_cast<std::uint32_t>(k);
}

bool WatchedWitnesses::move_on(int track, int k, SimplexIndex simplex, std::span<const Step> tuple, std::uint32_t nu,
                               const LandmarkLists& lists) {
    const Step birth = tuple.back();
    Four first{};  // vertices; a shorter tuple repeats its last
    for (std::size_t i = 0; i < kFour; ++i) first[i] = tuple[std::min(i, tuple.size() - 1)];
    const auto others = tuple.subspan(std::min(kFour, tuple.size()));
    const WitnessId* const entered = entered_.data() + first_entered_[birth];
    const auto size = static_cast<std::uint32_t>(first_entered_[birth + 1] - first_entered_[birth]);
    for (std::uint32_t place = watch_of(track, k)[simplex].place + 1; place < size; ++place) {
        const auto list = lists.list(entered[place]).first(nu);
        if (!holds_all(list, first) || !holds_all(list, others)) continue;
        watch(track, k, simplex, birth, place);
        return true;
    }
    return false;
}

std::uint64_t WatchedWitnesses::memory() const {
    std::uint64_t bytes = entered_.capacity() * sizeof(WitnessId) + first_entered_.capacity() * sizeof(std::size_t);
    for (const auto& heads : first_) bytes += heads.capacity() * sizeof(std::uint32_t);
    for (const auto& track : watches_) {
        for (const auto& watches : track) bytes += watches.capacity() * sizeof(Watch);
    }
    return bytes;
}

}  // namespace plateau
