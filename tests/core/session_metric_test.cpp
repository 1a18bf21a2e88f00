// Metrics, dimensions and fields as options of a run: what is filled in, what is refused, and the shapes that show.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "base/random.h"
#include "cloud/samples.h"
#include "cloud/trigonometry.h"
#include "session/session.h"

namespace plateau {
namespace {

using Betti = std::vector<std::uint32_t>;

PointCloud uniform(std::uint32_t dimension, std::uint32_t size) {
    Random random(9);
    PointCloud cloud{dimension, {}};
    for (std::uint32_t i = 0; i < dimension * size; ++i) cloud.coordinates.push_back(random.next_unit());
    return cloud;
}

/// Uniform in the unit ball, without its middle.
PointCloud ball(std::uint32_t dimension, std::uint32_t size, std::uint64_t seed) {
    Random random(seed);
    PointCloud cloud{dimension, {}};
    while (cloud.size() < size) {
        std::vector<double> point;
        double norm_squared = 0;
        for (std::uint32_t axis = 0; axis < dimension; ++axis) {
            point.push_back(2 * random.next_unit() - 1);
            norm_squared += point.back() * point.back();
        }
        if (norm_squared > 1 || norm_squared < 0.01) continue;
        cloud.coordinates.insert(cloud.coordinates.end(), point.begin(), point.end());
    }
    return cloud;
}

PointCloud matrix_of(std::uint32_t size) {
    PointCloud cloud;
    cloud.distances.size = size;
    cloud.distances.entries.assign(DistanceMatrix::entry_count(size), 1);
    return cloud;
}

RunOptions by(Metric metric) {
    RunOptions options;
    options.metric.metric = metric;
    return options;
}

std::string refusal(const PointCloud& cloud, const RunOptions& options) {
    const auto opened = Session::open(cloud, options);
    if (opened) return "";
    EXPECT_EQ(opened.error().code, ErrorCode::InvalidOption);
    return opened.error().message;
}

/// The longest plateau with these Betti numbers; of length 0 if there is none.
Plateau longest_with(const PointCloud& cloud, const RunOptions& options, const Betti& betti) {
    auto opened = Session::open(cloud, options);
    EXPECT_TRUE(opened) << opened.error().message;
    Session session = std::move(opened).value();
    session.run({});
    Plateau longest;
    for (const Plateau& plateau : session.plateaus()) {
        if (plateau.betti == betti && plateau.ratio > longest.ratio) longest = plateau;
    }
    return longest;
}

double length_of(const PointCloud& cloud, const RunOptions& options, const Betti& betti) {
    return longest_with(cloud, options, betti).length();
}

TEST(MetricOptions, WhatIsFilledIn) {
    const auto filled_in = [](const PointCloud& cloud, const RunOptions& options) {
        return Session::open(cloud, options).value().options();
    };
    EXPECT_EQ(filled_in(uniform(2, 9), {}).family, Family::Delaunay);
    EXPECT_EQ(filled_in(uniform(3, 9), {}).family, Family::Auto);
    EXPECT_FALSE(filled_in(uniform(3, 9), {}).max_dimension);
    const RunOptions four = filled_in(uniform(4, 9), {});
    EXPECT_EQ(four.family, Family::Dilated);
    EXPECT_FALSE(four.max_dimension);
    EXPECT_EQ(filled_in(uniform(5, 9), {}).family, Family::Dilated);
    RunOptions asks_for_nu;
    asks_for_nu.nu = {1, 2, 3};
    EXPECT_EQ(filled_in(uniform(4, 9), asks_for_nu).family, Family::Witness);
    const RunOptions six = filled_in(uniform(6, 9), {});
    EXPECT_EQ(six.family, Family::Witness);
    EXPECT_EQ(six.max_dimension, 5u);
    EXPECT_EQ(six.nu, (std::vector<std::uint32_t>{1, 2, 3, 4, 5, 6, 7}));
    EXPECT_EQ(filled_in(uniform(7, 9), {}).max_dimension, 6u);
    EXPECT_EQ(filled_in(uniform(50, 9), {}).max_dimension, 2u);
    for (const Metric metric : {Metric::L1, Metric::LInf, Metric::Angular, Metric::Projective, Metric::Geodesic}) {
        EXPECT_EQ(filled_in(uniform(3, 9), by(metric)).family, Family::Witness);
        EXPECT_EQ(filled_in(uniform(3, 9), by(metric)).max_dimension, 2u);
    }
    EXPECT_EQ(filled_in(uniform(2, 9), by(Metric::Periodic)).max_dimension, 2u) << "a torus has a void";
    const RunOptions matrix = filled_in(matrix_of(4), by(Metric::Matrix));
    EXPECT_EQ(matrix.max_dimension, 2u);
    EXPECT_EQ(matrix.nu, (std::vector<std::uint32_t>{1, 2, 3, 4}));
}

TEST(MetricOptions, WhatIsRefused) {
    const PointCloud cloud = uniform(3, 9);
    for (const Family family : {Family::Delaunay, Family::Surface, Family::Auto, Family::Dilated}) {
        RunOptions options = by(Metric::L1);
        options.family = family;
        EXPECT_NE(refusal(cloud, options).find("Only family witness"), std::string::npos);
        options = {};
        options.family = family;
        EXPECT_NE(refusal(uniform(6, 9), options).find("6 coordinates"), std::string::npos);
        options.metric.metric = Metric::Matrix;
        EXPECT_NE(refusal(matrix_of(4), options).find("Only family witness"), std::string::npos);
    }
    RunOptions options;
    options.max_dimension = 1;
    EXPECT_NE(refusal(cloud, options).find("for family witness only"), std::string::npos);
    options.family = Family::Witness;
    options.max_dimension = 7;
    EXPECT_NE(refusal(cloud, options).find("beta6 at most, for simplices of 8 points"), std::string::npos);
    options = by(Metric::Geodesic);
    options.metric.neighbors = 0;
    EXPECT_NE(refusal(cloud, options).find("at least 1 neighbor"), std::string::npos);
    EXPECT_NE(refusal(cloud, by(Metric::Matrix)).find("needs a distance matrix"), std::string::npos);
    EXPECT_NE(refusal(matrix_of(4), by(Metric::L1)).find("has no coordinates"), std::string::npos);
    EXPECT_NE(refusal(matrix_of(4), {}).find("has no coordinates"), std::string::npos);

    PointCloud origin = cloud;
    for (std::size_t k = 3; k < 6; ++k) origin.coordinates[k] = 0;
    EXPECT_NE(refusal(origin, by(Metric::Angular)).find("Point 2 is the origin"), std::string::npos);
    EXPECT_NE(refusal(origin, by(Metric::Projective)).find("Point 2 is the origin"), std::string::npos);
    PointCloud outside = cloud;
    outside.coordinates[4] = 1.5;
    EXPECT_NE(refusal(outside, by(Metric::Periodic)).find("Point 2 lies outside the unit box"), std::string::npos);
    for (const std::vector<double>& box : std::vector<std::vector<double>>{{1, 1}, {-1}, {0}, {1, 2, NAN}, {0, 0, 0}}) {
        options = by(Metric::Periodic);
        options.metric.box = box;
        EXPECT_NE(refusal(cloud, options), "");
    }
    options.metric.box = {0, 0, 2};
    EXPECT_EQ(refusal(outside, options), "");
}

TEST(MetricOptions, AGraphInPiecesEndsTheRunBeforeItsFirstStep) {
    PointCloud cloud = uniform(2, 40);
    for (std::size_t k = 60; k < cloud.coordinates.size(); ++k) cloud.coordinates[k] += 10;
    RunOptions options = by(Metric::Geodesic);
    options.metric.neighbors = 6;
    options.noise_stop_from = 0;
    Session session = Session::open(cloud, options).value();
    while (session.progress().state == RunState::Preparing) session.run({.milliseconds = 0});
    const Progress progress = session.run({});
    EXPECT_EQ(progress.state, RunState::Stopped);
    EXPECT_EQ(progress.steps_done, 0u);
    ASSERT_TRUE(progress.stopped);
    EXPECT_EQ(
        progress.stopped->message,
        "The graph of the 6 nearest neighbors falls into 2 pieces, the smallest of 10 points around point 31: take "
        "more neighbors, or each piece by itself.");
    options.metric.neighbors = 39;
    EXPECT_GT(length_of(cloud, options, {1, 0}), 0);
}

TEST(MetricOptions, AGraphThatWillNotFitIsRefused) {
    RunOptions options = by(Metric::Geodesic);
    options.memory_limit = 20 << 20;
    const PointCloud cloud = uniform(2, 2000);
    EXPECT_EQ(refusal(cloud, options), "");
    options.metric.neighbors = 1'000'000'000;
    const auto opened = Session::open(cloud, options);
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().code, ErrorCode::OutOfMemory);
}

TEST(MetricOptions, OnePointOrOnePlaceIsOneStep) {
    for (const Metric metric : {Metric::L1, Metric::Angular, Metric::Projective, Metric::Periodic, Metric::Geodesic}) {
        for (const std::uint32_t copies : {1u, 2u, 5u}) {
            PointCloud cloud{2, {}};
            for (std::uint32_t k = 0; k < copies; ++k) cloud.coordinates.insert(cloud.coordinates.end(), {0.5, 0.25});
            Session session = Session::open(cloud, by(metric)).value();
            EXPECT_EQ(session.run({}).state, RunState::Finished);
            EXPECT_EQ(session.timeline().step_count, 1u);
            EXPECT_EQ(session.timeline().epsilon(1), 0);
        }
    }
}

TEST(MetricOptions, AsManyBettiNumbersAsAskedFor) {
    const PointCloud cloud = uniform(3, 60);
    Betti first;
    for (const std::uint32_t last : {0u, 1u, 2u, 4u, 6u}) {
        RunOptions options;
        options.family = Family::Witness;
        options.max_dimension = last;
        options.max_steps = 30;
        options.nu = {1, 3, 4, 5, 6, 7, 8, 8};
        Session session = Session::open(cloud, options).value();
        session.run({});
        const Timeline& timeline = session.timeline();
        ASSERT_EQ(timeline.betti.size(), 30 * (last + 1));
        ASSERT_EQ(timeline.simplices.size(), last + 1);
        for (Step step = 1; step <= 30; ++step) {
            if (last == 0) first.push_back(timeline.betti_at(step)[0]);
            EXPECT_EQ(timeline.betti_at(step)[0], first[step - 1]);
        }
    }
}

TEST(MetricOptions, TheNoiseIsMeasuredBeforeTheFirstStepWhereNoBallIsSmall) {
    for (const Metric metric : {Metric::L1, Metric::Geodesic, Metric::Periodic}) {
        RunOptions options = by(metric);
        options.noise_stop_from = 0;
        Session session = Session::open(uniform(2, 300), options).value();
        const Progress progress = session.run({});
        EXPECT_TRUE(progress.ended_at_noise);
        EXPECT_GT(progress.noise, 0);
        EXPECT_LE(progress.epsilon, progress.noise);
        EXPECT_GT(session.timeline().epsilon(progress.steps_done - 1), progress.noise);
    }
}

TEST(Shapes, AFlatTorusShowsInItsBoxAndNotInThePlane) {
    const PointCloud cloud = uniform(2, 2000);
    RunOptions options = by(Metric::Periodic);
    options.nu = {1, 4, 5, 5};
    options.max_steps = 100;
    EXPECT_GT(length_of(cloud, options, {1, 2, 1}), 0.7);
    // The same torus, a thousand times as large and a few boxes away.
    PointCloud far = cloud;
    for (std::size_t k = 0; k < far.coordinates.size(); ++k) far.coordinates[k] = far.coordinates[k] * 1024 - 5120;
    options.metric.box = {1024};
    EXPECT_GT(length_of(far, options, {1, 2, 1}), 0.7);
    RunOptions plane = options;
    plane.metric = {};
    plane.family = Family::Witness;
    plane.max_dimension = 2;
    EXPECT_EQ(length_of(cloud, plane, {1, 2, 1}), 0);
    // Only one axis with a period: a cylinder.
    options.metric.box = {1, 0};
    EXPECT_GT(length_of(cloud, options, {1, 1, 0}), 0.6);
}

TEST(Shapes, TheProjectivePlaneHasTorsion) {
    // Lines through a ball: every direction as often, at any length.
    const PointCloud cloud = ball(3, 2000, 4);
    RunOptions options = by(Metric::Projective);
    options.nu = {1, 4, 5, 5};
    options.max_steps = 90;
    const Plateau over_two = longest_with(cloud, options, {1, 1, 1});
    EXPECT_GT(over_two.length(), 0.8);
    EXPECT_EQ(over_two.torsion, (Betti{1, 0, 0}));
    options.field = 3;
    EXPECT_EQ(length_of(cloud, options, {1, 1, 1}), 0);
    EXPECT_GT(length_of(cloud, options, {1, 0, 0}), 0.8);
    // Directions instead of lines: the sphere.
    options.metric.metric = Metric::Angular;
    const Plateau directions = longest_with(cloud, options, {1, 0, 1});
    EXPECT_GT(directions.length(), 0.8);
    EXPECT_TRUE(directions.torsion.empty());
}

TEST(Shapes, ASwissRollUnrollsAlongItself) {
    const PointCloud cloud = sample_shape("swiss-roll", {.size = 1500}).value();
    RunOptions options = by(Metric::Geodesic);
    options.nu = {1, 4, 5, 5};
    options.max_steps = 120;
    const double unrolled = length_of(cloud, options, {1, 0, 0});
    RunOptions euclidean = options;
    euclidean.metric = {};
    euclidean.family = Family::Witness;
    Session session = Session::open(cloud, euclidean).value();
    session.run({});
    std::uint32_t most_loops = 0;
    for (Step step = 1; step <= session.timeline().step_count; ++step) {
        most_loops = std::max(most_loops, session.timeline().betti_at(step)[1]);
    }
    EXPECT_GT(most_loops, 0u);
    EXPECT_GT(unrolled, 2 * length_of(cloud, euclidean, {1, 0, 0}));
}

TEST(Shapes, AThreeSphereInFourDimensions) {
    PointCloud cloud = ball(4, 2500, 3);
    for (std::uint32_t i = 0; i < cloud.size(); ++i) {
        double norm_squared = 0;
        for (const double coordinate : cloud.point(i)) norm_squared += coordinate * coordinate;
        for (std::uint32_t axis = 0; axis < 4; ++axis) cloud.coordinates[4 * i + axis] /= std::sqrt(norm_squared);
    }
    RunOptions options;
    options.nu = {1, 6, 8, 8, 8};
    options.max_steps = 40;
    EXPECT_GT(length_of(cloud, options, {1, 0, 0, 1}), 0.3);
}

}  // namespace
}  // namespace plateau
