#pragma once

#include <cstdint>
#include <vector>

#include "timeline/timeline.h"

namespace plateau {

/// A maximal run of steps with one shown family and one Betti vector, the complex not empty.
struct Plateau {
    Step first_step = 0;
    Step last_step = 0;
    double epsilon_first = 0;  ///< epsilon(first_step), input units
    double epsilon_last = 0;   ///< epsilon(last_step)
    double ratio = 1;          ///< epsilon+(first) / epsilon+(last+1) >= 1; ranked by this
    Family family = Family::Delaunay;
    std::vector<std::uint32_t> betti;
    /// Torsion: the Betti numbers over Z/Timeline::other_field that last longest within the plateau (of equal ones the
    /// first), where they differ from `betti`; else empty.
    std::vector<std::uint32_t> torsion;

    /// ln(ratio): the length on a logarithmic scale axis. For print only, never for order.
    double length() const;
};

/// The plateaus of the steps so far, in step order. epsilon+ is epsilon, or the last positive epsilon where it is 0 or
/// not yet known; with no positive epsilon every ratio is 1. Cost: O(steps).
std::vector<Plateau> find_plateaus(const Timeline& timeline);

/// Indices into `plateaus`, the longest first; equal ratios keep step order.
std::vector<std::uint32_t> ranked(const std::vector<Plateau>& plateaus);

/// The first step with epsilon <= sqrt(epsilon(first) * epsilon(last)), clamped to the plateau: where to look at it.
Step middle_step(const Timeline& timeline, const Plateau& plateau);

}  // namespace plateau
