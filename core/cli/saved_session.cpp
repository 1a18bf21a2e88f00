#include "cli/saved_session.h"

#include <algorithm>
#include <string_view>

#include "io/saved_options.h"
#include "io/session_file.h"
#include "io/step_mesh.h"

namespace plateau::cli {
namespace {

/// Without the options that only say where a run ends.
std::vector<SavedRun::Option> what_is_computed(std::vector<SavedRun::Option> options) {
    std::erase_if(options, [](const SavedRun::Option& option) {
        return option.name == "steps" || option.name == "until" || option.name == "noise-stop-from";
    });
    return options;
}

}  // namespace

Result<RunOptions> continued(const SavedRun& saved, const RunArguments& arguments) {
    auto read = options_of(saved);
    if (!read) return read.error();
    RunOptions options = std::move(read).value();
    const RunOptions& asked = arguments.options;
    const auto names = [&](std::string_view name) {
        return std::find(arguments.named.begin(), arguments.named.end(), name) != arguments.named.end();
    };
    if (names("metric")) {
        options.metric = asked.metric;
        options.family = asked.family;
    }
    if (names("family")) options.family = asked.family;
    if (names("family") || names("metric")) {
        options.nu = asked.nu;
        options.max_dimension = asked.max_dimension;
    }
    if (names("knn")) options.metric.neighbors = asked.metric.neighbors;
    if (names("box")) options.metric.box = asked.metric.box;
    if (names("nu")) options.nu = asked.nu;
    if (names("max-dim")) {
        // The usual nu has as many entries as there are dimensions.
        if (!names("nu")) options.nu = {};
        options.max_dimension = asked.max_dimension;
    }
    if (names("first")) options.first = asked.first;
    if (names("steps")) options.max_steps = asked.max_steps;
    if (names("until")) {
        options.until_epsilon = asked.until_epsilon;
        options.noise_stop_from = asked.noise_stop_from;
    }
    if (names("rho")) options.rho = asked.rho;
    if (names("dilation") || names("theory")) options.dilated.dilation = asked.dilated.dilation;
    if (names("pump") || names("theory")) options.dilated.pumps = true;
    if (names("omega-bar")) options.dilated.pump.omega_bar = asked.dilated.pump.omega_bar;
    if (names("zeta2")) options.dilated.pump.dilation = asked.dilated.pump.dilation;
    if (names("sliver")) options.dilated.pump.measure = asked.dilated.pump.measure;
    if (names("min-length")) options.min_length = asked.min_length;
    if (names("field")) options.field = asked.field;
    return options;
}

std::optional<std::string> disagreement(const SavedRun& saved, const Session& session) {
    if (what_is_computed(saved_options(session.options())) != what_is_computed(saved.options)) return std::nullopt;
    const auto same = agrees(saved, session);
    if (!same || *same) return std::nullopt;
    return "This is not the run that was saved: its first " + std::to_string(saved.reached) +
           " steps have another hash. The file was changed, or another version of Plateau wrote it.";
}

std::string saved_session(const Session& session, const std::optional<SavedRun>& opened, std::optional<Step> at) {
    SavedRun saved = opened.value_or(SavedRun{});
    const Step reached = session.timeline().step_count;
    if (at || saved.shown == 0 || saved.shown > reached) saved.shown = at.value_or(default_mesh_step(session));
    saved.options = saved_options(session.options());
    saved.reached = reached;
    saved.hash = session.hash();
    return session_bytes(session.cloud(), saved);
}

}  // namespace plateau::cli
