#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/files.h"
#include "cli/open_input.h"
#include "cli/progress_line.h"
#include "cli/saved_session.h"
#include "io/complex_vtk.h"
#include "io/mesh_files.h"
#include "io/report_json.h"
#include "io/step_mesh.h"
#include "io/writers.h"

namespace plateau::cli {
namespace {

std::optional<Error> check_outputs(const RunArguments& arguments) {
    for (const std::string* path : arguments.outputs()) {
        if (auto error = check_writable(*path)) return error;
    }
    return std::nullopt;
}

Error out_of_range(Step at, Step steps) {
    return {ErrorCode::InvalidOption,
            "--at " + std::to_string(at) + " is out of range: the run has " + std::to_string(steps) + " steps."};
}

struct Ended {
    Progress progress;
    std::uint32_t plateaus;  // that were long enough, on the way and at the end
};

/// Steps until the end, the n-th plateau that is long enough, or until the user interrupts.
Ended run_to_end(Session& session, std::uint32_t nth, bool show_progress) {
    ProgressLine line(show_progress);
    std::uint32_t plateaus = 0;
    Progress progress = session.progress();
    while (progress.state == RunState::Preparing || progress.state == RunState::Running) {
        if (interrupted()) {
            // An unlimited time budget leaves no step without its Betti numbers.
            if (progress.state == RunState::Running) progress = session.run({.steps = 1});
            break;
        }
        progress = session.run({.milliseconds = kSliceMs});
        if (progress.ended_at_plateau && ++plateaus < nth) {
            session.run_to_next_plateau();
            progress = session.progress();
        }
        line.show(progress);
    }
    return {progress, plateaus};
}

std::optional<Error> write_outputs(const RunArguments& arguments, const Session& session,
                                   const std::optional<SavedRun>& saved) {
    const Step steps = session.timeline().step_count;
    const auto outputs = arguments.outputs();
    const bool has_outputs =
        std::any_of(outputs.begin(), outputs.end(), [](const std::string* path) { return !path->empty(); });
    std::optional<Error> error;
    const auto write = [&](const std::string& path, const auto& text_of) {
        if (!path.empty() && !error) error = write_file(path, text_of());
    };
    write(arguments.betti, [&] { return betti_csv(session); });
    write(arguments.plateaus, [&] { return plateaus_json(session); });
    write(arguments.pumps, [&] { return pumps_csv(session); });
    const bool is_reached = !arguments.at || *arguments.at <= steps;
    const std::optional<Step> shown = is_reached ? arguments.at : std::nullopt;
    write(arguments.session, [&] { return saved_session(session, saved, shown); });
    if (!is_reached && !error) error = out_of_range(*arguments.at, steps);
    write(arguments.mesh, [&] { return mesh_file(session, *mesh_format_of(arguments.mesh), arguments.at); });
    write(arguments.complex, [&] { return complex_vtk(session, arguments.at); });
    write(arguments.report, [&] { return surface_report_json(session, arguments.at); });
    if (!has_outputs) write("-", [&] { return plateau_table(session); });
    if (arguments.hash) {
        std::array<char, 32> text{};
        std::snprintf(text.data(), text.size(), "hash %016llx\n", static_cast<unsigned long long>(session.hash()));
        write("-", [&] { return std::string(text.data()); });
    }
    return error;
}

/// Before a long run rather than after it.
std::optional<Error> objection_to(const RunArguments& arguments, const Session& session) {
    if (!arguments.mesh.empty()) {
        if (auto objection = mesh_objection(session)) return objection;
    }
    if (!arguments.report.empty()) {
        if (auto objection = report_objection(session)) return objection;
    }
    const Step planned = session.progress().steps_planned;
    if (arguments.at && *arguments.at > planned) return out_of_range(*arguments.at, planned);
    return std::nullopt;
}

/// A cloud in a plane or on a line is computed as such, and the user should know.
std::optional<std::string> degeneracy(const Timeline& timeline) {
    if (!is_within_delaunay(timeline.family) || timeline.step_count == 0) return std::nullopt;
    if (timeline.epsilon(timeline.step_count) > 0) return std::nullopt;
    const std::uint32_t spanned = timeline.delaunay_dimension[timeline.step_count - 1];
    if (spanned >= timeline.dimension) return std::nullopt;
    return spanned == 1 ? "All points lie on one line." : "All points lie in one plane.";
}

/// Weights that were small when they were chosen can be large for landmarks that came later.
std::optional<std::string> amplitude_note(const Timeline& timeline) {
    for (Step step = 1; step <= timeline.pumps.size(); ++step) {
        if (timeline.pumps[step - 1].amplitude <= kLargestSafeAmplitude) continue;
        return "From step " + std::to_string(step) + " on a weight is more than half of the distance to the nearest " +
               "landmark: the theory of pumping does not reach that far, and landmarks may be hidden.";
    }
    return std::nullopt;
}

std::optional<std::string> hidden_note(const Timeline& timeline) {
    const std::size_t count = timeline.hidden.size();
    if (count == 0) return std::nullopt;
    return std::to_string(count) + " of " + std::to_string(timeline.step_count) + " landmarks " +
           (count == 1 ? "is" : "are") + " hidden: what others leave of the cell is near no point.";
}

/// Fewer plateaus than asked for were long enough.
std::optional<std::string> nth_note(const Session& session, std::uint32_t found, std::uint32_t nth) {
    if (session.options().min_length == 0 || found >= nth) return std::nullopt;
    if (found == 0) return "No plateau is as long as was asked for.";
    return "Only " + std::to_string(found) + (found == 1 ? " plateau is" : " plateaus are") +
           " as long as was asked for.";
}

void report(const std::vector<std::string>& notes) {
    for (const std::string& note : notes) std::fprintf(stderr, "plateau: %s\n", note.c_str());
}

}  // namespace

Result<int> run(const RunArguments& arguments) {
    if (auto error = check_outputs(arguments)) return std::move(*error);
    auto input = open_input(arguments);
    if (!input) return input.error();
    if (!input.value()) return kInterrupted;
    auto& [session, notes, saved] = *input.value();
    if (auto objection = objection_to(arguments, session)) return std::move(*objection);

    const auto [progress, plateaus] = run_to_end(session, arguments.nth, arguments.progress);
    if (progress.stopped && progress.steps_done == 0) return *progress.stopped;
    const std::string place =
        "after step " + std::to_string(progress.steps_done) + " of " + std::to_string(progress.steps_planned);
    if (auto error = write_outputs(arguments, session, saved)) {
        // A mesh of a step that was not reached is the interruption's doing.
        if (interrupted() && error->code == ErrorCode::InvalidOption) {
            report({"Interrupted " + place + ", before the step of --at."});
            return kInterrupted;
        }
        return std::move(*error);
    }
    if (const auto note = degeneracy(session.timeline())) notes.push_back(*note);
    if (saved) {
        if (auto note = disagreement(*saved, session)) notes.push_back(std::move(*note));
    }
    if (const auto note = amplitude_note(session.timeline())) notes.push_back(*note);
    if (const auto note = hidden_note(session.timeline())) notes.push_back(*note);
    if (progress.stopped) notes.push_back(progress.stopped->message);
    if (progress.ended_at_noise) {
        std::array<char, 64> text{};
        std::snprintf(text.data(), text.size(), ": epsilon has fallen to the noise, %.3g.", progress.noise);
        notes.push_back("Stopped " + place + text.data());
    }
    if (progress.ended_at_plateau) notes.push_back("Stopped " + place + ": a plateau is as long as was asked for.");
    if (interrupted()) {
        notes.push_back("Interrupted " + place + ".");
    } else if (const auto note = nth_note(session, plateaus, arguments.nth)) {
        notes.push_back(*note);
    }
    report(notes);
    return interrupted() ? kInterrupted : kDone;
}

}  // namespace plateau::cli
