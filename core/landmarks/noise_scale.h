#pragma once

#include <vector>

#include "base/deadline.h"
#include "landmarks/landmark_lists.h"

namespace plateau {

/// The noise of a cloud: the median over its witnesses of the distance to the nearest other witness, in input units.
/// Duplicates count as they are, at distance 0; of an even number of witnesses the mean of the middle two counts.
///
/// Asks the tree that the landmark lists stand on, so that no second one is built. Cost: O(n log n), in slices.
class NoiseScale {
public:
    /// `lists` must be prepared and outlive this.
    explicit NoiseScale(const LandmarkLists& lists) : lists_(&lists) {}

    /// Works until the deadline passes, at least on a few witnesses; true when epsilon() is known.
    bool advance(const Deadline& deadline);
    double epsilon() const { return epsilon_; }

    /// Landmarks that can be inserted before epsilon may fall to the noise: at least n / 2 witnesses lie at least that
    /// far from each other, and a ball of that radius holds at most 13 such, so n / 26 balls are needed to hold all.
    static std::uint32_t safe_landmarks(std::uint32_t witnesses) { return witnesses / 100; }

private:
    const LandmarkLists* lists_;
    std::vector<double> distances_squared_;
    double epsilon_ = 0;
};

}  // namespace plateau
