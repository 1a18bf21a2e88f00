#include "options.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cloud/samples.h"
#include "io/family_name.h"
#include "io/metric_name.h"
#include "io/sliver_name.h"

namespace plateau::marshal {

using emscripten::val;

namespace {

Error invalid(std::string message) {
    return {ErrorCode::InvalidOption, std::move(message)};
}

}  // namespace

bool given(const val& value) {
    return !value.isUndefined() && !value.isNull();
}

Result<std::uint32_t> count_of(const val& value, const std::string& name) {
    const double number = value.as<double>();
    if (!(number >= 0 && number <= 4294967295.0) || number != std::floor(number)) {
        return invalid(name + " must be a whole number of at least 0.");
    }
    return static_cast<std::uint32_t>(number);
}

Result<std::vector<std::uint32_t>> counts_of(const val& array, const std::string& name) {
    std::vector<std::uint32_t> counts;
    const auto length = array["length"].as<std::uint32_t>();
    for (std::uint32_t i = 0; i < length; ++i) {
        auto count = count_of(array[i], name);
        if (!count) return count.error();
        counts.push_back(count.value());
    }
    return counts;
}

namespace {

/// What says how far two points are from each other.
Result<MetricOptions> metric_options_of(const val& source) {
    MetricOptions options;
    if (const val metric = source["metric"]; given(metric)) {
        const auto name = metric.as<std::string>();
        const auto named = metric_named(name);
        if (!named) {
            return invalid("There is no metric \"" + name + "\"; take " + std::string(kMetricChoice) + ".");
        }
        options.metric = *named;
    }
    if (const val neighbors = source["knn"]; given(neighbors)) {
        auto count = count_of(neighbors, "The number of nearest neighbors");
        if (!count) return count.error();
        options.neighbors = count.value();
    }
    if (const val box = source["box"]; given(box)) {
        const auto length = box["length"].as<std::uint32_t>();
        for (std::uint32_t axis = 0; axis < length; ++axis) options.box.push_back(box[axis].as<double>());
    }
    return options;
}

}  // namespace

Result<RunOptions> run_options_of(const val& source) {
    RunOptions options;
    if (!given(source)) return options;
    auto metric = metric_options_of(source);
    if (!metric) return metric.error();
    options.metric = std::move(metric).value();
    if (const val last = source["maxDimension"]; given(last)) {
        auto count = count_of(last, "The last Betti number");
        if (!count) return count.error();
        options.max_dimension = count.value();
    }
    if (const val field = source["field"]; given(field)) {
        auto prime = count_of(field, "The field");
        if (!prime) return prime.error();
        options.field = prime.value();
    }
    if (const val family = source["family"]; given(family)) {
        const auto name = family.as<std::string>();
        options.family = family_named(name);
        if (!options.family) {
            return invalid("There is no family \"" + name + "\"; take witness, delaunay, surface, auto or dilated.");
        }
    }
    if (const val nu = source["nu"]; given(nu)) {
        auto entries = counts_of(nu, "Each entry of nu");
        if (!entries) return entries.error();
        options.nu = std::move(entries).value();
    }
    if (const val first = source["first"]; given(first)) {
        auto index = count_of(first, "The first landmark");
        if (!index) return index.error();
        options.first = index.value();
    }
    if (const val steps = source["maxSteps"]; given(steps)) {
        auto count = count_of(steps, "The number of steps");
        if (!count) return count.error();
        options.max_steps = count.value();
    }
    if (const val epsilon = source["untilEpsilon"]; given(epsilon)) options.until_epsilon = epsilon.as<double>();
    if (const val length = source["minLength"]; given(length)) options.min_length = length.as<double>();
    if (const val from = source["noiseStopFrom"]; given(from)) {
        auto count = count_of(from, "The size from which a cloud ends at its noise");
        if (!count) return count.error();
        options.noise_stop_from = count.value();
    }
    if (const val bytes = source["memoryLimit"]; given(bytes)) {
        const double limit = bytes.as<double>();
        // What the module can address is the most that can be asked for; a part of it is needed for growing.
        if (!(limit >= 1)) return invalid("The memory must be a positive number of bytes.");
        options.memory_limit = std::min(options.memory_limit, static_cast<std::uint64_t>(std::min(limit, 1e15)));
    }
    if (const val dilation = source["dilation"]; given(dilation)) options.dilated.dilation = dilation.as<double>();
    if (const val pump = source["pump"]; given(pump)) options.dilated.pumps = pump.as<bool>();
    if (const val bar = source["omegaBar"]; given(bar)) options.dilated.pump.omega_bar = bar.as<double>();
    if (const val zeta = source["zeta2"]; given(zeta)) options.dilated.pump.dilation = zeta.as<double>();
    if (const val sliver = source["sliver"]; given(sliver)) {
        const auto name = sliver.as<std::string>();
        const auto measure = sliver_named(name);
        if (!measure) {
            return invalid("There is no sliver measure \"" + name + "\"; take " + std::string(kSliverChoice) + ".");
        }
        options.dilated.pump.measure = *measure;
    }
    if (const val rho = source["rho"]; given(rho)) options.rho = rho.as<double>();
    return options;
}

Result<PointCloud> sample_of(const val& source) {
    SampleOptions options;
    auto size = count_of(source["size"], "The number of points");
    if (!size) return size.error();
    options.size = size.value();
    if (const val noise = source["noise"]; given(noise)) options.noise = noise.as<double>();
    if (const val seed = source["seed"]; given(seed)) {
        auto number = count_of(seed, "The seed");
        if (!number) return number.error();
        options.seed = number.value();
    }
    return sample_shape(source["shape"].as<std::string>(), options);
}

}  // namespace plateau::marshal
