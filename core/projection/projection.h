#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "cloud/point_cloud.h"

namespace plateau {

/// Coordinates to draw a cloud with that has more than three of its own, or none. For eyes only: nothing that is
/// counted, compared or hashed depends on it. The same bytes on every machine all the same: files hold them.
struct Projection {
    std::uint32_t axes = 0;          ///< at most kMostAxes, fewer where the cloud spreads in fewer directions
    std::vector<float> coordinates;  ///< n rows of `axes` numbers, in input units, around the origin
    std::vector<double> shares;      ///< one an axis, falling: what it keeps of the whole spread, 0 to 1
};

inline constexpr std::uint32_t kMostAxes = 8;

/// Principal axes: the directions in which the points spread most. A share is one of the variance. Where points and
/// coordinates are too many, the axes are those of every k-th point. Cost: O(n d) and at most some 10^9 operations.
Projection principal_axes(const PointCloud& cloud);

/// Writes the distances of one witness to all.
using DistanceRow = std::function<void(std::uint32_t witness, std::span<double> distances)>;

/// Classical multidimensional scaling (Torgerson): the axes on which inner products agree best with the distances. Of
/// more than 400 witnesses that many pivots, farthest first, are scaled, and the others put among them by their
/// distances to those (landmark MDS, de Silva & Tenenbaum 2004). A share is one of the eigenvalues' magnitudes: where
/// no coordinates at all have these distances, some are negative and no axis keeps them.
Projection classical_scaling(std::uint32_t count, const DistanceRow& row);

/// Of a cloud that cannot be drawn as it is: principal_axes() of its coordinates, classical_scaling() of its distances.
Projection projection_of(const PointCloud& cloud);

}  // namespace plateau
