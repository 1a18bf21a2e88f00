#include "inspect/sightings.h"

#include <algorithm>

namespace plateau {

namespace {

// One with near vertices first: its rank lets most others off after a few landmarks.
std::optional<Sighting> closest(const LandmarkRanks& ranks, std::span<const Step> simplex) {
    Sighting best{0, 0, 0};
    double least = ranks.reach(0, simplex);
    for (std::uint32_t witness = 1; witness < ranks.witness_count(); ++witness) {
        const double reach = ranks.reach(witness, simplex);
        if (!(reach < least)) continue;
        least = reach;
        best.witness = witness;
    }
    best.rank = ranks.largest_rank(best.witness, simplex, ranks.horizon());
    for (std::uint32_t witness = 0; witness < ranks.witness_count(); ++witness) {
        const std::uint32_t rank = ranks.largest_rank(witness, simplex, std::min(best.rank, ranks.horizon()));
        if (rank < best.rank || (rank == best.rank && witness < best.witness)) best = {witness, rank, 0};
    }
    return best.rank <= ranks.horizon() ? std::optional(best) : std::nullopt;
}

}  // namespace

Sightings sightings(const LandmarkRanks& ranks, std::span<const Step> simplex, std::uint32_t allowed) {
    const std::uint32_t limit = std::min(allowed, ranks.horizon());
    Sightings found;
    for (std::uint32_t witness = 0; witness < ranks.witness_count(); ++witness) {
        const std::uint32_t rank = ranks.largest_rank(witness, simplex, limit);
        if (rank <= limit) found.witnesses.push_back({witness, rank, 0});
    }
    found.witness_count = static_cast<std::uint32_t>(found.witnesses.size());
    std::stable_sort(found.witnesses.begin(), found.witnesses.end(),
                     [](const Sighting& a, const Sighting& b) { return a.rank < b.rank; });
    if (found.witness_count > 0) {
        found.best = found.witnesses.front();
    } else if (ranks.witness_count() > 0) {
        found.best = closest(ranks, simplex);
    }
    if (found.witnesses.size() > kMaxSightings) found.witnesses.resize(kMaxSightings);
    if (!found.best) return found;
    for (const Step vertex : simplex) {
        found.best_ranks.push_back(ranks.rank(found.best->witness, vertex, found.best->rank));
    }
    return found;
}

}  // namespace plateau
