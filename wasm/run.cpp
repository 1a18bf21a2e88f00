#include "run.h"

#include <algorithm>
#include <new>
#include <utility>

#include "cloud/samples.h"
#include "delta.h"
#include "exports.h"
#include "inspection.h"
#include "io/family_name.h"
#include "io/metric_name.h"
#include "io/saved_options.h"
#include "marshal.h"
#include "options.h"
#include "projection/projection.h"

namespace plateau {

using emscripten::val;
using marshal::copied;

namespace {

constexpr const char* kStateNames[] = {"preparing", "running", "finished", "stopped"};

val projected(const PointCloud& cloud) {
    const Projection projection = projection_of(cloud);
    val answer = val::object();
    answer.set("axes", projection.axes);
    answer.set("coordinates", copied(std::span<const float>(projection.coordinates)));
    answer.set("shares", val::array(projection.shares));
    return answer;
}

Error not_open() {
    return {ErrorCode::Internal, "The run is not open."};
}

}  // namespace

Run::Run(const val& source, const val& options) {
    auto read_options = marshal::run_options_of(options);
    if (!read_options) {
        error_ = read_options.error();
        return;
    }
    options_ = std::move(read_options).value();
    if (source["kind"].as<std::string>() == "sample") {
        auto cloud = marshal::sample_of(source);
        if (cloud) {
            sample_ = std::move(cloud).value();
        } else {
            error_ = cloud.error();
        }
        return;
    }
    ReadOptions read;
    if (const val columns = source["columns"]; marshal::given(columns)) {
        auto list = marshal::counts_of(columns, "Each column");
        if (!list) {
            error_ = list.error();
            return;
        }
        read.columns = std::move(list).value();
    }
    if (const val any = source["anyDimension"]; marshal::given(any) && any.as<bool>()) {
        read.as = ReadAs::PointsOfAnyDimension;
    }
    if (const val other = source["newOptions"]; marshal::given(other)) takes_new_options_ = other.as<bool>();
    if (options_.metric.metric == Metric::Matrix) read.as = ReadAs::Distances;
    read.memory_limit = options_.memory_limit;
    try {
        reader_.emplace(marshal::bytes_of(source["bytes"]), source["name"].as<std::string>(), read);
    } catch (const std::bad_alloc&) {
        error_ = {ErrorCode::OutOfMemory, "The file does not fit into the memory of this page."};
    }
}

val Run::open(double budget_ms) {
    return marshal::guarded([&] {
        if (error_) return marshal::failed(*error_);
        if (sample_) return opened_with(*std::exchange(sample_, std::nullopt), {});
        if (!reader_) return marshal::failed({ErrorCode::Internal, "The run is open already."});
        if (!reader_->advance(budget_ms)) {
            val reading = val::object();
            reading.set("kind", std::string("reading"));
            return reading;
        }
        auto read = reader_->take();
        reader_.reset();
        if (!read) {
            error_ = read.error();
            return marshal::failed(*error_);
        }
        if (read.value().saved && !takes_new_options_) {
            if (auto error = take_options_of(std::move(*read.value().saved))) {
                error_ = std::move(error);
                return marshal::failed(*error_);
            }
        }
        return opened_with(std::move(read.value().cloud), read.value().warnings);
    });
}

std::optional<Error> Run::take_options_of(SavedRun saved) {
    auto options = options_of(saved);
    if (!options) return options.error();
    const std::uint64_t memory_limit = options_.memory_limit;
    options_ = std::move(options).value();
    options_.memory_limit = memory_limit;
    saved_ = std::move(saved);
    return std::nullopt;
}

val Run::opened_with(PointCloud cloud, const std::vector<std::string>& warnings) {
    auto session = Session::open(std::move(cloud), options_);
    if (!session) {
        error_ = session.error();
        return marshal::failed(*error_);
    }
    session_.emplace(std::move(session).value());
    const PointCloud& points = session_->cloud();
    const RunOptions& options = session_->options();
    const Family family = session_->timeline().family;
    val opened = val::object();
    opened.set("points", points.size());
    opened.set("dimension", points.dimension);
    opened.set("bettiCount", session_->timeline().dimension);
    opened.set("field", options.field);
    opened.set("otherField", session_->timeline().other_field);
    opened.set("metric", std::string(metric_name(options.metric.metric)));
    opened.set("coordinates", copied(std::span<const double>(points.coordinates)));
    if (points.dimension == 0 || points.dimension > 3) opened.set("projection", projected(points));
    opened.set("family", std::string(family_name(family)));
    opened.set("nu", val::array(options.nu));
    const Step planned = session_->progress().steps_planned;
    const std::uint64_t input = input_memory(points);
    const std::uint64_t needed = estimated_memory(points.size(), planned, points.dimension, family) + input;
    const Step affordable = affordable_landmarks(points.size(), points.dimension, family, options.memory_limit - input);
    opened.set("stepsPlanned", planned);
    opened.set("estimatedBytes", static_cast<double>(needed));
    opened.set("memoryLimitBytes", static_cast<double>(options.memory_limit));
    opened.set("stepsAffordable", std::min(planned, affordable));
    opened.set("warnings", val::array(warnings));
    if (saved_) opened.set("session", marshal::session_of(*saved_, options));
    val answer = val::object();
    answer.set("kind", std::string("opened"));
    answer.set("opened", opened);
    return answer;
}

val Run::run(double budget_ms, std::uint32_t max_steps) {
    return marshal::guarded([&] {
        if (!session_) return marshal::failed(not_open());
        const Progress progress = session_->run({budget_ms, max_steps});
        val answer = val::object();
        answer.set("kind", std::string("progress"));
        answer.set("state", std::string(kStateNames[static_cast<std::size_t>(progress.state)]));
        answer.set("stepsDone", progress.steps_done);
        answer.set("stepsPlanned", progress.steps_planned);
        answer.set("epsilon", progress.epsilon);
        if (progress.stopped) answer.set("stopped", marshal::failure(*progress.stopped));
        return answer;
    });
}

val Run::run_past_noise() {
    return marshal::guarded([&] {
        if (!session_) return marshal::failed(not_open());
        session_->run_past_noise();
        val answer = val::object();
        answer.set("kind", std::string("lifted"));
        return answer;
    });
}

val Run::delta(std::uint32_t max_simplices) {
    return marshal::guarded([&] {
        if (!session_) return marshal::failed(not_open());
        const Timeline& timeline = session_->timeline();
        const Progress progress = session_->progress();
        const Step done = handed_out_;
        const Step end = marshal::delta_end(timeline, done, max_simplices);
        const bool complete = end == timeline.step_count;
        const RunState state = complete || progress.steps_done == 0 ? progress.state : RunState::Running;

        val delta = val::object();
        delta.set("state", std::string(kStateNames[static_cast<std::size_t>(state)]));
        if (complete && progress.stopped) delta.set("stopped", marshal::failure(*progress.stopped));
        // Before the hash of all steps, which it is a part of.
        if (saved_ && !agrees_) agrees_ = agrees(*saved_, *session_);
        if (agrees_) delta.set("agreesWithSession", *agrees_);
        delta.set("hash", marshal::hex(session_->hash()));
        delta.set("memoryBytes", static_cast<double>(progress.memory));
        delta.set("noise", progress.noise);
        delta.set("endedAtNoise", complete && progress.ended_at_noise);
        marshal::add_record(delta, timeline, done, end);
        handed_out_ = end;
        return delta;
    });
}

val Run::plateaus() const {
    return marshal::guarded([&] {
        if (!session_) return marshal::failed(not_open());
        const std::vector<Plateau> found = session_->plateaus();
        std::vector<std::uint32_t> first_step, last_step, middle, betti, torsion;
        std::vector<double> epsilon_first, epsilon_last, ratio;
        std::vector<std::uint8_t> family;
        for (const Plateau& plateau : found) {
            first_step.push_back(plateau.first_step);
            last_step.push_back(plateau.last_step);
            middle.push_back(middle_step(session_->timeline(), plateau));
            epsilon_first.push_back(plateau.epsilon_first);
            epsilon_last.push_back(plateau.epsilon_last);
            ratio.push_back(plateau.ratio);
            family.push_back(static_cast<std::uint8_t>(plateau.family));
            betti.insert(betti.end(), plateau.betti.begin(), plateau.betti.end());
            torsion.insert(torsion.end(), plateau.torsion.begin(), plateau.torsion.end());
            torsion.resize(betti.size(), 0);
        }
        const std::vector<std::uint32_t> order = ranked(found);
        val out = val::object();
        out.set("firstStep", copied(std::span<const std::uint32_t>(first_step)));
        out.set("lastStep", copied(std::span<const std::uint32_t>(last_step)));
        out.set("middleStep", copied(std::span<const std::uint32_t>(middle)));
        out.set("epsilonFirst", copied(std::span<const double>(epsilon_first)));
        out.set("epsilonLast", copied(std::span<const double>(epsilon_last)));
        out.set("ratio", copied(std::span<const double>(ratio)));
        out.set("family", copied(std::span<const std::uint8_t>(family)));
        out.set("betti", copied(std::span<const std::uint32_t>(betti)));
        out.set("torsion", copied(std::span<const std::uint32_t>(torsion)));
        out.set("ranked", copied(std::span<const std::uint32_t>(order)));
        return out;
    });
}

val Run::export_with_view(const std::string& format, const val& step, const val& view) const {
    return marshal::guarded([&] {
        if (!session_) return marshal::failed(not_open());
        const auto bytes = marshal::exported(*session_, format, step, view);
        if (!bytes) return marshal::failed(bytes.error());
        val answer = val::object();
        answer.set("kind", std::string("file"));
        answer.set("bytes", marshal::copied_bytes(bytes.value()));
        return answer;
    });
}

val Run::export_file(const std::string& format, const val& step) const {
    return export_with_view(format, step, val::undefined());
}

val Run::inspect(const val& step, const val& vertices) const {
    return marshal::guarded([&] {
        if (!session_) return marshal::failed(not_open());
        const auto at = marshal::count_of(step, "The step");
        if (!at) return marshal::failed(at.error());
        auto landmarks = marshal::counts_of(vertices, "Each landmark");
        if (!landmarks) return marshal::failed(landmarks.error());
        const auto inspection = session_->inspect(at.value(), std::move(landmarks).value());
        if (!inspection) return marshal::failed(inspection.error());
        val answer = val::object();
        answer.set("kind", std::string("inspection"));
        answer.set("inspection", marshal::inspection_of(inspection.value(), 1));
        return answer;
    });
}

std::string Run::hash() const {
    return session_ ? marshal::hex(session_->hash()) : std::string(16, '0');
}

val sample_list() {
    val list = val::array();
    for (const SampleShape& shape : sample_shapes()) {
        val entry = val::object();
        entry.set("name", std::string(shape.name));
        entry.set("dimension", shape.dimension);
        entry.set("defaultSize", shape.default_size);
        entry.set("lookFor", std::string(shape.look_for));
        list.call<void>("push", entry);
    }
    return list;
}

}  // namespace plateau
