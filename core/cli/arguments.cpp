#include "cli/arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <limits>
#include <sstream>

#include "io/family_name.h"
#include "io/mesh_files.h"
#include "io/metric_name.h"
#include "io/sliver_name.h"
#include "io/text.h"

namespace plateau::cli {
namespace {

/// What is given as text and read here, so that the messages are our own.
struct RawText {
    std::string family;
    std::string nu;
    std::string columns;
    std::string until;
    std::string megabytes;
    std::string metric;
    std::string box;
    std::string sliver;
    std::string simplex;
    bool theory = false;
};

Error invalid(std::string message) {
    return {ErrorCode::InvalidOption, std::move(message)};
}

/// Whole numbers between commas.
Result<std::vector<std::uint32_t>> parse_list(std::string_view text, const std::string& option) {
    std::vector<std::uint32_t> numbers;
    while (true) {
        const std::size_t end = text.find(',');
        const auto number = parse_count(text.substr(0, end));
        if (!number || *number > std::numeric_limits<std::uint32_t>::max()) {
            return invalid(option + " takes whole numbers between commas, such as 1,2,3");
        }
        numbers.push_back(static_cast<std::uint32_t>(*number));
        if (end == std::string_view::npos) return numbers;
        text.remove_prefix(end + 1);
    }
}

/// Numbers of at least 0 between commas.
Result<std::vector<double>> parse_box(std::string_view text) {
    std::vector<double> numbers;
    while (true) {
        // The parser of numbers looks at the byte behind the field, which a text of its own has.
        const std::size_t end = text.find(',');
        const std::string field(text.substr(0, end));
        const ParsedField number = parse_field(field);
        if (number.kind != FieldKind::Number) {
            return invalid("--box takes a period for every axis, such as 1,1, or one for all; got " + in_quotes(field) +
                           ".");
        }
        numbers.push_back(number.value);
        if (end == std::string_view::npos) return numbers;
        text.remove_prefix(end + 1);
    }
}

std::optional<Error> complete_metric(RunArguments& run, const RawText& raw, bool names_neighbors) {
    MetricOptions& metric = run.options.metric;
    if (!raw.metric.empty()) {
        const auto named = metric_named(raw.metric);
        if (!named) {
            return invalid("There is no metric " + in_quotes(raw.metric) + "; take " + std::string(kMetricChoice) +
                           ".");
        }
        metric.metric = *named;
    }
    if (names_neighbors && metric.metric != Metric::Geodesic) return invalid("--knn is for --metric geodesic.");
    if (raw.box.empty()) return std::nullopt;
    if (metric.metric != Metric::Periodic) return invalid("--box is for --metric periodic.");
    auto box = parse_box(raw.box);
    if (!box) return box.error();
    metric.box = std::move(box).value();
    return std::nullopt;
}

std::optional<Error> complete(RunArguments& run, const RawText& raw) {
    if (!raw.family.empty()) {
        run.options.family = family_named(raw.family);
        if (!run.options.family) {
            return invalid("There is no family " + in_quotes(raw.family) +
                           "; take witness, delaunay, surface, auto or dilated.");
        }
    }
    if (!raw.nu.empty()) {
        auto nu = parse_list(raw.nu, "--nu");
        if (!nu) return nu.error();
        run.options.nu = std::move(nu).value();
    }
    DilatedOptions& dilated = run.options.dilated;
    if (raw.theory) {
        dilated.dilation = kTheoryDilation;
        dilated.pumps = true;
    }
    if (!raw.sliver.empty()) {
        const auto measure = sliver_named(raw.sliver);
        if (!measure) {
            return invalid("--sliver takes " + std::string(kSliverChoice) + "; got " + in_quotes(raw.sliver) + ".");
        }
        dilated.pump.measure = *measure;
    }
    if (!raw.columns.empty()) {
        auto columns = parse_list(raw.columns, "--columns");
        if (!columns) return columns.error();
        run.columns = std::move(columns).value();
    }
    if (raw.until == "noise") {
        run.options.noise_stop_from = 0;
    } else if (!raw.until.empty()) {
        const ParsedField until = parse_field(raw.until);
        if (until.kind != FieldKind::Number || until.value < 0) {
            return invalid("--until takes an epsilon of at least 0, or noise; got " + in_quotes(raw.until) + ".");
        }
        run.options.until_epsilon = until.value;
    }
    if (!raw.megabytes.empty()) {
        const auto megabytes = parse_count(raw.megabytes);
        if (!megabytes || *megabytes == 0 || *megabytes >> 43 != 0) {
            return invalid("--memory takes a whole number of megabytes; got " + in_quotes(raw.megabytes) + ".");
        }
        run.memory_limit = *megabytes << 20;
    }
    if (run.nth == 0) return invalid("--nth 0 is out of range: plateaus are counted from 1.");
    return std::nullopt;
}

std::optional<Error> check_outputs(const RunArguments& run) {
    const auto outputs = run.outputs();
    if (std::count_if(outputs.begin(), outputs.end(), [](const std::string* path) { return *path == "-"; }) > 1) {
        return invalid("Only one output can go to standard output.");
    }
    if (!mesh_format_of(run.mesh)) {
        return invalid("--mesh writes .ply, .off and .glb; got " + in_quotes(run.mesh) + ".");
    }
    if (run.at && run.mesh.empty() && run.complex.empty() && run.report.empty() && run.session.empty()) {
        return invalid("--at is the step of --mesh, --complex, --report or --session, and none is asked for.");
    }
    if (run.at && *run.at == 0) return invalid("--at 0 is out of range: steps are counted from 1.");
    return std::nullopt;
}

void add_dilated(CLI::App& app, DilatedOptions& dilated, RawText& raw) {
    auto* dilation = app.add_option("--dilation", dilated.dilation,
                                    "Family dilated: radius of the witnesses as a part of epsilon, at most 1");
    dilation->capture_default_str();
    app.add_flag("--pump", dilated.pumps, "Family dilated: choose weights that keep flat simplices out");
    app.add_option("--omega-bar", dilated.pump.omega_bar,
                   "Pumping: the largest weight as a part of the distance to the nearest landmark, at most 0.5")
        ->capture_default_str();
    app.add_option("--zeta2", dilated.pump.dilation, "Pumping: radius of the witnesses as a part of epsilon, at most 1")
        ->capture_default_str();
    app.add_option("--sliver", raw.sliver,
                   "Pumping: how flat a simplex is, literal (volume by the shortest edge) or normalized (its root, so "
                   "that dimensions compare) [literal]");
    app.add_flag("--theory", raw.theory, "Family dilated: the constants of the theory, --dilation 0.0368 --pump")
        ->excludes(dilation);
}

/// What is computed, and from what.
void add_input(CLI::App& app, RunArguments& run, RawText& raw) {
    app.add_option("INPUT", run.input,
                   "Point file (.xyz .txt .csv .ply .off .obj .pcd .npy), distance matrix (.csv .txt .npy) or session "
                   "(.plateau), - for standard input")
        ->required();
    app.add_option("--family", raw.family,
                   "witness, delaunay, surface, auto or dilated [plane: delaunay, space: auto, 4 or 5 coordinates: "
                   "dilated, else witness]");
    app.add_option("--nu", raw.nu, "Ranks of the witnesses by dimension, such as 1,6,6,4 [as the family]");
    app.add_option("--first", run.options.first, "Input index of the first landmark, from 0")->capture_default_str();
    app.add_option("--memory", raw.megabytes,
                   "Most memory to take, in MB; the run stops there [four fifths of the machine's]");
    app.add_option("--rho", run.options.rho, "Surface: drop triangles of a larger radius-edge ratio [off]");
    add_dilated(app, run.options.dilated, raw);
    app.add_option("--metric", raw.metric,
                   std::string(kMetricChoice) + " [euclidean]; all but euclidean are for family witness");
    app.add_option("--knn", run.options.metric.neighbors,
                   "Metric geodesic: to how many nearest others every point is joined")
        ->capture_default_str();
    app.add_option("--box", raw.box,
                   "Metric periodic: the period of every axis, such as 1,1, or one for all; 0: none [the unit box]");
    app.add_option("--max-dim", run.options.max_dimension,
                   "Family witness: the last Betti number, at most 6 [that of the space, matrix: 2]");
    app.add_option("--field", run.options.field,
                   "Families witness and dilated: Betti numbers over Z/p for this prime p")
        ->capture_default_str();
    app.add_option("--columns", raw.columns, "Columns that are the coordinates, from 1, such as 1,2,3 [all]");
}

void add_run(CLI::App& app, RunArguments& run, RawText& raw) {
    add_input(app, run, raw);
    app.add_option("--steps", run.options.max_steps, "Most landmarks to insert [all]");
    app.add_option("--until", raw.until,
                   "Stop once epsilon is at most this, in input units; noise: at the median distance of a point to its "
                   "nearest other one");
    auto* length =
        app.add_option("--min-length", run.options.min_length,
                       "Stop once a plateau is this long: the natural logarithm of the ratio of its epsilons");
    app.add_option("--nth", run.nth, "Go on to the n-th plateau of --min-length")->needs(length)->capture_default_str();
    app.add_option("--betti", run.betti, "Write the Betti numbers of every step (CSV); - for standard output");
    app.add_option("--plateaus", run.plateaus, "Write the plateaus (JSON); - for standard output");
    app.add_option("--pumps", run.pumps, "Write the weight of every landmark (CSV); - for standard output");
    app.add_option("--mesh", run.mesh,
                   "Write the shape of one step: .ply, .off or .glb by the name; - for standard output (PLY)");
    app.add_option(
        "--complex", run.complex,
        "Write the complex of one step with its edges, triangles and tetrahedra (VTK); - for standard output");
    app.add_option("--report", run.report,
                   "Write the surface of one step in numbers (JSON): components, genus, area, volume; - for standard "
                   "output");
    app.add_option("--session", run.session,
                   "Write points, options and where the run stands, to be opened again (.plateau); - for standard "
                   "output");
    app.add_option("--at", run.at,
                   "Step of --mesh, --complex, --report and --session [the middle of the longest plateau]");
    app.add_flag("--hash", run.hash, "Print the hash of the run as the last line");
    app.add_flag("--progress", run.progress, "Report progress also where standard error is no terminal");
}

void add_inspect(CLI::App& app, InspectArguments& inspect, RawText& raw) {
    add_input(app, inspect.run, raw);
    app.add_option("--step", inspect.step, "Step to look at, from 1")->required();
    app.add_option("--simplex", raw.simplex, "Landmarks by their steps, such as 3,7,12")->required();
}

void add_sample(CLI::App& app, SampleArguments& sample, CLI::Option*& size) {
    app.add_option("SHAPE", sample.shape, "One of the shapes below")->required();
    size = app.add_option("--n", sample.options.size, "Number of points [by shape]");
    app.add_option("--noise", sample.options.noise, "Radius of a uniform ball added to each point")
        ->capture_default_str();
    app.add_option("--seed", sample.options.seed, "Seed of all that is random")->capture_default_str();
    std::string footer = "Shapes:\n";
    for (const SampleShape& shape : sample_shapes()) {
        std::string line = "  " + std::string(shape.name);
        line.resize(18, ' ');
        footer += line + std::string(shape.look_for) + " [" + std::to_string(shape.default_size) + " points]\n";
    }
    app.footer(footer);
}

/// The parser's messages can have several lines; ours has one.
std::string one_line(std::string text) {
    for (char& c : text) {
        if (c == '\n' || c == '\r') c = ' ';
    }
    return std::string(trimmed(text));
}

}  // namespace

Result<Arguments> parse_arguments(int count, const char* const* values) {
    RunArguments run;
    RawText raw;
    InspectArguments inspect;
    RawText inspect_raw;
    SampleArguments sample;
    CLI::Option* sample_size = nullptr;
    CLI::App app("Plateau reads a point cloud and shows, scale by scale, which shapes it may have been sampled from.",
                 "plateau");
    app.set_version_flag("--version", std::string("plateau ") + PLATEAU_VERSION);
    app.require_subcommand(1);
    CLI::App* run_app = app.add_subcommand("run", "Insert the points one by one and report the plateaus");
    CLI::App* inspect_app = app.add_subcommand("inspect", "Say why a simplex is in the complex of a step, or why not");
    CLI::App* sample_app = app.add_subcommand("sample", "Print points of a built-in shape");
    add_run(*run_app, run, raw);
    add_inspect(*inspect_app, inspect, inspect_raw);
    add_sample(*sample_app, sample, sample_size);
    // The parser reports by exceptions; they end here.
    try {
        app.parse(count, values);
    } catch (const CLI::Success& request) {
        std::ostringstream text;
        app.exit(request, text, text);
        return Arguments(TextRequest{text.str()});
    } catch (const CLI::ParseError& error) {
        return invalid(one_line(error.what()) + " (see plateau --help)");
    }
    const auto complete_run = [](const CLI::App& parsed, RunArguments& arguments, const RawText& given) {
        auto error = complete(arguments, given);
        if (!error) error = complete_metric(arguments, given, parsed.count("--knn") > 0);
        for (const CLI::Option* option : parsed.get_options()) {
            if (option->count() == 0) continue;
            for (const std::string& name : option->get_lnames()) arguments.named.push_back(name);
        }
        return error;
    };
    if (run_app->parsed()) {
        if (auto error = complete_run(*run_app, run, raw)) return std::move(*error);
        if (auto error = check_outputs(run)) return std::move(*error);
        return Arguments(std::move(run));
    }
    if (inspect_app->parsed()) {
        if (auto error = complete_run(*inspect_app, inspect.run, inspect_raw)) return std::move(*error);
        auto simplex = parse_list(inspect_raw.simplex, "--simplex");
        if (!simplex) return simplex.error();
        inspect.simplex = std::move(simplex).value();
        if (inspect.step == 0) return invalid("--step 0 is out of range: steps are counted from 1.");
        // A session file need not be followed to where it stood.
        inspect.run.options.max_steps = inspect.step;
        inspect.run.named.push_back("steps");
        return Arguments(std::move(inspect));
    }
    if (sample_size->count() == 0) {
        for (const SampleShape& shape : sample_shapes()) {
            if (shape.name == sample.shape) sample.options.size = shape.default_size;
        }
    }
    return Arguments(std::move(sample));
}

}  // namespace plateau::cli
