// What a session promises beyond the definitions: options, stops, budgets, memory.

#include "session/session.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "cloud/samples.h"

namespace plateau {
namespace {

PointCloud shape(std::string_view name, std::uint32_t size) {
    return sample_shape(name, {.size = size}).value();
}

Result<Session> open(PointCloud cloud, const std::function<void(RunOptions&)>& set) {
    RunOptions options;
    set(options);
    return Session::open(std::move(cloud), options);
}

TEST(Session, FillsInTheDefaultsOfTheDimension) {
    const auto space = open(shape("torus", 50), [](RunOptions&) {});
    EXPECT_EQ(space.value().options().family, Family::Auto);
    EXPECT_EQ(space.value().options().nu, (std::vector<std::uint32_t>{1, 6, 6, 4}));
    const auto plane = open(shape("circle-noise", 50), [](RunOptions&) {});
    EXPECT_EQ(plane.value().options().family, Family::Delaunay);
    EXPECT_EQ(plane.value().options().nu, (std::vector<std::uint32_t>{1, 2, 3}));
    const auto witness = open(shape("torus", 50), [](RunOptions& o) { o.family = Family::Witness; });
    EXPECT_EQ(witness.value().options().nu, (std::vector<std::uint32_t>{1, 2, 3, 4}));
}

TEST(Session, RefusesOptionsOutOfRangeWithASentence) {
    const std::vector<std::pair<std::string, std::function<void(RunOptions&)>>> bad{
        {"first landmark", [](RunOptions& o) { o.first = 50; }},
        {"nu",
         [](RunOptions& o) {
             o.nu = {0, 6};
         }},
        {"nu",
         [](RunOptions& o) {
             o.nu = {1, 1000};
         }},
        {"steps", [](RunOptions& o) { o.max_steps = 0; }},
        {"epsilon", [](RunOptions& o) { o.until_epsilon = -1; }},
        {"rho", [](RunOptions& o) { o.rho = std::numeric_limits<double>::quiet_NaN(); }},
        {"field", [](RunOptions& o) { o.field = 4; }},
    };
    for (const auto& [word, set] : bad) {
        const auto session = open(shape("torus", 50), set);
        ASSERT_FALSE(session) << word;
        EXPECT_EQ(session.error().code, ErrorCode::InvalidOption);
        EXPECT_NE(session.error().message.find(word), std::string::npos) << session.error().message;
    }
    const auto flat = open(shape("circle-noise", 50), [](RunOptions& o) { o.family = Family::Surface; });
    ASSERT_FALSE(flat);
    EXPECT_EQ(flat.error().code, ErrorCode::InvalidOption);
}

TEST(Session, RefusesPointsThatAloneWillNotFitAndSaysHowMuchTheyTake) {
    const auto session = open(shape("torus", 20000), [](RunOptions& o) { o.memory_limit = 1 << 20; });
    ASSERT_FALSE(session);
    EXPECT_EQ(session.error().code, ErrorCode::OutOfMemory);
    EXPECT_NE(session.error().message.find("about 9 MB"), std::string::npos) << session.error().message;
}

TEST(Session, GoesAsFarAsTheMemoryReaches) {
    constexpr std::uint64_t kLimit = 8 << 20;
    auto session = open(shape("torus", 4000), [](RunOptions& o) { o.memory_limit = kLimit; }).value();
    const std::uint32_t expected = affordable_landmarks(4000, 3, Family::Auto, kLimit);
    ASSERT_LT(expected, 4000u);
    const Progress progress = session.run({});
    ASSERT_EQ(progress.state, RunState::Stopped);
    EXPECT_EQ(session.timeline().step_count, session.timeline().landmarks.size()) << "every step has its numbers";
    EXPECT_GT(progress.memory, kLimit);
    EXPECT_LT(progress.memory, 2 * kLimit) << "it stops as soon as the memory is used up";
    EXPECT_GT(progress.steps_done, expected / 2);
    EXPECT_LT(progress.steps_done, expected * 2);
    EXPECT_NE(progress.stopped->message.find("of 4,000 landmarks"), std::string::npos) << progress.stopped->message;
    EXPECT_EQ(progress.stopped->message.find("curve"), std::string::npos) << progress.stopped->message;
}

TEST(Session, EstimatesTheMemoryThatItHolds) {
    for (const std::uint32_t size : {5000u, 20000u}) {
        for (const Family family : {Family::Auto, Family::Delaunay, Family::Witness}) {
            auto session = open(shape("torus", size), [&](RunOptions& o) { o.family = family; }).value();
            for (std::uint32_t steps = 500; steps <= 4000; steps *= 2) {
                const Progress progress = session.run({.steps = steps - session.progress().steps_done});
                const auto estimate = static_cast<double>(estimated_memory(size, steps, 3, family));
                EXPECT_GT(estimate, 0.7 * static_cast<double>(progress.memory)) << size << " " << steps;
                EXPECT_LT(estimate, 2 * static_cast<double>(progress.memory)) << size << " " << steps;
            }
        }
    }
    EXPECT_EQ(affordable_landmarks(1000, 3, Family::Auto, std::uint64_t{1} << 40), 1000u);
    EXPECT_EQ(affordable_landmarks(1000, 3, Family::Auto, 1000), 0u);
}

TEST(Session, EstimatesTheMemoryOfFamilyDilated) {
    const std::vector<std::pair<std::string, std::uint32_t>> clouds = {
        {"circle-noise", 2000}, {"torus", 5000}, {"torus", 20000}, {"clifford", 5000}, {"s3", 5000}, {"s2xs1", 2000},
    };
    for (const auto& [name, size] : clouds) {
        auto session = open(shape(name, size), [](RunOptions& o) { o.family = Family::Dilated; }).value();
        const std::uint32_t dimension = session.cloud().dimension;
        for (std::uint32_t steps = 100; steps <= (dimension == 5 ? 100u : 400u); steps *= 2) {
            const Progress progress = session.run({.steps = steps - session.progress().steps_done});
            const auto estimate = static_cast<double>(estimated_memory(size, steps, dimension, Family::Dilated) +
                                                      input_memory(session.cloud()));
            EXPECT_GT(estimate, 0.65 * static_cast<double>(progress.memory)) << name << " " << size << " " << steps;
            EXPECT_LT(estimate, 2.2 * static_cast<double>(progress.memory)) << name << " " << size << " " << steps;
        }
    }
}

// On a curve in space D(L) grows with the square of the landmarks, which no estimate by n foresees.
TEST(Session, StopsWhenTheMemoryIsSpentAndKeepsWhatItComputed) {
    auto session = open(shape("helix", 2000), [](RunOptions& o) { o.memory_limit = 24'100'000; }).value();
    const Progress progress = session.run({});
    ASSERT_EQ(progress.state, RunState::Stopped);
    ASSERT_TRUE(progress.stopped);
    EXPECT_EQ(progress.stopped->code, ErrorCode::OutOfMemory);
    EXPECT_GT(progress.steps_done, 100u);
    EXPECT_LT(progress.steps_done, 2000u);
    EXPECT_EQ(session.timeline().step_count, session.timeline().landmarks.size()) << "every step has its numbers";
    EXPECT_FALSE(session.plateaus().empty());

    const Progress again = session.run({});
    EXPECT_EQ(again.steps_done, progress.steps_done) << "a stopped run stays stopped";

    auto same = open(shape("helix", 2000), [&](RunOptions& o) { o.max_steps = progress.steps_done; }).value();
    same.run({});
    EXPECT_EQ(same.hash(), session.hash()) << "what was computed is what a shorter run computes";
}

TEST(Session, StopsAtTheStepOrTheScaleAskedFor) {
    auto counted = open(shape("torus", 300), [](RunOptions& o) { o.max_steps = 40; }).value();
    EXPECT_EQ(counted.run({}).steps_done, 40u);
    EXPECT_EQ(counted.progress().state, RunState::Finished);

    auto scaled = open(shape("torus", 300), [](RunOptions& o) { o.until_epsilon = 0.5; }).value();
    const Progress progress = scaled.run({});
    EXPECT_LE(progress.epsilon, 0.5);
    EXPECT_GT(scaled.timeline().epsilon(progress.steps_done - 1), 0.5) << "the first step that reaches it is the last";
}

TEST(Session, ABudgetOfStepsIsKeptToTheStep) {
    auto session = open(shape("torus", 100), [](RunOptions&) {}).value();
    Step expected = 0;
    for (const std::uint32_t steps : {1u, 2u, 30u}) {
        expected += steps;
        EXPECT_EQ(session.run({.steps = steps}).steps_done, expected);
    }
}

TEST(Session, ABudgetOfTimeDoesNotLeaveStepsBehindForever) {
    auto session = open(shape("torus", 400), [](RunOptions&) {}).value();
    std::uint32_t calls = 0;
    while (session.progress().state == RunState::Preparing || session.progress().state == RunState::Running) {
        session.run({.milliseconds = 0});
        ASSERT_LT(++calls, 5000u);
    }
    EXPECT_EQ(session.progress().steps_done, 400u);
    auto whole = open(shape("torus", 400), [](RunOptions&) {}).value();
    whole.run({});
    EXPECT_EQ(session.hash(), whole.hash());
}

}  // namespace
}  // namespace plateau
