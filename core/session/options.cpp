#include "session/options.h"

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "base/words.h"
#include "metrics/distance_rows.h"

namespace plateau {

namespace {

constexpr std::uint32_t kLargestNu = 32;
constexpr double kLargestLength = 50;
constexpr double kLargestDilation = 1;
constexpr double kLargestAmplitude = 0.5;

// Family dilated has no nu: these are the lists by which it looks for witnesses.
std::vector<std::uint32_t> default_nu(Family family, std::uint32_t dimension) {
    if (family == Family::Witness || family == Family::Dilated) {
        std::vector<std::uint32_t> nu;
        for (std::uint32_t i = 0; i <= dimension; ++i) nu.push_back(i + 1);
        return nu;
    }
    if (dimension == 2) return {1, 2, 3};
    return {1, 6, 6, 4};
}

bool is_prime(std::uint32_t number) {
    if (number < 2) return false;
    for (std::uint32_t divisor = 2; divisor * divisor <= number; ++divisor) {
        if (number % divisor == 0) return false;
    }
    return true;
}

Error invalid(std::string message) {
    return {ErrorCode::InvalidOption, std::move(message)};
}

bool has_delaunay(const PointCloud& cloud, Metric metric) {
    return metric == Metric::Euclidean && cloud.dimension <= 3;
}

// In four and five dimensions dilated, unless what only family witness has is asked for.
Family default_family(const PointCloud& cloud, const RunOptions& options) {
    const Metric metric = options.metric.metric;
    const bool is_for_witness = !options.nu.empty() || options.max_dimension;
    const bool may_be_dilated = cloud.dimension > 3 && cloud.dimension <= kMaxDilatedDimension && !is_for_witness;
    if (metric == Metric::Euclidean && may_be_dilated) return Family::Dilated;
    if (!has_delaunay(cloud, metric)) return Family::Witness;
    return cloud.dimension == 2 ? Family::Delaunay : Family::Auto;
}

std::optional<Error> check_family(const PointCloud& cloud, const RunOptions& options) {
    if (options.family == Family::Witness) return std::nullopt;
    if (options.metric.metric != Metric::Euclidean) {
        return invalid("Only family witness takes other metrics than the Euclidean one.");
    }
    if (options.family == Family::Dilated) {
        if (cloud.dimension <= kMaxDilatedDimension) return std::nullopt;
        return invalid("Family dilated takes points with up to " + std::to_string(kMaxDilatedDimension) +
                       " coordinates; with " + std::to_string(cloud.dimension) +
                       " coordinates they need family witness.");
    }
    if (!has_delaunay(cloud, Metric::Euclidean)) {
        return invalid("Points with " + std::to_string(cloud.dimension) + " coordinates need family witness" +
                       (cloud.dimension <= kMaxDilatedDimension ? " or dilated" : "") +
                       "; the others are for the plane and for space.");
    }
    if (cloud.dimension == 2 && options.family == Family::Surface) {
        return invalid("Family surface needs points in space; for points in the plane take delaunay or witness.");
    }
    return std::nullopt;
}

std::optional<Error> check_dilated(const DilatedOptions& options) {
    const auto is_between = [](double number, double low, double high) { return number >= low && number <= high; };
    if (!is_between(options.dilation, 0, kLargestDilation)) {
        return invalid("The dilation must be from 0 to " + short_number(kLargestDilation) +
                       ": the radius of the witnesses as a part of epsilon.");
    }
    if (!is_between(options.pump.omega_bar, 0, kLargestAmplitude)) {
        return invalid("omega-bar must be from 0 to " + short_number(kLargestAmplitude) +
                       ": the largest weight as a part of the distance to the nearest landmark.");
    }
    if (!is_between(options.pump.dilation, 0, kLargestDilation)) {
        return invalid("zeta2 must be from 0 to " + short_number(kLargestDilation) +
                       ": the radius of the witnesses while a landmark is pumped, as a part of epsilon.");
    }
    return std::nullopt;
}

/// The last Betti number of family witness when none is asked for. A flat torus is no part of R^d: it has a beta_d.
std::uint32_t default_max_dimension(const PointCloud& cloud, Metric metric) {
    constexpr std::uint32_t kFew = 2;
    if (metric == Metric::Matrix) return kFew;
    const std::uint32_t last = metric == Metric::Periodic ? cloud.dimension : cloud.dimension - 1;
    return last <= kMaxBetti ? last : kFew;
}

}  // namespace

Result<RunOptions> resolved(RunOptions options, const PointCloud& cloud) {
    const Metric metric = options.metric.metric;
    if (auto error = check_metric(cloud, options.metric)) return std::move(*error);
    if (!options.family) options.family = default_family(cloud, options);
    if (auto error = check_family(cloud, options)) return std::move(*error);
    if (cloud.dimension == 2 && options.family == Family::Auto) options.family = Family::Delaunay;

    if (options.max_dimension && options.family != Family::Witness) {
        return invalid("The last Betti number can be chosen for family witness only.");
    }
    if (options.max_dimension && *options.max_dimension > kMaxBetti) {
        return invalid("The last Betti number can be beta" + std::to_string(kMaxBetti) + " at most, for simplices of " +
                       std::to_string(kMaxBetti + 2) + " points; got beta" + std::to_string(*options.max_dimension) +
                       ".");
    }
    if (options.family == Family::Witness && !options.max_dimension) {
        options.max_dimension = default_max_dimension(cloud, metric);
    }
    const std::uint32_t dimension = options.max_dimension ? *options.max_dimension + 1 : cloud.dimension;
    if (options.family == Family::Dilated && !options.nu.empty()) {
        return invalid("Family dilated has no nu: its witnesses are balls, see the dilation.");
    }
    if (options.nu.empty()) options.nu = default_nu(*options.family, dimension);
    if (options.nu.size() > dimension + 1) options.nu.resize(dimension + 1);
    for (const std::uint32_t entry : options.nu) {
        if (entry > kLargestNu) {
            return invalid("Every entry of nu must be at most " + std::to_string(kLargestNu) + "; " +
                           std::to_string(entry) + " would make lists that long for every point.");
        }
    }
    if (options.nu.front() == 0) return invalid("The first entry of nu must be at least 1: it is about the landmarks.");

    if (options.first >= cloud.size()) {
        return invalid("The first landmark must be the index of a point, 0 to " + std::to_string(cloud.size() - 1) +
                       "; got " + std::to_string(options.first) + ".");
    }
    if (options.max_steps == 0) return invalid("The number of steps must be at least 1.");
    if (!(options.until_epsilon >= 0) || !std::isfinite(options.until_epsilon)) {
        return invalid("The final epsilon must be a number, zero or positive, in the units of the points.");
    }
    if (!(options.min_length >= 0 && options.min_length <= kLargestLength)) {
        return invalid("The least length of a plateau must be from 0 to " + short_number(kLargestLength) +
                       ": the natural logarithm of a ratio of epsilons.");
    }
    if (!(options.rho >= 0) || !std::isfinite(options.rho)) {
        return invalid("rho must be a positive number, or 0 to keep triangles of every radius-edge ratio.");
    }
    if (options.dilated.pumps && options.family != Family::Dilated) {
        return invalid("Weights are for family dilated only; add --family dilated.");
    }
    if (auto error = check_dilated(options.dilated)) return std::move(*error);
    if (options.field > 46337 || !is_prime(options.field)) {
        return invalid("The field must be a prime from 2 to 46337; got " + std::to_string(options.field) + ".");
    }
    return options;
}

EngineOptions engine_options(const RunOptions& resolved, std::uint32_t dimension) {
    EngineOptions engine;
    engine.family = *resolved.family;
    engine.metric = resolved.metric;
    engine.dimension = resolved.max_dimension ? *resolved.max_dimension + 1 : dimension;
    engine.nu = {resolved.nu};
    if (engine.family == Family::Auto) engine.nu.push_back(default_nu(Family::Witness, dimension));  // [GO 4.5]
    engine.rho = resolved.rho;
    engine.field = resolved.field;
    engine.other_field = resolved.field == 2 ? 3 : 2;
    engine.dilated = resolved.dilated;
    return engine;
}

}  // namespace plateau
