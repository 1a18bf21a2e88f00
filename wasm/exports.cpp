#include "exports.h"

#include <optional>

#include "io/complex_vtk.h"
#include "io/family_name.h"
#include "io/mesh_files.h"
#include "io/metric_name.h"
#include "io/report_json.h"
#include "io/saved_options.h"
#include "io/session_file.h"
#include "io/sliver_name.h"
#include "io/step_mesh.h"
#include "io/writers.h"
#include "marshal.h"
#include "options.h"

namespace plateau::marshal {

using emscripten::val;

namespace {

Result<std::optional<Step>> step_of(const Session& session, const val& step) {
    if (!given(step)) return std::optional<Step>();
    auto number = count_of(step, "The step");
    if (!number) return number.error();
    if (number.value() < 1 || number.value() > session.timeline().step_count) {
        return Error{ErrorCode::InvalidOption, "Step " + std::to_string(number.value()) + " is not computed yet."};
    }
    return std::optional<Step>(number.value());
}

std::string session_file(const Session& session, std::optional<Step> step, const val& view) {
    SavedRun saved;
    saved.options = saved_options(session.options());
    saved.reached = session.timeline().step_count;
    saved.hash = session.hash();
    saved.shown = step.value_or(default_mesh_step(session));
    if (given(view)) saved.view = view.as<std::string>();
    return session_bytes(session.cloud(), saved);
}

std::optional<MeshFormat> mesh_format(const std::string& format) {
    if (format == "mesh-ply") return MeshFormat::Ply;
    if (format == "mesh-off") return MeshFormat::Off;
    if (format == "mesh-glb") return MeshFormat::Glb;
    return std::nullopt;
}

}  // namespace

Result<std::string> exported(const Session& session, const std::string& format, const val& step, const val& view) {
    if (format == "betti-csv") return betti_csv(session);
    if (format == "plateaus-json") return plateaus_json(session);
    auto at = step_of(session, step);
    if (!at) return at.error();
    if (const auto mesh = mesh_format(format)) {
        if (auto objection = mesh_objection(session)) return std::move(*objection);
        return mesh_file(session, *mesh, at.value());
    }
    if (format == "complex-vtk") return complex_vtk(session, at.value());
    if (format == "surface-report") {
        if (auto objection = report_objection(session)) return std::move(*objection);
        return surface_report_json(session, at.value());
    }
    if (format == "session") return session_file(session, at.value(), view);
    return Error{ErrorCode::InvalidOption, "There is no export format \"" + format + "\"."};
}

val session_of(const SavedRun& saved, const RunOptions& options) {
    val run = val::object();
    const RunOptions usual;
    run.set("metric", std::string(metric_name(options.metric.metric)));
    if (options.metric.metric == Metric::Geodesic) run.set("knn", options.metric.neighbors);
    if (!options.metric.box.empty()) run.set("box", val::array(options.metric.box));
    if (options.family) run.set("family", std::string(family_name(*options.family)));
    // The lists of family dilated are no choice.
    if (!options.nu.empty() && options.family != Family::Dilated) run.set("nu", val::array(options.nu));
    if (options.max_dimension) run.set("maxDimension", *options.max_dimension);
    run.set("field", options.field);
    run.set("first", options.first);
    run.set("rho", options.rho);
    if (options.family == Family::Dilated) {
        const DilatedOptions& dilated = options.dilated;
        run.set("dilation", dilated.dilation);
        if (dilated.pumps) {
            run.set("pump", true);
            run.set("omegaBar", dilated.pump.omega_bar);
            run.set("zeta2", dilated.pump.dilation);
            run.set("sliver", std::string(sliver_name(dilated.pump.measure)));
        }
    }
    if (options.min_length != usual.min_length) run.set("minLength", options.min_length);
    if (options.max_steps != usual.max_steps) run.set("maxSteps", options.max_steps);
    if (options.until_epsilon != usual.until_epsilon) run.set("untilEpsilon", options.until_epsilon);
    if (options.noise_stop_from != usual.noise_stop_from) run.set("noiseStopFrom", options.noise_stop_from);

    val session = val::object();
    session.set("step", saved.shown);
    session.set("reached", saved.reached);
    session.set("hash", hex(saved.hash));
    session.set("view", saved.view);
    session.set("options", run);
    return session;
}

}  // namespace plateau::marshal
