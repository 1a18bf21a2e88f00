#pragma once

#include <vector>

#include "base/deadline.h"
#include "landmarks/landmark_lists.h"

namespace plateau {

/// The noise of a cloud: the median over its witnesses of the distance to the nearest other witness, in input units.
/// Duplicates count as they are, at distance 0; of an even number of witnesses the mean of the middle two counts.
///
/// Asks what the landmark lists stand on, so that no second tree is built. Cost: O(n log n) with the tree, else n rows;
/// in slices.
class NoiseScale {
public:
    /// `lists` must be prepared and outlive this.
    explicit NoiseScale(const LandmarkLists& lists) : lists_(&lists) {}

    /// Works until the deadline passes, at least on a few witnesses; true when epsilon() is known.
    bool advance(const Deadline& deadline);
    double epsilon() const { return epsilon_; }

    /// Landmarks that can be inserted before epsilon may fall to the noise: at least n / 2 witnesses lie at least that
    /// far from each other, and a ball of that radius holds at most 13 such, so n / 26 balls are needed to hold all.
    /// That is so for Euclidean distances up to space; elsewhere a ball can hold any number, and none is safe.
    static std::uint32_t safe_landmarks(const PointCloud& cloud, Metric metric) {
        return metric == Metric::Euclidean && cloud.dimension <= 3 ? cloud.size() / 100 : 0;
    }

private:
    const LandmarkLists* lists_;
    std::vector<double> comparable_;
    double epsilon_ = 0;
};

}  // namespace plateau
