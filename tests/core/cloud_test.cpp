#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "cloud/point_cloud.h"
#include "cloud/trigonometry.h"

namespace plateau {
namespace {

TEST(Cloud, RowsAndSize) {
    const PointCloud cloud{2, {0, 1, 2, 3, 4, 5}};
    EXPECT_EQ(cloud.size(), 3u);
    EXPECT_EQ(cloud.point(1)[0], 2);
    EXPECT_EQ(cloud.point(2)[1], 5);
    EXPECT_EQ(PointCloud{}.size(), 0u);
}

TEST(Cloud, DistanceIsSummedInAxisOrder) {
    // Large before small: the sum in this order loses what the reverse order would keep.
    const PointCloud cloud{3, {0, 0, 0, 1e8, 1, 1}};
    EXPECT_EQ(distance_squared(cloud.point(0), cloud.point(1)), (1e16 + 1) + 1);
    EXPECT_NE(distance_squared(cloud.point(0), cloud.point(1)), 1e16 + (1.0 + 1.0));
}

TEST(Cloud, ValidatedKeepsAGoodCloud) {
    const auto result = validated({3, {0, 0, 0, 1e150, -1e150, 5e-324}});
    ASSERT_TRUE(result);
    EXPECT_EQ(result.value().size(), 2u);
}

TEST(Cloud, ValidatedTakesAnyNumberOfCoordinates) {
    EXPECT_TRUE(validated({4, {1, 2, 3, 4}}));
    EXPECT_TRUE(validated({300, std::vector<double>(600, 1)}));
}

TEST(Cloud, OnePointAndEqualPointsAreNoErrors) {
    EXPECT_TRUE(validated({2, {1, 2}}));
    EXPECT_TRUE(validated({2, {1, 2, 1, 2, 1, 2}}));
}

TEST(Cloud, ValidatedNamesTheFirstBadPoint) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double bad : {nan, infinity, -infinity, 2e150, -2e150}) {
        const auto result = validated({2, {0, 0, 1, bad, bad, bad}});
        ASSERT_FALSE(result);
        EXPECT_EQ(result.error().code, ErrorCode::NotANumber);
        EXPECT_NE(result.error().message.find("Point 2 "), std::string::npos) << result.error().message;
    }
}

TEST(Cloud, ValidatedRefusesEmptyAndOtherDimensions) {
    EXPECT_EQ(validated({}).error().code, ErrorCode::EmptyInput);
    EXPECT_EQ(validated({3, {}}).error().code, ErrorCode::EmptyInput);
    EXPECT_EQ(validated({0, {1}}).error().code, ErrorCode::UnsupportedDimension);
    EXPECT_EQ(validated({1, {1, 2}}).error().code, ErrorCode::UnsupportedDimension);
    EXPECT_EQ(validated({3, {1, 2, 3, 4}}).error().code, ErrorCode::RaggedRows);
}

TEST(Trigonometry, WithinOneInTenToTheFifteenOfTheLibrary) {
    double worst = 0;
    for (int k = -40'000; k <= 40'000; ++k) {
        const double turns = k / 10'007.0;
        const SineCosine mine = sine_cosine_of_turns(turns);
        const long double angle = 2 * std::acos(-1.0L) * static_cast<long double>(turns);
        worst = std::max(worst, static_cast<double>(std::abs(mine.sine - std::sin(angle))));
        worst = std::max(worst, static_cast<double>(std::abs(mine.cosine - std::cos(angle))));
    }
    EXPECT_LT(worst, 1e-15);
}

TEST(Trigonometry, ExactAtQuarterTurns) {
    for (int k = -8; k <= 8; ++k) {
        const SineCosine angle = sine_cosine_of_turns(k / 4.0);
        const int quarter = k & 3;
        EXPECT_EQ(angle.sine, quarter == 1 ? 1 : quarter == 3 ? -1 : 0);
        EXPECT_EQ(angle.cosine, quarter == 0 ? 1 : quarter == 2 ? -1 : 0);
    }
}

TEST(Trigonometry, AngleOfASquaredSine) {
    EXPECT_EQ(angle_of_squared_sine(0), 0);
    for (int k = 1; k <= 10'000; ++k) {
        const double squared = k / 10'000.0;
        const long double angle = std::asin(std::sqrt(static_cast<long double>(squared)));
        EXPECT_NEAR(angle_of_squared_sine(squared) / static_cast<double>(angle), 1, 1e-15) << squared;
    }
    EXPECT_NEAR(angle_of_squared_sine(1e-300), 1e-150, 1e-165);
}

}  // namespace
}  // namespace plateau
