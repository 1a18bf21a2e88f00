#include "session/session.h"

#include <algorithm>
#include <array>
#include <bit>
#include <string>

#include "base/words.h"
#include "inspect/inspect_run.h"
#include "landmarks/noise_scale.h"
#include "metrics/distance_rows.h"
#include "plateaus/plateau_watch.h"
#include "session/engine.h"
#include "session/options.h"

namespace plateau {

struct Session::State {
    State(PointCloud points, RunOptions run_options)
        : cloud(std::move(points)),
          options(std::move(run_options)),
          engine(cloud, engine_options(options, cloud.dimension)),
          matrix_bytes(cloud.distances.memory()) {
        if (options.min_length > 0) watch.emplace(options.min_length);
        if (cloud.size() >= options.noise_stop_from) noise_scale.emplace(engine.lists());
    }

    PointCloud cloud;
    RunOptions options;
    Engine engine;
    std::uint64_t matrix_bytes;
    bool prepared = false;
    RunState end = RunState::Running;  // Finished or Stopped once no more is to be inserted
    std::optional<Error> stopped;
    std::optional<NoiseScale> noise_scale;  // until the noise is known
    double noise = 0;                       // where the run ends by itself; 0: nowhere
    bool ended_at_noise = false;
    std::optional<PlateauWatch> watch;
    bool ended_at_plateau = false;

    Step steps() const { return engine.timeline().step_count; }
    // The first landmarks need not wait for it.
    bool noise_is_due() const {
        return noise_scale && steps() >= std::min(1000u, NoiseScale::safe_landmarks(cloud, options.metric.metric));
    }
    // Bytes taken from the system: tables that grew leave holes behind, and what is small is not counted. Measured: the
    // tables at most natively, 1.3 times the tables in the module.
    std::uint64_t memory() const { return engine.memory() / 10 * 13 + matrix_bytes; }
    void measure_noise(const Deadline& deadline);
    bool insert_next(const Deadline& deadline);
    std::string why_full() const;
};

Result<Session> Session::open(PointCloud cloud, const RunOptions& options) {
    auto checked = validated(std::move(cloud));
    if (!checked) return checked.error();
    PointCloud points = std::move(checked).value();
    auto complete = resolved(options, points);
    if (!complete) return complete.error();
    const std::uint64_t needed = estimated_memory(points.size(), 1, points.dimension, *complete.value().family) +
                                 input_memory(points) + estimated_rows_memory(points, complete.value().metric);
    if (needed > complete.value().memory_limit) {
        return Error{ErrorCode::OutOfMemory,
                     grouped(points.size()) + " points alone need about " + in_megabytes(needed) + ", but only " +
                         in_megabytes(complete.value().memory_limit) + " may be used: take a sample of the points."};
    }
    return Session(std::make_unique<State>(std::move(points), std::move(complete).value()));
}

Session::Session(std::unique_ptr<State> state) : state_(std::move(state)) {}
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;
Session::~Session() = default;

Progress Session::run(const Budget& budget) {
    State& s = *state_;
    const Deadline deadline(budget.milliseconds);
    if (!s.prepared) {
        s.prepared = s.engine.prepare(deadline);
        if (!s.prepared) return progress();
        s.stopped = s.engine.failure();
        if (s.stopped) s.end = RunState::Stopped;
    }

    std::uint32_t inserted = 0;
    do {
        if (s.end != RunState::Stopped && s.noise_is_due()) {
            s.measure_noise(deadline);
        } else if (s.end == RunState::Running && inserted < budget.steps) {
            if (!s.insert_next(deadline)) break;
            ++inserted;
        } else {
            break;
        }
    } while (!deadline.passed());
    return progress();
}

// Goes on with a step that was begun, or begins the next; false where the deadline ends it.
bool Session::State::insert_next(const Deadline& deadline) {
    if (!engine.in_step()) {
        const std::uint32_t next = steps() == 0 ? options.first : engine.farthest();
        if (auto failure = engine.begin_step(next)) {
            stopped = std::move(failure);
            end = RunState::Stopped;
            return true;
        }
    }
    if (!engine.finish_step(deadline)) return false;
    const double epsilon = engine.timeline().epsilon(steps());
    const bool done = steps() == std::min(cloud.size(), options.max_steps) || epsilon <= options.until_epsilon;
    ended_at_plateau = watch && watch->follow(engine.timeline()) && !done;
    ended_at_noise = !done && !ended_at_plateau && epsilon <= noise;
    if (done || ended_at_noise || ended_at_plateau) {
        end = RunState::Finished;
    } else if (memory() > options.memory_limit) {
        stopped = Error{ErrorCode::OutOfMemory, why_full()};
        end = RunState::Stopped;
    }
    return true;
}

void Session::State::measure_noise(const Deadline& deadline) {
    if (!noise_scale->advance(deadline)) return;
    noise = noise_scale->epsilon();
    noise_scale.reset();
}

std::string Session::State::why_full() const {
    std::string why = "Stopped after " + grouped(steps()) + " of " + grouped(cloud.size()) +
                      " landmarks: the run holds " + in_megabytes(memory()) + ", all that it may take. ";
    const std::uint32_t expected =
        affordable_landmarks(cloud.size(), cloud.dimension, *options.family, options.memory_limit);
    if (is_within_delaunay(*options.family) && steps() < expected / 2) {
        why += "On a curve in space the Delaunay triangulation grows with the square of the number of landmarks. ";
    }
    return why + "All steps so far are complete.";
}

void Session::run_past_noise() {
    State& s = *state_;
    s.noise_scale.reset();
    s.noise = 0;
    s.options.noise_stop_from = RunOptions{}.noise_stop_from;
    if (s.ended_at_noise) s.end = RunState::Running;
    s.ended_at_noise = false;
}

void Session::run_to_next_plateau() {
    State& s = *state_;
    if (s.ended_at_plateau) s.end = RunState::Running;
    s.ended_at_plateau = false;
}

Progress Session::progress() const {
    const State& s = *state_;
    const Timeline& timeline = s.engine.timeline();
    Progress progress;
    if (s.prepared) progress.state = s.end;
    progress.steps_done = timeline.step_count;
    progress.steps_planned = std::min(s.cloud.size(), s.options.max_steps);
    progress.epsilon = timeline.step_count == 0 ? 0 : timeline.epsilon(timeline.step_count);
    progress.noise = s.noise;
    progress.ended_at_noise = progress.state == RunState::Finished && s.ended_at_noise;
    progress.ended_at_plateau = progress.state == RunState::Finished && s.ended_at_plateau;
    progress.memory = s.memory();
    if (progress.state == RunState::Stopped) progress.stopped = s.stopped;
    return progress;
}

const PointCloud& Session::cloud() const {
    return state_->cloud;
}
const RunOptions& Session::options() const {
    return state_->options;
}
const Timeline& Session::timeline() const {
    return state_->engine.timeline();
}
Result<Inspection> Session::inspect(Step step, std::vector<Step> vertices) const {
    const RunOptions& options = state_->options;
    const EngineOptions engine = engine_options(options, state_->cloud.dimension);
    const RunBasis basis{state_->cloud, options.metric, engine.nu, options.dilated.dilation, options.rho};
    return inspect_run(basis, timeline(), step, std::move(vertices));
}
std::uint64_t Session::hash() const {
    return state_->engine.hash_at(timeline().step_count);
}
std::uint64_t Session::hash_at(Step step) const {
    return state_->engine.hash_at(step);
}

namespace {

/// Bytes, fitted to what runs over tori hold, the worst of the usual clouds, and over squares for the plane.
struct MemoryShares {
    std::uint64_t witness;   ///< a point, landmark or not: coordinates, tree, list
    std::uint64_t doubling;  ///< a point, each time that the landmarks have doubled: its list has changed
    std::uint64_t landmark;  ///< with its simplices and cells
};

MemoryShares shares_of(std::uint32_t dimension, Family family) {
    if (family == Family::Witness) return {440, 8, 900};
    if (family == Family::Dilated) {
        // Between surfaces and what has as many dimensions as fit, which has more simplices a landmark.
        constexpr std::array<std::uint64_t, kMaxDilatedDimension + 1> kLandmark = {1200, 1200, 1200, 2000, 4700, 9000};
        return {160, 0, kLandmark[std::min<std::size_t>(dimension, kMaxDilatedDimension)]};
    }
    if (dimension == 2) return {300, 13, 1300};
    if (family == Family::Delaunay) return {410, 26, 6700};
    return {410, 26, 9000};
}

}  // namespace

std::uint64_t estimated_memory(std::uint32_t points, std::uint32_t landmarks, std::uint32_t dimension, Family family) {
    const MemoryShares shares = shares_of(dimension, family);
    const auto doublings = static_cast<std::uint64_t>(std::bit_width(landmarks));
    return points * (shares.witness + shares.doubling * doublings) + landmarks * shares.landmark;
}

std::uint64_t input_memory(const PointCloud& cloud) {
    // As given and in the order of the tree, whose boxes have two more numbers a third of the points.
    constexpr std::uint64_t kBytesPerAxis = 22;
    const std::uint64_t more_axes = std::max(cloud.dimension, 3u) - 3;
    return cloud.distances.memory() + cloud.size() * more_axes * kBytesPerAxis;
}

std::uint32_t affordable_landmarks(std::uint32_t points, std::uint32_t dimension, Family family, std::uint64_t bytes) {
    std::uint32_t low = 0;
    std::uint32_t high = points;
    while (low < high) {
        const std::uint32_t middle = low + (high - low + 1) / 2;
        if (estimated_memory(points, middle, dimension, family) <= bytes) {
            low = middle;
        } else {
            high = middle - 1;
        }
    }
    return low;
}

}  // namespace plateau
