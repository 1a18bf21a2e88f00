#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/slice.h"
#include "complex/simplex_books.h"
#include "complex/simplex_table.h"
#include "dilated/cell_distance.h"
#include "dilated/pumping.h"
#include "dilated/weighted_landmarks.h"
#include "dilated/witness_search.h"
#include "landmarks/landmark_lists.h"

namespace plateau {

/// zeta_1 / epsilon of the theory, (3/8) sin(pi / 32) [BGO 5.2]. It asks for samples far denser than usual ones.
inline constexpr double kTheoryDilation = 0.036756427623585226;

struct DilatedOptions {
    double dilation = 0.2;  ///< zeta / epsilon: witnesses are balls of radius zeta
    bool pumps = false;     ///< else all weights are 0, but for what breaks ties
    PumpOptions pump;
};

/// The weighted witness complex with dilated witnesses [BGO], under insertion of landmarks. A simplex sigma is in it
/// iff t(sigma) <= zeta and all its facets are in it, where t(sigma) is the distance of the nearest witness to the cell
/// of sigma (see CellDistance) and zeta falls with epsilon. A landmark is a vertex iff it has such a witness itself.
///
/// Weights never change and cells are only cut by the new landmark, so t(sigma) only grows while zeta only falls: a
/// simplex lives once, from the step of its youngest vertex. Of each living one a watched witness and its nearest point
/// in the cell are known; t(sigma) is looked at again only when the new landmark cuts that point off or zeta falls
/// below its distance.
class DilatedComplex {
public:
    DilatedComplex(std::uint32_t dimension, const DilatedOptions& options);

    /// Follows one insertion. `lists` after the insertion of the landmark `witness` of `step`, by a tree, with kappa >=
    /// 2; epsilon after it. Appends births to `tables` (one a dimension, 1 first, up to that of the cloud) and sets
    /// deaths there. False where the slice is used up: then it is to be called again with the same arguments, until it
    /// is true, and goes on where it was.
    bool insert(Step step, WitnessId witness, double epsilon, const LandmarkLists& lists,
                std::vector<SimplexTable>& tables, Slice& slice);

    /// Deaths of the last step by (dimension, tuple).
    std::span<const Death> deaths() const { return deaths_; }
    /// Landmarks that stopped being vertices at the last step, or never were one, ascending.
    std::span<const Step> hidden() const { return hidden_; }
    const SimplexBooks& books() const { return books_; }
    /// omega(p)^2, and where the landmarks are.
    const WeightedLandmarks& landmarks() const { return landmarks_; }
    /// The last pump; all defaults where landmarks are not pumped.
    const Pump& pump() const { return pump_; }
    std::uint64_t memory() const;

private:
    struct Living {
        SimplexIndex simplex = 0;  // of a vertex: its step
        Watch watch;
    };
    struct Tables {
        Step step;
        std::vector<SimplexTable>& of_dimension;
        SimplexTable& operator[](std::size_t k) { return of_dimension[k - 1]; }
    };

    enum class Phase : std::uint8_t { Idle, Weigh, Lose, BearVertex, Bear };
    /// Where an insertion is.
    struct Place {
        Phase phase = Phase::Idle;
        std::size_t k = 0;        // dimension that is lost or born
        std::size_t next = 0;     // losing: the simplex to look at; bearing: the other end, or the first of two facets
        std::size_t partner = 0;  // bearing: the second of them; 0: none yet
        std::size_t kept = 0;     // losing: how many so far go on living
        double reach = 0;         // bearing edges
    };

    std::span<const Step> tuple(std::size_t k, const SimplexIndex& simplex, Tables& tables) const;
    bool is_dead(std::size_t k, SimplexIndex simplex, Tables& tables) const;
    void begin_pumping(Step step, double epsilon);
    bool weigh(Slice& slice);
    bool lose(double zeta, Tables& tables, Slice& slice);
    void sort_deaths(Tables& tables);
    void kill(std::size_t k, SimplexIndex simplex, Tables& tables);
    void bear_vertex(double zeta, Step step);
    bool bear_edges(double zeta, Tables& tables, Slice& slice);
    bool bear(std::size_t k, double zeta, Tables& tables, Slice& slice);
    void bear_one(std::size_t k, std::span<const Step> simplex, std::span<const SimplexIndex> facets,
                  const Watch& watch, Tables& tables);

    DilatedOptions options_;
    WeightedLandmarks landmarks_;
    SimplexBooks books_;
    std::optional<WitnessSearch> search_;
    std::vector<std::vector<Living>> living_;  // by dimension, from 0
    std::vector<Step> hidden_since_;           // by landmark, from 1; kNever: a vertex
    std::vector<double> nearest_squared_;      // by landmark, from 1: squared distance to the nearest other one
    Place place_;
    std::optional<Pumping> pumping_;
    Pump pump_;
    std::vector<Death> deaths_;
    std::vector<Step> hidden_;
};

}  // namespace plateau
