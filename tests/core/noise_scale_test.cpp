// The noise of a cloud against the definition: all distances, sorted.

#include "landmarks/noise_scale.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "cloud/samples.h"
#include "session/session.h"

namespace plateau {
namespace {

double measured(const PointCloud& cloud, double slice_ms) {
    LandmarkLists lists(cloud, 3);
    while (!lists.prepare(Deadline(slice_ms))) {
    }
    NoiseScale noise(lists);
    while (!noise.advance(Deadline(slice_ms))) {
    }
    return noise.epsilon();
}

double defined(const PointCloud& cloud) {
    std::vector<double> nearest;
    for (std::uint32_t a = 0; a < cloud.size(); ++a) {
        double least = std::numeric_limits<double>::infinity();
        for (std::uint32_t b = 0; b < cloud.size(); ++b) {
            if (a != b) least = std::min(least, std::sqrt(distance_squared(cloud.point(a), cloud.point(b))));
        }
        nearest.push_back(least);
    }
    std::sort(nearest.begin(), nearest.end());
    const std::size_t half = nearest.size() / 2;
    return nearest.size() % 2 == 1 ? nearest[half] : (nearest[half - 1] + nearest[half]) / 2;
}

PointCloud cut(PointCloud cloud, std::uint32_t size) {
    cloud.coordinates.resize(static_cast<std::size_t>(size) * cloud.dimension);
    return cloud;
}

/// The cloud with its first `copies` points once more.
PointCloud doubled(PointCloud cloud, std::uint32_t copies) {
    const std::vector<double> all = cloud.coordinates;
    cloud.coordinates.insert(cloud.coordinates.end(), all.begin(),
                             all.begin() + static_cast<std::ptrdiff_t>(copies) * cloud.dimension);
    return cloud;
}

TEST(NoiseScale, IsTheMedianOfTheDistancesToTheNearestOther) {
    for (const char* shape : {"torus", "circle-noise", "helix"}) {
        const PointCloud cloud = sample_shape(shape, {.size = 301, .noise = 0.02}).value();
        for (const std::uint32_t size : {2u, 3u, 4u, 7u, 8u, 9u, 64u, 129u, 300u, 301u}) {
            const PointCloud part = cut(cloud, size);
            for (const double slice_ms : {0.0, std::numeric_limits<double>::infinity()}) {
                EXPECT_EQ(measured(part, slice_ms), defined(part)) << shape << " " << size;
            }
        }
    }
}

TEST(NoiseScale, CountsDuplicatesAsTheyAre) {
    const PointCloud cloud = sample_shape("torus", {.size = 60}).value();
    for (const std::uint32_t copies : {1u, 10u, 19u, 20u, 21u, 30u, 60u}) {
        const PointCloud part = doubled(cloud, copies);
        EXPECT_EQ(measured(part, 0), defined(part)) << copies;
    }
    EXPECT_EQ(measured(doubled(cloud, 60), 0), 0);
}

TEST(NoiseScale, OfAGridIsItsSpacing) {
    PointCloud grid{.dimension = 2, .coordinates = {}};
    for (int x = 0; x < 12; ++x) {
        for (int y = 0; y < 12; ++y) grid.coordinates.insert(grid.coordinates.end(), {x * 0.25, y * 0.25});
    }
    EXPECT_EQ(measured(grid, 0), 0.25);
}

Session opened(PointCloud cloud, std::uint32_t noise_stop_from) {
    RunOptions options;
    options.noise_stop_from = noise_stop_from;
    return Session::open(std::move(cloud), options).value();
}

TEST(NoiseStop, EndsAtTheFirstStepThatReachesTheNoise) {
    for (const std::uint32_t size : {60u, 400u, 1500u}) {
        const PointCloud cloud = sample_shape("torus", {.size = size, .noise = 0.01}).value();
        Session session = opened(cloud, size);
        const Progress progress = session.run({});
        EXPECT_EQ(progress.state, RunState::Finished);
        EXPECT_TRUE(progress.ended_at_noise);
        EXPECT_EQ(progress.noise, defined(cloud));
        EXPECT_LE(progress.epsilon, progress.noise);
        EXPECT_GT(session.timeline().epsilon(progress.steps_done - 1), progress.noise);
        EXPECT_LT(progress.steps_done, size);
        EXPECT_GT(progress.steps_done, NoiseScale::safe_landmarks(cloud, Metric::Euclidean));
    }
}

TEST(NoiseStop, LiftedItGoesOnWithTheSameRun) {
    const PointCloud cloud = sample_shape("torus", {.size = 500, .noise = 0.01}).value();
    Session whole = opened(cloud, 501);
    EXPECT_EQ(whole.run({}).noise, 0) << "smaller than asked: no stop";

    Session late = opened(cloud, 0);
    const Step at_noise = late.run({}).steps_done;
    const std::uint64_t hash = late.hash();
    late.run_past_noise();
    EXPECT_EQ(late.progress().state, RunState::Running);
    EXPECT_EQ(late.progress().steps_done, at_noise);
    EXPECT_EQ(late.hash(), hash) << "nothing is computed again";
    const Progress end = late.run({});
    EXPECT_EQ(end.steps_done, 500u);
    EXPECT_FALSE(end.ended_at_noise);
    EXPECT_EQ(late.hash(), whole.hash());

    Session early = opened(cloud, 0);
    early.run({.steps = 3});
    early.run_past_noise();
    EXPECT_EQ(early.run({}).steps_done, 500u);
    EXPECT_EQ(early.hash(), whole.hash());
}

TEST(NoiseStop, IsTheSameForAnyBudget) {
    const PointCloud cloud = sample_shape("torus", {.size = 1200}).value();
    Session whole = opened(cloud, 0);
    const Progress progress = whole.run({});
    Session sliced = opened(cloud, 0);
    for (std::uint32_t calls = 0; sliced.progress().state < RunState::Finished; ++calls) {
        sliced.run({.milliseconds = 0});
        ASSERT_LT(calls, 50000u);
    }
    EXPECT_EQ(sliced.progress().steps_done, progress.steps_done);
    EXPECT_EQ(sliced.hash(), whole.hash());
}

TEST(NoiseStop, ThereIsNoneWhereMostPointsAreDuplicates) {
    Session session = opened(doubled(sample_shape("torus", {.size = 80}).value(), 80), 0);
    const Progress progress = session.run({});
    EXPECT_EQ(progress.noise, 0);
    EXPECT_FALSE(progress.ended_at_noise);
    EXPECT_EQ(progress.steps_done, 80u);
}

}  // namespace
}  // namespace plateau
