#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/slice.h"
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
    /// Weights at which a simplex, or a face of one, was found to enter or leave the star. Flat simplices are looked at
    /// first and mostly settle the choice: these are not all events between weight 0 and the largest [BGO 5.4.2].
    std::uint32_t thresholds = 0;
    double amplitude = 0;  ///< relative amplitude of all weights at this step: largest omega(u) / |u - v|
};

/// Pumps the youngest landmark p [BGO 5.2]: of kLevels + 1 evenly spaced values of omega(p)^2 from 0 to the largest
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

    /// Is to choose omega(p)^2 between 0 and `largest`. What p weighs now breaks ties, and is added to all of them.
    void begin(double zeta, double largest);
    /// Goes on until the slice is used up; true when the choice is made and, plus what breaks ties, is the weight of p.
    bool advance(Slice& slice);
    /// What was chosen, once advance() is true. The amplitude is not filled in.
    const Pump& result() const { return pump_; }

private:
    struct Levels {  // at which a simplex is witnessed, both included; empty: first > last
        std::uint32_t first = 0, last = kLevels;
    };
    using Simplex = std::vector<Step>;

    enum class Phase : std::uint8_t { Begin, Edges, Star, Vertex, Choice, Done };

    std::optional<bool> is_witnessed(std::span<const Step> simplex, std::uint32_t level, Slice& slice);
    std::optional<bool> may_be_witnessed(const Simplex& simplex, Slice& slice);
    std::optional<Levels> own_levels(const Simplex& simplex, Slice& slice);
    std::optional<Levels> star_levels(const Simplex& simplex, Slice& slice);
    static std::vector<Levels> without(const std::vector<Levels>& ranges, const Levels& taken);
    bool collect_edges(Slice& slice);
    bool collect_star(Slice& slice);
    std::optional<bool> may_be_in_star(const Simplex& simplex, Slice& slice);
    void sort_star();
    bool choose(Slice& slice);

    WeightedLandmarks* landmarks_;
    WitnessSearch* search_;
    PumpOptions options_;
    Step p_ = 0;
    double zeta_ = 0, largest_ = 0, tie_breaking_ = 0;
    std::vector<Simplex> star_;         // all that can be in the star of p, of dimension 1 and more
    std::map<Simplex, bool> possible_;  // witnessed at the best level for it
    std::map<Simplex, Levels> levels_;  // as far as they are known
    Pump pump_;
    std::optional<Levels> halving_;  // between which levels a simplex enters or leaves, while that is looked for
    // Where it is. What is known of a simplex is kept, so that a part of the way that is gone twice costs no search.
    Phase phase_ = Phase::Begin;
    double reach_ = 0;
    std::size_t dimension_ = 2;           // of the simplices that are collected
    std::size_t next_ = 0, partner_ = 0;  // the vertex, the two facets or the flat simplex to look at
    std::size_t end_ = 0;                 // of the facets in star_
    std::vector<std::pair<double, Simplex>> flattest_first_;
    std::vector<Levels> left_;  // at which p is a vertex and no simplex so far is in its star
    bool before_is_known_ = false;
};

}  // namespace plateau
