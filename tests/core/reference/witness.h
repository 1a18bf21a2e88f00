#pragma once

#include <vector>

#include "cloud/point_cloud.h"
#include "reference/complex.h"

namespace plateau::reference {

/// Landmarks (0-based input indices) and epsilon squared, both in step order.
struct FarthestOrder {
    std::vector<int> landmarks;
    std::vector<double> epsilon_squared;
};

inline constexpr int kAllSteps = 1000000;

/// Farthest-point order that starts with `first`, until epsilon is 0 or `max_steps` are done; equal farthest witnesses:
/// the lowest input index.
FarthestOrder farthest_point_order(const PointCloud& cloud, int first, int max_steps = kAllSteps);

/// For every witness the steps 1 .. step, nearest first; equal distances: the earlier step.
std::vector<std::vector<int>> landmark_lists(const PointCloud& cloud, const FarthestOrder& order, int step);

/// The nu-witness complex up to `max_dimension`: a simplex is in it iff for each of its i-faces there is a witness
/// among whose first nu_i landmarks are all vertices of the face. nu_i = 0 beyond the given entries.
Complex witness_complex(const std::vector<std::vector<int>>& lists, const std::vector<int>& nu, int max_dimension);

}  // namespace plateau::reference
