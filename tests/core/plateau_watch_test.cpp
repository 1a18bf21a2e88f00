#include "plateaus/plateau_watch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "cloud/samples.h"
#include "session/session.h"

namespace plateau {
namespace {

TEST(Exponential, IsThatOfTheLibrary) {
    for (double x = 0; x <= 50; x += x < 2 ? 0.01 : 0.3) {
        EXPECT_NEAR(exponential(x) / std::exp(x), 1, 1e-12) << x;
    }
    EXPECT_EQ(exponential(0), 1);
}

PointCloud helix() {
    return sample_shape("helix", {.size = 300}).value();
}

/// First steps of the plateaus that are long enough, from the whole record.
std::vector<Step> long_ones(const Session& session, double length) {
    std::vector<Step> result;
    for (const Plateau& plateau : session.plateaus()) {
        if (plateau.length() >= length) result.push_back(plateau.first_step);
    }
    return result;
}

TEST(PlateauWatch, StopsAtEachPlateauThatIsLongEnough) {
    for (const Family family : {Family::Auto, Family::Dilated}) {
        for (const double length : {0.05, 0.2}) {
            RunOptions options;
            options.family = family;
            options.max_steps = 120;
            Session whole = Session::open(helix(), options).value();
            whole.run({});
            const std::vector<Step> expected = long_ones(whole, length);
            ASSERT_GE(expected.size(), 2u);

            options.min_length = length;
            for (const Budget budget : {Budget{}, Budget{.steps = 1}}) {
                Session session = Session::open(helix(), options).value();
                std::vector<Step> stops;
                for (;;) {
                    Progress progress = session.run(budget);
                    while (progress.state == RunState::Running) progress = session.run(budget);
                    ASSERT_EQ(progress.state, RunState::Finished);
                    if (!progress.ended_at_plateau) break;
                    // What ended it is the plateau of the step before, long enough with this step's epsilon only.
                    const Step last = progress.steps_done;
                    const Timeline& timeline = session.timeline();
                    Step first = 0;
                    for (const Plateau& plateau : session.plateaus()) {
                        if (plateau.first_step <= last - 1 && last - 1 <= plateau.last_step) first = plateau.first_step;
                    }
                    ASSERT_GT(first, 0u);
                    EXPECT_GE(std::log(timeline.epsilon(first) / timeline.epsilon(last)), length - 1e-12);
                    EXPECT_LT(std::log(timeline.epsilon(first) / timeline.epsilon(last - 1)), length);
                    stops.push_back(first);
                    session.run_to_next_plateau();
                    EXPECT_FALSE(session.progress().ended_at_plateau);
                }
                EXPECT_EQ(stops, expected);
                EXPECT_EQ(session.hash(), whole.hash());
            }
        }
    }
}

TEST(PlateauWatch, WithoutALengthTheRunEndsWhereItDid) {
    RunOptions options;
    options.max_steps = 40;
    Session session = Session::open(helix(), options).value();
    const Progress progress = session.run({});
    EXPECT_EQ(progress.steps_done, 40u);
    EXPECT_FALSE(progress.ended_at_plateau);
    session.run_to_next_plateau();
    EXPECT_EQ(session.progress().state, RunState::Finished);
}

TEST(PlateauWatch, RefusesALengthThatIsNone) {
    for (const double length : {-0.5, 1e9, std::nan("")}) {
        RunOptions options;
        options.min_length = length;
        const auto opened = Session::open(helix(), options);
        ASSERT_FALSE(opened);
        EXPECT_EQ(opened.error().code, ErrorCode::InvalidOption);
    }
}

}  // namespace
}  // namespace plateau
