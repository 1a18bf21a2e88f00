#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/result.h"
#include "cloud/distance_matrix.h"

namespace plateau {

/// n witnesses W in input order: points in R^d, or nothing but the distances between them.
struct PointCloud {
    std::uint32_t dimension = 0;      ///< d; 0 where there are only distances
    std::vector<double> coordinates;  ///< n rows of d numbers, in input units
    DistanceMatrix distances = {};    ///< empty where there are coordinates

    std::uint32_t size() const {
        return dimension == 0 ? distances.size : static_cast<std::uint32_t>(coordinates.size() / dimension);
    }
    /// Coordinates of the point with the given 0-based input index.
    std::span<const double> point(std::uint32_t index) const {
        return {coordinates.data() + static_cast<std::size_t>(index) * dimension, dimension};
    }
};

/// Largest magnitude of a coordinate: sums of its squares stay far from overflow.
inline constexpr double kMaxCoordinate = 1e150;

/// Checks that the cloud is one the engine takes: at least one point, dimension at least 2, every coordinate finite and
/// at most kMaxCoordinate in magnitude; or a distance matrix, which its reader has checked. Errors name the first bad
/// point (1-based).
Result<PointCloud> validated(PointCloud cloud);

/// Squared Euclidean distance, summed in axis order in double: the one definition of Euclidean distance in the project.
inline double distance_squared(std::span<const double> a, std::span<const double> b) {
    double sum = 0;
    for (std::size_t axis = 0; axis < a.size(); ++axis) {
        const double difference = a[axis] - b[axis];
        sum += difference * difference;
    }
    return sum;
}

}  // namespace plateau
