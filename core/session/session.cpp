#include "session/session.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "session/engine.h"
#include "session/options.h"

namespace plateau {

namespace {

std::string in_megabytes(std::uint64_t bytes) {
    const std::string digits = std::to_string((bytes + (1u << 20) - 1) >> 20);
    std::string grouped;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % 3 == 0) grouped += ',';
        grouped += digits[i];
    }
    return grouped + " MB";
}

}  // namespace

struct Session::State {
    State(PointCloud points, RunOptions run_options)
        : cloud(std::move(points)),
          options(std::move(run_options)),
          engine(cloud, engine_options(options, cloud.dimension)) {}

    PointCloud cloud;
    RunOptions options;
    Engine engine;
    bool prepared = false;
    RunState end = RunState::Running;  // Finished or Stopped once no more is to be inserted
    std::optional<Error> stopped;

    Step steps() const { return engine.timeline().step_count; }
    void insert_next();
};

Result<Session> Session::open(PointCloud cloud, const RunOptions& options) {
    auto checked = validated(std::move(cloud));
    if (!checked) return checked.error();
    PointCloud points = std::move(checked).value();
    auto complete = resolved(options, points);
    if (!complete) return complete.error();
    const std::uint64_t needed = estimated_memory(points.size(), points.dimension, *complete.value().family);
    if (needed > complete.value().memory_limit) {
        return Error{ErrorCode::OutOfMemory, std::to_string(points.size()) + " points need about " +
                                                 in_megabytes(needed) + ", but only " +
                                                 in_megabytes(complete.value().memory_limit) +
                                                 " may be used: take a sample of the points, or another family."};
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
        if (s.end != RunState::Running || inserted == budget.steps) break;
        s.insert_next();
        ++inserted;
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
    const bool done = steps() == std::min(cloud.size(), options.max_steps) || epsilon_squared == 0 ||
                      std::sqrt(epsilon_squared) <= options.until_epsilon;
    if (done) {
        end = RunState::Finished;
    } else if (engine.memory() > options.memory_limit) {
        stopped = Error{ErrorCode::OutOfMemory,
                        "Stopped after " + std::to_string(steps()) + " of " + std::to_string(cloud.size()) +
                            " points: the run holds more than " + in_megabytes(options.memory_limit) +
                            ". On a curve in space the Delaunay triangulation grows with the square of the number of "
                            "landmarks. All steps so far are complete."};
        end = RunState::Stopped;
    }
}

Progress Session::progress() const {
    const State& s = *state_;
    const Timeline& timeline = s.engine.timeline();
    Progress progress;
    if (s.prepared) progress.state = s.end;
    progress.steps_done = timeline.step_count;
    progress.steps_planned = std::min(s.cloud.size(), s.options.max_steps);
    progress.epsilon = timeline.step_count == 0 ? 0 : timeline.epsilon(timeline.step_count);
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

std::uint64_t estimated_memory(std::uint32_t points, std::uint32_t dimension, Family family) {
    // Peak bytes a point of whole processes, measured on tori of 20,000 and 100,000 points, the worst of the usual
    // clouds (a uniform cube takes half), on squares for the plane.
    std::uint64_t per_point = dimension == 2 ? 1200 : 10500;
    if (family == Family::Auto || family == Family::Surface) per_point = 12000;
    if (family == Family::Witness) per_point = 2500;
    return points * per_point;
}

}  // namespace plateau
