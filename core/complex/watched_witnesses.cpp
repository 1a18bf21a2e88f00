#include "complex/watched_witnesses.h"

namespace plateau {

WatchedWitnesses::WatchedWitnesses(std::size_t track_count, std::size_t dimension_count, std::uint32_t witness_count)
    : watches_(track_count, std::vector<std::vector<Watch>>(dimension_count)),
      first_(track_count, std::vector<std::uint32_t>(witness_count, kEnd)) {}

void WatchedWitnesses::begin_step(std::span<const ListEntry> entries) {
    for (const ListEntry& entry : entries) entered_.push_back(entry.witness);
    first_entered_.push_back(entered_.size());
}

void WatchedWitnesses::add(int k) {
    for (auto& track : watches_) track[static_cast<std::size_t>(k - 1)].emplace_back();
}

void WatchedWitnesses::watch(int track, int k, SimplexIndex simplex, Step birth, std::uint32_t place) {
    std::uint32_t& first = first_[static_cast<std::size_t>(track)][entered_[first_entered_[birth] + place]];
    watch_of(track, k)[simplex] = {first, place};
    first = simplex << kDimensionBits | static_cast<std::uint32_t>(k);
}

bool WatchedWitnesses::move_on(int track, int k, SimplexIndex simplex, std::span<const Step> tuple, std::uint32_t nu,
                               const LandmarkLists& lists) {
    const Step birth = tuple.back();
    const WitnessId* const entered = entered_.data() + first_entered_[birth];
    const auto size = static_cast<std::uint32_t>(first_entered_[birth + 1] - first_entered_[birth]);
    for (std::uint32_t place = watch_of(track, k)[simplex].place + 1; place < size; ++place) {
        const auto list = lists.list(entered[place]).first(nu);
        bool witnesses = true;
        for (std::size_t i = tuple.size(); witnesses && i-- > 0;) {
            witnesses = false;
            for (const Step landmark : list) witnesses = witnesses || landmark == tuple[i];
        }
        if (!witnesses) continue;
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
