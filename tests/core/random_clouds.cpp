#include "random_clouds.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

#include "comparison.h"

namespace plateau {
namespace {

using reference::Settings;
using reference::ShownFamily;

class Numbers {
public:
    explicit Numbers(std::uint64_t seed) : state_((seed + 1) * 0x9E3779B97F4A7C15u) { unit(); }
    double unit() {
        state_ = state_ * 6364136223846793005u + 1442695040888963407u;
        return static_cast<double>(state_ >> 33) / 2147483648.0;
    }
    int below(int bound) { return static_cast<int>(unit() * bound); }
    double between(double low, double high) { return low + (high - low) * unit(); }

private:
    std::uint64_t state_;
};

/// One coordinate row of a cloud of the given kind.
void append_point(Numbers& numbers, int kind, std::uint32_t dimension, int detail, std::vector<double>& row) {
    row.resize(dimension);
    double length = 0;
    for (double& x : row) {
        x = numbers.between(-1, 1);
        length += x * x;
    }
    length = std::sqrt(length) + 1e-3;
    switch (kind) {
        case 0:  // a box
            break;
        case 1:  // a lattice
            for (double& x : row) x = std::floor((x + 1) / 2 * detail);
            break;
        case 2:  // a lattice that rounding spoils
            for (double& x : row) x = std::floor((x + 1) / 2 * detail) * 0.1;
            break;
        case 3:  // a sphere or circle
            for (double& x : row) x /= length;
            break;
        case 4:  // a sphere with noise
            for (double& x : row) x = x / length + numbers.between(-0.1, 0.1);
            break;
        case 5:  // a slab one lattice step thick
            row.back() = std::floor(row.back() + 1);
            break;
        case 6:  // a lattice with few points off it
            for (double& x : row) x = std::floor((x + 1) / 2 * detail) + (numbers.below(8) == 0 ? 0.25 : 0);
            break;
        default:  // nested octahedra and cubes: few directions, few radii
            for (double& x : row) x = numbers.below(3) - 1;
            const int radius = 1 + numbers.below(detail);
            for (double& x : row) x *= radius;
            break;
    }
}

}  // namespace

std::string random_run_difference(std::uint64_t seed, int size_bound) {
    Numbers numbers(seed);
    PointCloud cloud;
    cloud.dimension = numbers.below(4) == 0 ? 2 : 3;
    const int kind = numbers.below(8), detail = 2 + numbers.below(4), size = 4 + numbers.below(size_bound - 4);
    const double scales[] = {1, 1, 1, 1e-6, 3e5, 1.0 / 3};
    const double scale = scales[numbers.below(6)];
    std::vector<double> row;
    for (int i = 0; i < size; ++i) {
        append_point(numbers, kind, cloud.dimension, detail, row);
        for (const double x : row) cloud.coordinates.push_back(x * scale);
    }

    Settings settings;
    settings.family = static_cast<ShownFamily>(numbers.below(cloud.dimension == 2 ? 2 : 4));
    settings.nu = reference::default_nu(settings.family, static_cast<int>(cloud.dimension));
    if (numbers.below(2) == 0) {
        settings.nu = {1 + numbers.below(3)};
        for (std::uint32_t i = 0; i < cloud.dimension; ++i) settings.nu.push_back(numbers.below(9));
    }
    if (numbers.below(4) == 0) settings.rho = numbers.between(0.58, 1.5);
    const int primes[] = {2, 2, 2, 3, 5};
    const int prime = primes[numbers.below(5)];
    if (settings.family == ShownFamily::Witness) settings.prime = prime;
    const int first = numbers.below(size);
    const int max_steps = numbers.below(5) == 0 ? 1 + numbers.below(size) : reference::kAllSteps;

    reference::Reference expected(cloud, first, max_steps);
    const std::string text = run_difference(cloud, expected, settings, first, max_steps, 1);
    if (text.empty()) return "";
    std::ostringstream message;
    message << "seed " << seed << ": kind " << kind << ", " << size << " points, d = " << cloud.dimension << ", family "
            << name_of(settings.family) << ", nu " << joined(settings.nu) << ", rho " << settings.rho << ", field "
            << settings.prime << ", first " << first << ", steps " << expected.step_count() << ": " << text;
    return message.str();
}

}  // namespace plateau
