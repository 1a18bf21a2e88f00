#pragma once

#include <cstdint>
#include <span>

#include "dilated/weighted_landmarks.h"

namespace plateau {

/// How flat a simplex is.
enum class SliverMeasure : std::uint8_t {
    Literal = 0,     ///< vol / (shortest edge)^k, as [BGO] has it
    Normalized = 1,  ///< (k! vol / (shortest edge)^k)^(1/k), so that dimensions can be compared
};

/// The sliver measure of a simplex of dimension k = 0 .. 5; 1 for vertices and edges. From + - * / and square roots
/// alone.
double sliver_measure(std::span<const Step> simplex, const WeightedLandmarks& landmarks, SliverMeasure measure);

}  // namespace plateau
