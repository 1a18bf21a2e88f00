#include "session/session.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>

#include "landmarks/noise_scale.h"
#include "session/engine.h"
#include "session/options.h"

namespace plateau {

namespace {

/// 12345 as "12,345".
std::string grouped(std::uint64_t number) {
    const std::string digits = std::to_string(number);
    std::string text;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % 3 == 0) text += ',';
        text += digits[i];
    }
    return text;
}

std::string in_megabytes(std::uint64_t bytes) {
    return grouped((bytes + (1u << 20) - 1) >> 20) + " MB";
}

}  // namespace

struct Session::State {
    State(PointCloud points, RunOptions run_options)
        : cloud(std::move(points)),
          options(std::move(run_options)),
          engine(cloud, engine_options(options, cloud.dimension)) {
        if (cloud.size() >= options.noise_stop_from) noise_scale.emplace(engine.lists());
    }

    PointCloud cloud;
    RunOptions options;
    Engine engine;
    bool prepared = false;
    RunState end = RunState::Running;  // Finished or Stopped once no more is to be inserted
    std::optional<Error> stopped;
    std::optional<NoiseScale> noise_scale;  // until the noise is known
    double noise = 0;                       // where the run ends by itself; 0: nowhere
    bool ended_at_noise = false;

    Step steps() const { return engine.timeline().step_count; }
    // The first landmarks need not wait for it.
    bool noise_is_due() const {
        return noise_scale && steps() >= std::min(1000u, NoiseScale::safe_landmarks(cloud.size()));
    }
    // Bytes taken from the system: tables that grew leave holes behind, and what is small is not counted. Measured: the
    // tables at most natively, 1.3 times the tables in the module.
    std::uint64_t memory() const { return engine.memory() / 10 * 13; }
    void measure_noise(const Deadline& deadline);
    void insert_next();
    std::string why_full() const;
};

Result<Session> Session::open(PointCloud cloud, const RunOptions& options) {
    auto checked = validated(std::move(cloud));
    if (!checked) return checked.error();
    PointCloud points = std::move(checked).value();
    auto complete = resolved(options, points);
    if (!complete) return complete.error();
    const std::uint64_t needed = estimated_memory(points.size(), 1, points.dimension, *complete.value().family);
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
    if (!s.prepared) s.prepared = s.engine.prepare(deadline);
    if (!s.prepared) return progress();

    std::uint32_t inserted = 0;
    do {
        if (s.noise_is_due()) {
            s.measure_noise(deadline);
        } else if (s.end == RunState::Running && inserted < budget.steps) {
            s.insert_next();
            ++inserted;
        } else {
            break;
        }
    } while (!deadline.passed());
    return progress();
}

void Session::State::insert_next() {
    const std::uint32_t next = steps() == 0 ? options.first : engine.farthest();
    if (auto failure = engine.insert(next)) {
        stopped = std::move(failure);
        end = RunState::Stopped;
        return;
    }
    const double epsilon_squared = engine.epsilon_squared();
    const double epsilon = std::sqrt(epsilon_squared);
    const bool done = steps() == std::min(cloud.size(), options.max_steps) || epsilon_squared == 0 ||
                      epsilon <= options.until_epsilon;
    ended_at_noise = !done && epsilon <= noise;
    if (done || ended_at_noise) {
        end = RunState::Finished;
    } else if (memory() > options.memory_limit) {
        stopped = Error{ErrorCode::OutOfMemory, why_full()};
        end = RunState::Stopped;
    }
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
    if (steps() < expected / 2) {
        why += "On a curve in space the Delaunay triangulation grows with the square of the number of landmarks. ";
    }
    return why + "All steps so far are complete.";
}

void Session::run_past_noise() {
    State& s = *state_;
    s.noise_scale.reset();
    s.noise = 0;
    if (s.ended_at_noise) s.end = RunState::Running;
    s.ended_at_noise = false;
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
std::uint64_t Session::hash() const {
    return state_->engine.hash();
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
