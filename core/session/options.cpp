#include "session/options.h"

#include <cmath>
#include <string>

namespace plateau {

namespace {

constexpr std::uint32_t kLargestNu = 32;

std::vector<std::uint32_t> default_nu(Family family, std::uint32_t dimension) {
    if (family == Family::Witness) {
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

}  // namespace

Result<RunOptions> resolved(RunOptions options, const PointCloud& cloud) {
    const std::uint32_t dimension = cloud.dimension;
    const Family asked = options.family.value_or(dimension == 2 ? Family::Delaunay : Family::Auto);
    if (dimension == 2 && asked == Family::Surface) {
        return invalid("Family surface needs points in space; for points in the plane take delaunay or witness.");
    }
    options.family = dimension == 2 && asked == Family::Auto ? Family::Delaunay : asked;

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
    if (!(options.rho >= 0) || !std::isfinite(options.rho)) {
        return invalid("rho must be a positive number, or 0 to keep triangles of every radius-edge ratio.");
    }
    if (options.field > 46337 || !is_prime(options.field)) {
        return invalid("The field must be a prime from 2 to 46337; got " + std::to_string(options.field) + ".");
    }
    return options;
}

EngineOptions engine_options(const RunOptions& resolved, std::uint32_t dimension) {
    EngineOptions engine;
    engine.family = *resolved.family;
    engine.nu = {resolved.nu};
    if (engine.family == Family::Auto) engine.nu.push_back(default_nu(Family::Witness, dimension));  // [GO 4.5]
    engine.rho = resolved.rho;
    engine.field = resolved.field;
    return engine;
}

}  // namespace plateau
