#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "base/result.h"
#include "cloud/point_cloud.h"
#include "dilated/dilated_complex.h"
#include "inspect/inspection.h"
#include "metrics/metric.h"
#include "plateaus/plateaus.h"
#include "timeline/timeline.h"

namespace plateau {

/// The largest k of a Betti number beta_k: simplices have at most 8 vertices.
inline constexpr std::uint32_t kMaxBetti = 6;

struct RunOptions {
    /// Default: Delaunay in the plane, Auto in space, Dilated in 4 and 5 dimensions unless nu or max_dimension is
    /// given; Witness then, in more dimensions and for every metric but Euclidean.
    std::optional<Family> family;
    MetricOptions metric;  ///< other ones than Euclidean are for family witness
    /// Family witness: the last Betti number, of simplices up to one dimension more; at most kMaxBetti. Default: 2 for
    /// a matrix, d for a periodic box, d - 1 for other coordinates, 2 where that is more than kMaxBetti.
    std::optional<std::uint32_t> max_dimension;
    std::vector<std::uint32_t> nu;  ///< nu_0, nu_1, ...; empty: the family's default
    std::uint32_t first = 0;        ///< 0-based input index of the first landmark
    std::uint32_t max_steps = std::numeric_limits<std::uint32_t>::max();
    double until_epsilon = 0;     ///< stop after the first step with epsilon <= this, input units
    DilatedOptions dilated = {};  ///< family dilated: radius of the witnesses, pumping
    double min_length = 0;        ///< stop where a plateau becomes this long, as Plateau::length() has it; 0 = off
    double rho = 0;               ///< surface: drop triangles with radius-edge ratio above this; 0 = off
    /// Families witness and dilated: a prime, at most 46337; Betti numbers over Z/field. Those over Z/2, or Z/3 where
    /// the field is 2, are counted beside them and tell torsion.
    std::uint32_t field = 2;
    std::uint64_t memory_limit = std::uint64_t{3} << 30;  ///< bytes the run may take; it stops when they are used up
    /// A cloud of at least this many points ends where epsilon falls to its noise, see Progress::noise. Default: never.
    std::uint32_t noise_stop_from = std::numeric_limits<std::uint32_t>::max();
};

/// How much run() does before it returns. Budgets decide when to return, never what is computed. Time may run out
/// within a step; it is gone on with at the next call, and shows nowhere before it is complete.
struct Budget {
    double milliseconds = std::numeric_limits<double>::infinity();
    std::uint32_t steps = std::numeric_limits<std::uint32_t>::max();
};

enum class RunState : std::uint8_t {
    Preparing = 0,  ///< building what distances come from; no step yet
    Running = 1,
    Finished = 2,  ///< all landmarks in, epsilon = 0, or a stop that the options asked for
    Stopped = 3,   ///< by the memory limit, or before the first step for want of distances; what was computed stays
};

struct Progress {
    RunState state = RunState::Preparing;
    Step steps_done = 0;
    Step steps_planned = 0;  ///< an upper bound: min(n, max_steps)
    double epsilon = 0;      ///< of the last complete step; 0 before the first
    /// The noise at which the run ends by itself: the median distance of a witness to its nearest other one. 0: there
    /// is no such stop, or it is not known yet; it is known before epsilon can fall to it.
    double noise = 0;
    bool ended_at_noise = false;    ///< Finished there; run_past_noise() goes on
    bool ended_at_plateau = false;  ///< Finished where one became long enough; run_to_next_plateau() goes on
    std::uint64_t memory = 0;       ///< bytes that the run holds now
    std::optional<Error> stopped;
};

/// Owner of a run: cloud in, timeline out, step by step. Cancelling is not calling run() again; the state stays usable.
class Session {
public:
    /// Validates cloud and options. Errors: those of validated(), InvalidOption, UnsupportedDimension, OutOfMemory
    /// when not even the first landmarks fit (the sentence says how much it takes). A cloud whose last landmarks will
    /// not fit is opened: see affordable_landmarks().
    static Result<Session> open(PointCloud cloud, const RunOptions& options);

    Session(Session&&) noexcept;
    Session& operator=(Session&&) noexcept;
    ~Session();

    /// Works until the budget is spent: at least one slice of preparation, one whole step with its Betti numbers, or a
    /// part of a long one.
    Progress run(const Budget& budget);
    Progress progress() const;
    /// Lifts the stop at the noise: the same run goes on to its end, nothing is computed again. Without such a stop it
    /// does nothing.
    void run_past_noise();
    /// The same run goes on until the next plateau is long enough, or to its end; nothing is computed again. Where it
    /// did not end at a plateau it does nothing.
    void run_to_next_plateau();

    const PointCloud& cloud() const;
    const RunOptions& options() const;  ///< with the defaults filled in
    const Timeline& timeline() const;
    std::vector<Plateau> plateaus() const { return find_plateaus(timeline()); }
    /// Why the simplex of these landmarks (steps, in any order) is in the complex shown at the step, or why not; see
    /// inspect_run(). What is computed further on is the same whether it is asked or not.
    Result<Inspection> inspect(Step step, std::vector<Step> vertices) const;
    /// 64-bit FNV-1a over all complete steps: (step, landmark, bits of epsilon, births and deaths, rows, Betti vector).
    std::uint64_t hash() const;
    /// The hash that the run had when so many steps were complete. Precondition: step <= step_count().
    std::uint64_t hash_at(Step step) const;

private:
    struct State;
    explicit Session(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// Bytes that so many landmarks of n points of at most 3 coordinates are expected to take, without the Delaunay
/// triangulation's worst case.
std::uint64_t estimated_memory(std::uint32_t points, std::uint32_t landmarks, std::uint32_t dimension, Family family);

/// Bytes of what estimated_memory() does not know of: a distance matrix, or coordinates beyond the third.
std::uint64_t input_memory(const PointCloud& cloud);

/// How many landmarks of n points are expected to fit into so many bytes; at most n.
std::uint32_t affordable_landmarks(std::uint32_t points, std::uint32_t dimension, Family family, std::uint64_t bytes);

}  // namespace plateau
