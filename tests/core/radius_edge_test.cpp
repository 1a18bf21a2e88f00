// Triangles whose radius-edge ratio is exactly 1 although no square of their coordinates is.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "delaunay/predicates.h"

namespace plateau {
namespace {

TEST(RadiusEdgeRatio, ExactlyOneDoesNotExceedOne) {
    // Sides sqrt(2), sqrt(2), sqrt(6), so the angles at the long one are 30 degrees and R = sqrt(2).
    for (const double scale : {1.0, 0.1, 0.7, 1.0 / 3, 1e-9 / 3, 1e9 / 7}) {
        std::array<std::array<double, 3>, 3> corners{};
        corners[1] = {scale, scale, 0};
        corners[2] = {2 * scale, scale, scale};
        std::sort(corners.begin(), corners.end());
        do {
            const auto exceeds = [&](double rho) {
                return radius_edge_ratio_exceeds(rho, corners[0], corners[1], corners[2]);
            };
            EXPECT_FALSE(exceeds(1)) << scale;
            EXPECT_TRUE(exceeds(std::nextafter(1, 0))) << scale;
            EXPECT_FALSE(exceeds(std::nextafter(1, 2))) << scale;
        } while (std::next_permutation(corners.begin(), corners.end()));
    }
}

TEST(RadiusEdgeRatio, OfTheEquilateralTriangleIsTheSmallest) {
    const std::array<std::array<double, 3>, 3> corners{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    EXPECT_TRUE(radius_edge_ratio_exceeds(0.577, corners[0], corners[1], corners[2]));  // 1 / sqrt(3) = 0.57735
    EXPECT_FALSE(radius_edge_ratio_exceeds(0.578, corners[0], corners[1], corners[2]));
}

TEST(RadiusEdgeRatio, OfPointsOnALineExceedsEveryBound) {
    const std::array<std::array<double, 3>, 3> corners{{{0, 0, 0}, {0.1, 0.1, 0.1}, {0.3, 0.3, 0.3}}};
    EXPECT_TRUE(radius_edge_ratio_exceeds(1e6, corners[0], corners[1], corners[2]));
}

}  // namespace
}  // namespace plateau
