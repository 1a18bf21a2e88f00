#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "dilated/slivers.h"
#include "dilated/weighted_landmarks.h"
#include "dilated/witness_search.h"

namespace plateau {

/// Above this relative amplitude the cell of a landmark may be empty, and [BGO] proves nothing.
inline constexpr double kLargestSafeAmplitude = 0.5;

struct PumpOptions {
    double omega_bar = 0.25;               ///< omega(p) is at most this part of the distance to another landmark
    double dilation = 0.5881028419773636;  ///< zeta_2 / epsilon; the theory's is 6 sin(pi / 32)
    SliverMeasure measure = SliverMeasure::Literal;
};

/// What pumping a landmark came to.
struct Pump {
    double weight_squared = 0;  ///< omega(p)^2 as chosen, input units squared
    double before = 1;          ///< smallest sliver measure in the star of p at weight 0; 0 where p is hidden
    double after = 1;           ///< and at the chosen one
    std::uint32_t events = 0;  ///< simplices that were seen to enter or leave the star between weight 0 and the largest
    double amplitude = 0;      ///< relative amplitude of all weights at this step: largest omega(u) / |u - v|
};

/// Pumps the youngest landmark p [BGO 5.2]: of kPumpLevels + 1 evenly spaced values of omega(p)^2 from 0 to the largest
/// allowed one, the smallest of those at which the smallest sliver measure in the star of p, in the complex of radius
/// zeta_2, is largest.
///
/// The cell of a simplex with p only grows with the weight of p, that of one without p only shrinks. So a simplex is in
/// the star exactly from the largest first level of its faces with p to the smallest last level of its faces without
/// p, and both are found by bisection. Flat simplices come first: each takes its range from the levels that are left,
/// until one would take the last.
class Pumping {
public:
    static constexpr std::uint32_t kLevels = 1024;

    Pumping(WeightedLandmarks& landmarks, WitnessSearch& search, const PumpOptions& options)
        : landmarks_(&landmarks), search_(&search), options_(options) {}

    /// Chooses omega(p)^2 between 0 and `largest` and leaves it, plus `tie_breaking`, as the weight of p. `vertices`:
    /// the other landmarks that can be in its star, ascending. The amplitude is not filled in.
    Pump pump(double zeta, double largest, double tie_breaking, const std::vector<Step>& vertices);

private:
    struct Levels {  // at which a simplex is witnessed, both included; empty: first > last
        std::uint32_t first = 0, last = kLevels;
    };
    using Simplex = std::vector<Step>;

    bool is_witnessed(std::span<const Step> simplex, std::uint32_t level);
    bool may_be_witnessed(const Simplex& simplex);
    Levels own_levels(const Simplex& simplex);
    Levels star_levels(const Simplex& simplex);
    static std::vector<Levels> without(const std::vector<Levels>& ranges, const Levels& taken);
    void collect_star(const std::vector<Step>& vertices);

    WeightedLandmarks* landmarks_;
    WitnessSearch* search_;
    PumpOptions options_;
    Step p_ = 0;
    double zeta_ = 0, largest_ = 0, tie_breaking_ = 0;
    std::vector<Simplex> star_;         // all that can be in the star of p, of dimension 1 and more
    std::map<Simplex, bool> possible_;  // witnessed at the best level for it
    std::map<Simplex, Levels> levels_;  // as far as they are known
    std::uint32_t events_ = 0;
};

}  // namespace plateau
