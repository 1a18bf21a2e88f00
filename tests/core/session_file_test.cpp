// Session files: every bit comes back, whatever is broken in them is told in a sentence.

#include "io/session_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "base/random.h"
#include "cloud/samples.h"
#include "io/cloud_reader.h"
#include "io/saved_options.h"

namespace plateau {
namespace {

SavedRun some_run() {
    SavedRun saved;
    saved.options = {{"family", "witness"}, {"nu", "1,2,3"}};
    saved.reached = 17;
    saved.hash = 0xfedcba9876543210u;
    saved.shown = 12;
    saved.view = "{\"camera\":[1,2,3],\n\"data\":\"points 3 \xC3\xA9\"}";
    return saved;
}

void expect_same(const SavedRun& a, const SavedRun& b) {
    EXPECT_EQ(a.options, b.options);
    EXPECT_EQ(a.reached, b.reached);
    EXPECT_EQ(a.hash, b.hash);
    EXPECT_EQ(a.shown, b.shown);
    EXPECT_EQ(a.view, b.view);
}

template <class Number>
void expect_same_bits(const std::vector<Number>& a, const std::vector<Number>& b) {
    ASSERT_EQ(a.size(), b.size());
    EXPECT_TRUE(a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Number)) == 0);
}

void expect_round_trip(const PointCloud& cloud) {
    const SavedRun saved = some_run();
    const std::string bytes = session_bytes(cloud, saved);
    // Neither the name nor what the caller expects decides what the file is.
    for (const ReadAs as : {ReadAs::Points, ReadAs::PointsOfAnyDimension, ReadAs::Distances}) {
        ReadOptions options;
        options.as = as;
        CloudReader reader(bytes, "run.csv", options);
        while (!reader.advance(0)) {
        }
        const auto read = reader.take();
        ASSERT_TRUE(read) << read.error().message;
        EXPECT_TRUE(read.value().warnings.empty());
        const PointCloud& same = read.value().cloud;
        EXPECT_EQ(same.dimension, cloud.dimension);
        EXPECT_EQ(same.distances.size, cloud.distances.size);
        expect_same_bits(same.coordinates, cloud.coordinates);
        expect_same_bits(same.distances.entries, cloud.distances.entries);
        expect_same_bits(same.distances.narrow, cloud.distances.narrow);
        ASSERT_TRUE(read.value().saved);
        expect_same(*read.value().saved, saved);
        EXPECT_EQ(session_bytes(same, *read.value().saved), bytes);
    }
}

TEST(SessionFile, KeepsEveryBitOfPoints) {
    expect_round_trip(sample_shape("torus", {.size = 500}).value());
    expect_round_trip(sample_shape("corner-curve", {.size = 300}).value());
    const double least = std::numeric_limits<double>::denorm_min();
    expect_round_trip({2, {-0.0, 0.1, 1e150, -1e150, least, 1.0 / 3}});
    expect_round_trip({5, {1, 2, 3, 4, 5, 0.1, -0.0, 7, 8, 9, 1e-300, 2, 3, 4, 5}});
}

TEST(SessionFile, SinglePrecisionOnlyWhereItKeepsEveryBit) {
    const PointCloud scan{3, {0.5, -0.0, double{0.1f}, 3e38f, 1e-45f, 2}};
    const std::string bytes = session_bytes(scan, {});
    EXPECT_NE(bytes.find("points 2 3 single\n"), std::string::npos);
    expect_round_trip(scan);
    for (const double other : {0.1, 1e39, 1e-46, 16777217.0}) {
        const PointCloud cloud{2, {0, 1, 2, other}};
        EXPECT_NE(session_bytes(cloud, {}).find("points 2 2 double\n"), std::string::npos) << other;
        expect_round_trip(cloud);
    }
}

TEST(SessionFile, KeepsEveryBitOfDistances) {
    PointCloud cloud;
    cloud.distances.size = 4;
    cloud.distances.entries = {0.1, 2, 1.0 / 3, 1e-300, 5, 1e150};
    expect_round_trip(cloud);
    // What came in double precision stays so, though single would do.
    cloud.distances.entries = {1, 2, 3, 4, 5, 6};
    expect_round_trip(cloud);
    cloud.distances.entries = {};
    cloud.distances.narrow = {0.1f, 2, 3, 4, 5, 1e-45f};
    expect_round_trip(cloud);
}

TEST(SessionFile, KeepsOptions) {
    RunOptions options;
    options.family = Family::Witness;
    options.nu = {1, 4, 5, 5};
    options.first = 7;
    options.max_steps = 90;
    options.until_epsilon = 0.1;
    options.rho = 1.0 / 3;
    options.field = 13;
    options.max_dimension = 2;
    options.noise_stop_from = 20000;
    options.metric = {Metric::Periodic, 8, {1.5, 0.1, 0}};
    SavedRun saved;
    saved.options = saved_options(options);
    const auto read = options_of(saved);
    ASSERT_TRUE(read) << read.error().message;
    const RunOptions& same = read.value();
    EXPECT_EQ(same.family, options.family);
    EXPECT_EQ(same.nu, options.nu);
    EXPECT_EQ(same.first, options.first);
    EXPECT_EQ(same.max_steps, options.max_steps);
    EXPECT_EQ(same.until_epsilon, options.until_epsilon);
    EXPECT_EQ(same.rho, options.rho);
    EXPECT_EQ(same.field, options.field);
    EXPECT_EQ(same.max_dimension, options.max_dimension);
    EXPECT_EQ(same.noise_stop_from, options.noise_stop_from);
    EXPECT_EQ(same.metric.metric, options.metric.metric);
    EXPECT_EQ(same.metric.box, options.metric.box);
    EXPECT_EQ(saved_options(same), saved.options);

    options.family = Family::Dilated;
    options.dilated = {.dilation = 0.3,
                       .pumps = true,
                       .pump = {.omega_bar = 0.125, .dilation = 0.5, .measure = SliverMeasure::Normalized}};
    options.min_length = 0.75;
    saved.options = saved_options(options);
    const RunOptions kept = options_of(saved).value();
    EXPECT_EQ(kept.dilated.dilation, 0.3);
    EXPECT_TRUE(kept.dilated.pumps);
    EXPECT_EQ(kept.dilated.pump.omega_bar, 0.125);
    EXPECT_EQ(kept.dilated.pump.dilation, 0.5);
    EXPECT_EQ(kept.dilated.pump.measure, SliverMeasure::Normalized);
    EXPECT_EQ(kept.min_length, 0.75);

    options.metric = {Metric::Geodesic, 11, {}};
    saved.options = saved_options(options);
    EXPECT_EQ(options_of(saved).value().metric.neighbors, 11u);
    const RunOptions usual;
    saved.options = saved_options(usual);
    const RunOptions again = options_of(saved).value();
    EXPECT_EQ(again.max_steps, usual.max_steps);
    EXPECT_EQ(again.noise_stop_from, usual.noise_stop_from);
    EXPECT_EQ(again.until_epsilon, 0);

    for (const SavedRun::Option& bad : std::vector<SavedRun::Option>{{"colour", "red"},
                                                                     {"nu", "1,,2"},
                                                                     {"nu", "1,"},
                                                                     {"family", "cech"},
                                                                     {"first", "-1"},
                                                                     {"first", "4294967296"},
                                                                     {"rho", "nan"},
                                                                     {"box", "1,x"},
                                                                     {"metric", ""},
                                                                     {"until", "inf"}}) {
        saved.options = {bad};
        const auto refused = options_of(saved);
        ASSERT_FALSE(refused) << bad.name << " " << bad.value;
        EXPECT_NE(refused.error().message.find('"' + bad.name + '"'), std::string::npos);
    }
}

TEST(SessionFile, ARunOpensAgainAndSaysIfItIsTheSame) {
    RunOptions options;
    options.max_steps = 120;
    Session first = Session::open(sample_shape("torus", {.size = 400}).value(), options).value();
    first.run({.steps = 1});
    while (first.timeline().step_count < 60) first.run({.steps = 10});
    SavedRun saved;
    saved.options = saved_options(first.options());
    saved.reached = first.timeline().step_count;
    saved.hash = first.hash();
    const auto read = read_cloud(session_bytes(first.cloud(), saved), "a.plateau", {});
    ASSERT_TRUE(read);
    Session second = Session::open(read.value().cloud, options_of(*read.value().saved).value()).value();
    EXPECT_EQ(agrees(saved, second), std::nullopt);
    second.run({});
    ASSERT_EQ(second.timeline().step_count, 120u);
    EXPECT_NE(second.hash(), saved.hash) << "it went on";
    EXPECT_EQ(agrees(saved, second), true);
    EXPECT_EQ(second.hash_at(saved.reached), saved.hash);
    first.run({});
    EXPECT_EQ(second.hash(), first.hash()) << "asking for an earlier hash changes nothing";
    saved.hash ^= 1;
    EXPECT_EQ(agrees(saved, second), false);
}

TEST(SessionFile, ARunThatWasLetOnPastItsNoiseHasNoStopThere) {
    RunOptions options;
    options.noise_stop_from = 0;
    Session session = Session::open(sample_shape("torus", {.size = 300}).value(), options).value();
    session.run({});
    ASSERT_LT(session.timeline().step_count, 300u);
    const SavedRun::Option stop{"noise-stop-from", "0"};
    const auto stops = [&] {
        const auto saved = saved_options(session.options());
        return std::count(saved.begin(), saved.end(), stop);
    };
    EXPECT_EQ(stops(), 1);
    session.run_past_noise();
    EXPECT_EQ(stops(), 0);
}

TEST(SessionFile, HundredThousandPoints) {
    const PointCloud cloud = sample_shape("torus", {.size = 100'000, .noise = 0.01}).value();
    const std::string bytes = session_bytes(cloud, some_run());
    EXPECT_LT(bytes.size(), 2'400'300u);
    const auto read = read_cloud(bytes, "torus.plateau", {});
    ASSERT_TRUE(read);
    expect_same_bits(read.value().cloud.coordinates, cloud.coordinates);
    EXPECT_EQ(session_bytes(read.value().cloud, *read.value().saved), bytes);
}

std::string sentence(const std::string& bytes, const ReadOptions& options = {}) {
    const auto read = read_cloud(bytes, "a.plateau", options);
    EXPECT_FALSE(read) << bytes;
    return read ? "" : read.error().message;
}

bool contains(const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
}

TEST(SessionFile, FaultsAreSentences) {
    const std::string numbers(48, '\0');
    const std::string begin = "plateau session 1\n";
    EXPECT_TRUE(contains(sentence("plateau session 2\ndata\n"), "format \"2\""));
    EXPECT_TRUE(contains(sentence("plateau session "), "format \"\""));
    EXPECT_TRUE(contains(sentence(begin), "no end"));
    EXPECT_TRUE(contains(sentence(begin + "data\n"), "no points"));
    EXPECT_TRUE(contains(sentence(begin + "points 2 3 double\nwhat\ndata\n" + numbers), "Line 3"));
    EXPECT_TRUE(contains(sentence(begin + "points 2 3 half\ndata\n" + numbers), "Line 2"));
    EXPECT_TRUE(contains(sentence(begin + "points 2 1 double\ndata\n" + numbers), "at least 2"));
    EXPECT_TRUE(contains(sentence(begin + "points 2 3 double\ndata\n" + numbers.substr(1)), "5 and a part"));
    EXPECT_TRUE(
        contains(sentence(begin + "points 2 3 double\ndata\n" + numbers.substr(8)), "promises 6 numbers, but 5"));
    EXPECT_TRUE(contains(sentence(begin + "points 2 3 double\ndata\n" + numbers + "12345678"), "7 are there"));
    EXPECT_TRUE(contains(sentence(begin + "points 4294967295 4294967295 double\ndata\n" + numbers), "promises"));
    EXPECT_TRUE(contains(sentence(begin + "points 18446744073709551615 3 double\ndata\n" + numbers), "more numbers"));
    EXPECT_TRUE(contains(sentence(begin + "distances 4294967295 single\ndata\n" + numbers), "promises"));
    EXPECT_TRUE(contains(sentence(begin + "points 2 3 double\nview 99\ndata\n" + numbers), "ends before"));
    EXPECT_TRUE(contains(sentence(begin + "points 2 3 double\nview -1\ndata\n" + numbers), "Line 3"));
    EXPECT_TRUE(contains(sentence(begin + "reached 5 0123\npoints 2 3 double\ndata\n" + numbers), "Line 2"));
    EXPECT_TRUE(contains(sentence(begin + "reached 5 0123456789ABCDEF\ndata\n"), "Line 2"));
    EXPECT_TRUE(contains(sentence(begin + "points 2 3 double\ndata\n" + numbers), "All 2 points are the same"));
    const std::string infinity = session_bytes({2, {0, 1, 2, std::numeric_limits<double>::infinity()}}, {});
    EXPECT_TRUE(contains(sentence(infinity), "Point 2"));
    PointCloud negative;
    negative.distances = {3, {1, -2, 3}, {}};
    EXPECT_TRUE(contains(sentence(session_bytes(negative, {})), "Row 3, column 1: the distance is negative"));
    ReadOptions columns;
    columns.columns = {1, 2};
    EXPECT_TRUE(contains(sentence(session_bytes({2, {0, 1, 2, 3}}, {}), columns), "no columns to choose"));
    PointCloud large;
    large.distances = {100, std::vector<double>(4950, 1.0), {}};
    ReadOptions little;
    little.memory_limit = 40'000;
    EXPECT_TRUE(contains(sentence(session_bytes(large, {}), little), "only 1 MB may be used"));
}

}  // namespace
}  // namespace plateau
