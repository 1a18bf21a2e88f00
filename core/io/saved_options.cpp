#include "io/saved_options.h"

#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include "io/exact_text.h"
#include "io/family_name.h"
#include "io/metric_name.h"
#include "io/sliver_name.h"
#include "io/text.h"

namespace plateau {
namespace {

using Option = SavedRun::Option;

/// Fields between commas. The fields end in the text, so that the parser of numbers may look behind them.
std::vector<std::string> between_commas(std::string_view text) {
    std::vector<std::string> fields;
    while (true) {
        const std::size_t end = text.find(',');
        fields.emplace_back(text.substr(0, end));
        if (end == std::string_view::npos) return fields;
        text.remove_prefix(end + 1);
    }
}

bool read_count(const std::string& text, std::uint32_t& number) {
    const auto parsed = parse_count(text);
    if (!parsed || *parsed > std::numeric_limits<std::uint32_t>::max()) return false;
    number = static_cast<std::uint32_t>(*parsed);
    return true;
}

bool read_number(const std::string& text, double& number) {
    const ParsedField parsed = parse_field(text);
    number = parsed.value;
    return parsed.kind == FieldKind::Number;
}

template <class Number, class Read>
bool read_list(const std::string& text, std::vector<Number>& numbers, Read read) {
    numbers.clear();
    for (const std::string& field : between_commas(text)) {
        Number number{};
        if (!read(field, number)) return false;
        numbers.push_back(number);
    }
    return true;
}

/// False if the name or the value means nothing.
bool set_option(RunOptions& options, const Option& option) {
    const auto& [name, value] = option;
    if (name == "family") {
        options.family = family_named(value);
        return options.family.has_value();
    }
    if (name == "metric") {
        const auto metric = metric_named(value);
        if (metric) options.metric.metric = *metric;
        return metric.has_value();
    }
    if (name == "max-dim") return read_count(value, options.max_dimension.emplace());
    if (name == "nu") return read_list(value, options.nu, read_count);
    if (name == "box") return read_list(value, options.metric.box, read_number);
    if (name == "knn") return read_count(value, options.metric.neighbors);
    if (name == "first") return read_count(value, options.first);
    if (name == "steps") return read_count(value, options.max_steps);
    if (name == "until") return read_number(value, options.until_epsilon);
    if (name == "noise-stop-from") return read_count(value, options.noise_stop_from);
    if (name == "rho") return read_number(value, options.rho);
    if (name == "min-length") return read_number(value, options.min_length);
    if (name == "dilation") return read_number(value, options.dilated.dilation);
    if (name == "pump") {
        options.dilated.pumps = true;
        const auto measure = sliver_named(value);
        if (measure) options.dilated.pump.measure = *measure;
        return measure.has_value();
    }
    if (name == "omega-bar") return read_number(value, options.dilated.pump.omega_bar);
    if (name == "zeta2") return read_number(value, options.dilated.pump.dilation);
    if (name == "field") return read_count(value, options.field);
    return false;
}

}  // namespace

std::vector<Option> saved_options(const RunOptions& options) {
    const RunOptions usual;
    std::vector<Option> saved;
    if (options.family) saved.push_back({"family", std::string(family_name(*options.family))});
    // The lists of family dilated are no choice.
    if (!options.nu.empty() && options.family != Family::Dilated) saved.push_back({"nu", joined(options.nu, ",")});
    saved.push_back({"first", std::to_string(options.first)});
    saved.push_back({"metric", std::string(metric_name(options.metric.metric))});
    if (options.metric.metric == Metric::Geodesic) {
        saved.push_back({"knn", std::to_string(options.metric.neighbors)});
    }
    if (!options.metric.box.empty()) {
        std::string box;
        for (const double period : options.metric.box) box += (box.empty() ? "" : ",") + exact(period);
        saved.push_back({"box", box});
    }
    if (options.max_dimension) saved.push_back({"max-dim", std::to_string(*options.max_dimension)});
    saved.push_back({"field", std::to_string(options.field)});
    saved.push_back({"rho", exact(options.rho)});
    if (options.min_length != usual.min_length) saved.push_back({"min-length", exact(options.min_length)});
    if (options.family == Family::Dilated) {
        saved.push_back({"dilation", exact(options.dilated.dilation)});
        if (options.dilated.pumps) {
            const PumpOptions& pump = options.dilated.pump;
            saved.push_back({"pump", std::string(sliver_name(pump.measure))});
            saved.push_back({"omega-bar", exact(pump.omega_bar)});
            saved.push_back({"zeta2", exact(pump.dilation)});
        }
    }
    if (options.max_steps != usual.max_steps) saved.push_back({"steps", std::to_string(options.max_steps)});
    if (options.until_epsilon != usual.until_epsilon) saved.push_back({"until", exact(options.until_epsilon)});
    if (options.noise_stop_from != usual.noise_stop_from) {
        saved.push_back({"noise-stop-from", std::to_string(options.noise_stop_from)});
    }
    return saved;
}

Result<RunOptions> options_of(const SavedRun& saved) {
    RunOptions options;
    for (const Option& option : saved.options) {
        if (set_option(options, option)) continue;
        return Error{ErrorCode::InvalidOption, "The session has an option " + in_quotes(option.name) + " of " +
                                                   in_quotes(option.value) + ", which this version does not know."};
    }
    return options;
}

std::optional<bool> agrees(const SavedRun& saved, const Session& session) {
    if (session.timeline().step_count < saved.reached) return std::nullopt;
    return session.hash_at(saved.reached) == saved.hash;
}

}  // namespace plateau
