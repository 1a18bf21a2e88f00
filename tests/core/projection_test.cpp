// Projections for the eye: distances that have coordinates come back, up to a motion; what is kept is told.

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"
#include "projection/projection.h"

namespace plateau {
namespace {

// n points of R^d of which coordinate k spreads over widths[k].
PointCloud box_cloud(std::uint32_t n, const std::vector<double>& widths) {
    Random random(3);
    PointCloud cloud{static_cast<std::uint32_t>(widths.size()), {}};
    for (std::uint32_t i = 0; i < n; ++i) {
        for (const double width : widths) cloud.coordinates.push_back(width * random.next_unit());
    }
    return cloud;
}

double drawn_distance(const Projection& projection, std::uint32_t a, std::uint32_t b) {
    double sum = 0;
    for (std::uint32_t k = 0; k < projection.axes; ++k) {
        const double difference = static_cast<double>(projection.coordinates[a * projection.axes + k]) -
                                  static_cast<double>(projection.coordinates[b * projection.axes + k]);
        sum += difference * difference;
    }
    return std::sqrt(sum);
}

DistanceRow rows_of(const PointCloud& cloud) {
    return [&cloud](std::uint32_t witness, std::span<double> out) {
        for (std::uint32_t other = 0; other < out.size(); ++other) {
            out[other] = std::sqrt(distance_squared(cloud.point(witness), cloud.point(other)));
        }
    };
}

void expect_same_distances(const PointCloud& cloud, const Projection& projection) {
    ASSERT_EQ(projection.coordinates.size(), std::size_t{cloud.size()} * projection.axes);
    for (std::uint32_t a = 0; a < cloud.size(); a += 7) {
        for (std::uint32_t b = 0; b < cloud.size(); b += 11) {
            const double distance = std::sqrt(distance_squared(cloud.point(a), cloud.point(b)));
            EXPECT_NEAR(drawn_distance(projection, a, b), distance, 1e-4);
        }
    }
}

double kept(const Projection& projection, std::size_t axes) {
    double sum = 0;
    for (std::size_t k = 0; k < axes; ++k) sum += projection.shares[k];
    return sum;
}

TEST(Projection, PrincipalAxesKeepDistancesWhereTheyAreEnough) {
    const PointCloud cloud = box_cloud(300, {5, 1, 3, 0.5, 2});
    const Projection projection = principal_axes(cloud);
    EXPECT_EQ(projection.axes, 5u);
    expect_same_distances(cloud, projection);
    EXPECT_NEAR(kept(projection, 5), 1, 1e-12);
    EXPECT_NEAR(projection.shares[0], 25.0 / 39.25, 0.05) << "variance of a uniform width goes with its square";
}
TEST(Projection, PrincipalAxesLeaveOutWhatSpreadsNowhere) {
    PointCloud cloud = box_cloud(100, {4, 3, 0, 0, 0});
    EXPECT_EQ(principal_axes(cloud).axes, 2u);
    const PointCloud wide = box_cloud(200, std::vector<double>(40, 1.0));
    const Projection projection = principal_axes(wide);
    EXPECT_EQ(projection.axes, kMostAxes);
    EXPECT_LT(kept(projection, kMostAxes), 0.5);
}
TEST(Projection, ScalingFindsThePointsOfTheirDistances) {
    for (const std::uint32_t n : {2u, 150u, 900u}) {  // beyond 400: by pivots
        const PointCloud cloud = box_cloud(n, {3, 2, 1, 1});
        const Projection projection = classical_scaling(n, rows_of(cloud));
        EXPECT_EQ(projection.axes, n == 2 ? 1u : 4u);
        expect_same_distances(cloud, projection);
        EXPECT_NEAR(kept(projection, projection.axes), 1, 1e-9);
    }
}
// In the shortest-path metric of a circle opposite points are pi apart: no plane has that, but it is still round.
TEST(Projection, ScalingSaysThatACirclesArcsDoNotFit) {
    constexpr std::uint32_t kCount = 200;
    const Projection projection = classical_scaling(kCount, [](std::uint32_t witness, std::span<double> out) {
        for (std::uint32_t other = 0; other < kCount; ++other) {
            const std::uint32_t around = (other + kCount - witness) % kCount;
            out[other] = std::min(around, kCount - around);
        }
    });
    EXPECT_NEAR(projection.shares[0], projection.shares[1], 1e-6);
    EXPECT_GT(projection.shares[0], 0.3);
    EXPECT_LT(kept(projection, projection.axes), 0.95);
    double least = 1e300;
    double most = 0;
    for (std::uint32_t i = 0; i < kCount; ++i) {
        const float* at = projection.coordinates.data() + i * projection.axes;
        const double radius = std::hypot(at[0], at[1]);
        least = std::min(least, radius);
        most = std::max(most, radius);
    }
    EXPECT_LT(most / least, 1.001);
}
TEST(Projection, PointsInOnePlaceAreDrawnInOnePlace) {
    PointCloud cloud{5, std::vector<double>(50, 2.0)};
    EXPECT_EQ(principal_axes(cloud).axes, 0u);
    EXPECT_EQ(classical_scaling(10, rows_of(cloud)).axes, 0u);
    EXPECT_EQ(classical_scaling(1, rows_of(cloud)).axes, 0u);
}

}  // namespace
}  // namespace plateau
