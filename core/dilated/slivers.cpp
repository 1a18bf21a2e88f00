#include "dilated/slivers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace plateau {

namespace {

// The k-th root of a number of at least 0, by halving in doubles: the library's roots differ by an ulp.
double root(double number, std::size_t k) {
    if (k == 1) return number;
    if (k == 2) return std::sqrt(number);
    double low = 0;
    double high = std::max(1.0, number);
    for (int round = 0; round < 100; ++round) {
        const double middle = low + (high - low) / 2;
        double power = 1;
        for (std::size_t i = 0; i < k; ++i) power *= middle;
        (power <= number ? low : high) = middle;
    }
    return low;
}

}  // namespace

// The volume times k! is the product of the heights over the vertices so far, by orthogonal projection.
double sliver_measure(std::span<const Step> simplex, const WeightedLandmarks& landmarks, SliverMeasure measure) {
    using Vector = std::array<double, kMaxDilatedDimension>;
    const std::size_t k = simplex.size() - 1;
    if (k < 2) return 1;
    const std::size_t axes = landmarks.dimension();
    double shortest_squared = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i <= k; ++i) {
        for (std::size_t j = i + 1; j <= k; ++j) {
            shortest_squared =
                std::min(shortest_squared, landmarks.distance_squared(simplex[i], landmarks.point(simplex[j])));
        }
    }
    const double shortest = std::sqrt(shortest_squared);
    std::array<Vector, kMaxDilatedDimension> basis{};
    double volume = 1;  // times k!, in shortest edges
    for (std::size_t i = 0; i < k; ++i) {
        Vector edge{};
        for (std::size_t axis = 0; axis < axes; ++axis) {
            edge[axis] = (landmarks.point(simplex[i + 1])[axis] - landmarks.point(simplex[0])[axis]) / shortest;
        }
        for (std::size_t j = 0; j < i; ++j) {
            double along = 0;
            for (std::size_t axis = 0; axis < axes; ++axis) along += edge[axis] * basis[j][axis];
            for (std::size_t axis = 0; axis < axes; ++axis) edge[axis] -= along * basis[j][axis];
        }
        double height_squared = 0;
        for (std::size_t axis = 0; axis < axes; ++axis) height_squared += edge[axis] * edge[axis];
        const double height = std::sqrt(height_squared);
        if (height == 0) return 0;
        volume *= height;
        for (std::size_t axis = 0; axis < axes; ++axis) basis[i][axis] = edge[axis] / height;
    }
    if (measure == SliverMeasure::Normalized) return root(volume, k);
    for (std::size_t i = 2; i <= k; ++i) volume /= static_cast<double>(i);
    return volume;
}

}  // namespace plateau
