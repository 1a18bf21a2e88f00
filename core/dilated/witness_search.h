#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "dilated/cell_distance.h"
#include "dilated/witness_balls.h"
#include "landmarks/landmark_lists.h"

namespace plateau {

/// A witness of a simplex: how far it is from the cell, and its nearest point there.
struct Watch {
    WitnessId witness = 0;
    double distance_squared = 0;
    double power = 0;  ///< largest power of a vertex at `nearest`
    std::array<double, kMaxDilatedDimension> nearest{};
};

/// Looks for witnesses of simplices: a descent into the tree that leaves out what provably has none.
class WitnessSearch {
public:
    /// What a search counts as of a Slice, at least: some microseconds.
    static constexpr std::uint32_t kUnits = 32;

    /// `lists` by a prepared tree; both must outlive this.
    WitnessSearch(const LandmarkLists& lists, const WeightedLandmarks& landmarks)
        : lists_(&lists), landmarks_(&landmarks), balls_(lists.tree()), cell_(landmarks) {}

    /// To be called until it is true, before anything else.
    bool prepare(Slice& slice) { return balls_.prepare(slice); }

    /// A witness at a distance of at most zeta from the cell of the simplex, vertices ascending; nothing if there is
    /// none. `hint`: a point near which to look first.
    std::optional<Watch> find(std::span<const Step> simplex, double zeta, const double* hint);
    /// The same for this witness alone.
    std::optional<Watch> look_at(std::span<const Step> simplex, double zeta, WitnessId witness);
    /// How many nodes and witnesses the last find() has looked at: what it counts as of a Slice, beside kUnits.
    std::uint32_t looked_at() const { return looked_at_; }
    /// No landmark farther from the youngest, p, is in a simplex with it that has a witness within zeta.
    double reach(double zeta);

    std::uint64_t memory() const { return balls_.memory() + cell_.memory(); }

private:
    const double* point(WitnessId witness) const { return balls_.tree().point(witness); }
    bool is_far(WitnessId witness, double limit) const;
    std::optional<Watch> examine(WitnessId witness, double zeta, double far, bool& excluded);
    std::optional<Watch> descend(double zeta, const double* hint);
    double list_reach(WitnessId witness, double slack) const;

    const LandmarkLists* lists_;
    const WeightedLandmarks* landmarks_;
    WitnessBalls balls_;
    CellDistance cell_;
    std::span<const Step> simplex_;
    std::array<WitnessId, 8> successful_{};  // the last witnesses found, for the next simplex may be near
    std::size_t successes_ = 0;
    std::vector<std::uint32_t> pending_;
    std::uint32_t looked_at_ = 0;
};

}  // namespace plateau
