#pragma once

#include <cstdint>
#include <vector>

namespace plateau {

/// How far two witnesses are from each other.
enum class Metric : std::uint8_t {
    Euclidean = 0,
    L1 = 1,          ///< sum of the differences of the coordinates
    LInf = 2,        ///< largest difference of a coordinate
    Angular = 3,     ///< angle between two directions, 0 to pi
    Projective = 4,  ///< angle between two lines through the origin, 0 to pi / 2
    Periodic = 5,    ///< Euclidean in a box whose opposite sides are one: a flat torus
    Geodesic = 6,    ///< shortest path in the graph of nearest neighbors
    Matrix = 7,      ///< as the input says; there are no coordinates
};

struct MetricOptions {
    Metric metric = Metric::Euclidean;
    std::uint32_t neighbors = 8;  ///< geodesic: to how many nearest others every point is joined
    /// Periodic: the period of every axis, 0 for an axis without one. One number is for all axes; none is the unit box,
    /// which must hold all points.
    std::vector<double> box;
};

}  // namespace plateau
