#pragma once

#include <cstdint>
#include <vector>

#include "cloud/point_cloud.h"
#include "reference/complex.h"

/// Distances by their definitions, and what follows from a table of them.
namespace plateau::reference {

/// [from][to]: numbers that order as the distances do and are 0 for 0; not always symmetric to the last bit.
using Table = std::vector<std::vector<double>>;

Table euclidean_table(const PointCloud& cloud);  ///< squared
Table sum_table(const PointCloud& cloud);        ///< L1
Table maximum_table(const PointCloud& cloud);    ///< L infinity
/// Squared; over all images of a point in the next boxes. Coordinates within the box; a period of 0: none.
Table periodic_table(const PointCloud& cloud, const std::vector<double>& box);
/// Of integer coordinates: the rank of the angle among all angles of the cloud, compared as exact fractions.
/// `lines`: a direction and its opposite are the same.
Table angle_ranks(const PointCloud& cloud, bool lines);
/// Angles in radians by the standard library.
Table angle_table(const PointCloud& cloud, bool lines);
/// Shortest paths [from][to] among the `neighbors` nearest others, summed from their beginning, by relaxing all edges
/// until nothing changes; infinity between pieces.
Table path_table(const PointCloud& cloud, int neighbors);

struct TableOrder {
    std::vector<int> landmarks;   ///< 0-based input indices, in step order
    std::vector<double> epsilon;  ///< entry of the table
};

/// Farthest-point order until epsilon is 0; equal farthest witnesses: the lowest index.
TableOrder farthest_order(const Table& table, int first);

/// For every witness the steps 1 .. step, nearest first; equal distances: the earlier step.
std::vector<std::vector<int>> lists_of(const Table& table, const TableOrder& order, int step);

}  // namespace plateau::reference
