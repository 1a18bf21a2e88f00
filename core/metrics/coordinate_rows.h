#pragma once

#include <memory>

#include "metrics/distance_rows.h"

namespace plateau {

/// Rows that need nothing but the coordinates of the two points: Euclidean, L1, LInf, angular, projective, periodic.
/// Cost of a row: O(n d).
///
/// Angles are compared by sin^2 up to a right angle and by 1 + cos^2 beyond, both from the squared scalar product: with
/// integer coordinates equal angles give equal numbers (as long as the products of the squared norms stay below 2^53).
std::unique_ptr<DistanceRows> make_coordinate_rows(const PointCloud& cloud, const MetricOptions& options);

}  // namespace plateau
