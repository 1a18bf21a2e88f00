// Plateaus of timelines written down by hand.

#include "plateaus/plateaus.h"

#include <gtest/gtest.h>

namespace plateau {
namespace {

using Betti = std::vector<std::uint32_t>;

struct HandStep {
    double epsilon;
    Betti betti;
    Family family = Family::Surface;
};

Timeline written_down(const std::vector<HandStep>& steps) {
    Timeline timeline;
    timeline.dimension = 3;
    timeline.step_count = static_cast<Step>(steps.size());
    for (const HandStep& step : steps) {
        timeline.epsilons.push_back(step.epsilon);
        timeline.shown_family.push_back(step.family);
        timeline.betti.insert(timeline.betti.end(), step.betti.begin(), step.betti.end());
    }
    return timeline;
}

const Betti kSphere{1, 0, 1};
const Betti kTorus{1, 2, 1};
const Betti kNothing{0, 0, 0};

TEST(Plateaus, EndWhereTheNextOneBegins) {
    const auto found =
        find_plateaus(written_down({{16, kSphere}, {8, kSphere}, {4, kTorus}, {2, kTorus}, {1, kTorus}}));
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].first_step, 1u);
    EXPECT_EQ(found[0].last_step, 2u);
    EXPECT_EQ(found[0].epsilon_first, 16);
    EXPECT_EQ(found[0].epsilon_last, 8);
    EXPECT_EQ(found[0].betti, kSphere);
    EXPECT_EQ(found[0].ratio, 4);  // 16 / 4: it lasts until the step that ends it
    EXPECT_EQ(found[1].first_step, 3u);
    EXPECT_EQ(found[1].last_step, 5u);
    EXPECT_EQ(found[1].ratio, 4);  // 4 / 1: what comes after step 5 is not known yet
}

TEST(Plateaus, TheLastPositiveEpsilonStandsForZero) {
    const auto at_zero = find_plateaus(written_down({{8, kTorus}, {2, kTorus}, {0, kTorus}}));
    ASSERT_EQ(at_zero.size(), 1u);
    EXPECT_EQ(at_zero[0].ratio, 4);
    EXPECT_EQ(at_zero[0].epsilon_last, 0);
    const auto only_zero = find_plateaus(written_down({{8, kTorus}, {2, kTorus}, {0, kSphere}}));
    ASSERT_EQ(only_zero.size(), 2u);
    EXPECT_EQ(only_zero[0].ratio, 4);
    EXPECT_EQ(only_zero[1].ratio, 1);
    const auto never_positive = find_plateaus(written_down({{0, kSphere}}));
    ASSERT_EQ(never_positive.size(), 1u);
    EXPECT_EQ(never_positive[0].ratio, 1);
}

TEST(Plateaus, AreCutByAnotherFamilyAndByNothing) {
    const auto found = find_plateaus(written_down({{8, kTorus, Family::Surface},
                                                   {4, kTorus, Family::Delaunay},
                                                   {2, kNothing, Family::Surface},
                                                   {1, kTorus, Family::Surface}}));
    ASSERT_EQ(found.size(), 3u);
    EXPECT_EQ(found[0].family, Family::Surface);
    EXPECT_EQ(found[1].family, Family::Delaunay);
    EXPECT_EQ(found[1].ratio, 2);
    EXPECT_EQ(found[2].first_step, 4u);
}

TEST(Plateaus, RankedByRatioAndThenByStep) {
    const auto found = find_plateaus(
        written_down({{32, kSphere}, {16, kTorus}, {4, kSphere}, {2, kTorus}, {0.5, kSphere}, {0.25, kTorus}}));
    ASSERT_EQ(found.size(), 6u);  // ratios 2, 4, 2, 4, 2, 1
    EXPECT_EQ(ranked(found), (std::vector<std::uint32_t>{1, 3, 0, 2, 4, 5}));
}

TEST(Plateaus, MiddleIsTheFirstStepAtTheGeometricMean) {
    const Timeline timeline = written_down({{16, kTorus}, {8, kTorus}, {4, kTorus}, {2, kTorus}, {1, kTorus}});
    const auto found = find_plateaus(timeline);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(middle_step(timeline, found[0]), 3u);  // sqrt(16 * 1) = 4
    const Timeline to_zero = written_down({{16, kTorus}, {8, kTorus}, {0, kTorus}});
    EXPECT_EQ(middle_step(to_zero, find_plateaus(to_zero)[0]), 3u);
    const Timeline short_one = written_down({{16, kTorus}, {8, kSphere}});
    EXPECT_EQ(middle_step(short_one, find_plateaus(short_one)[0]), 1u);
}

TEST(Plateaus, SayWhatLastsLongestOverAnotherField) {
    Timeline timeline = written_down({{16, kTorus}, {8, kTorus}, {4, kTorus}, {2, kSphere}, {1, kSphere}});
    EXPECT_TRUE(find_plateaus(timeline)[0].torsion.empty());
    timeline.other_field = 3;
    for (const Betti& other : {kTorus, kSphere, kSphere, kTorus, kSphere}) {
        timeline.other_betti.insert(timeline.other_betti.end(), other.begin(), other.end());
    }
    const auto found = find_plateaus(timeline);
    ASSERT_EQ(found.size(), 2u);  // another field cuts nothing
    EXPECT_EQ(found[0].torsion, kSphere);
    EXPECT_EQ(found[1].torsion, kTorus);  // 2 to 1, and at 1 no longer
}

TEST(Plateaus, SayNothingWhereTheSameNumbersLastedAsLong) {
    Timeline timeline = written_down({{16, kTorus}, {8, kTorus}, {4, kSphere}});
    timeline.other_field = 3;
    for (const Betti& other : {kTorus, kSphere, kSphere}) {
        timeline.other_betti.insert(timeline.other_betti.end(), other.begin(), other.end());
    }
    EXPECT_TRUE(find_plateaus(timeline)[0].torsion.empty());  // 16 to 8, and 8 to 4
}

}  // namespace
}  // namespace plateau
