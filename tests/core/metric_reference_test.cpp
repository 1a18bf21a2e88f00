// Lists, runs and epsilon of every metric against distances from their definitions; the scan against the tree.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "base/random.h"
#include "comparison.h"
#include "landmarks/landmark_lists.h"
#include "laws.h"
#include "metrics/coordinate_rows.h"
#include "metrics/distance_rows.h"
#include "reference/elimination.h"
#include "reference/metrics.h"
#include "reference/witness.h"
#include "session/session.h"

namespace plateau {
namespace {

using namespace reference;

const Deadline kNoDeadline = Deadline::never();

PointCloud uniform(std::uint32_t dimension, std::uint32_t size, std::uint64_t seed) {
    Random random(seed);
    PointCloud cloud{dimension, {}};
    for (std::uint32_t i = 0; i < dimension * size; ++i) cloud.coordinates.push_back(random.next_unit());
    return cloud;
}

/// Integer points from `low` to `high`, some of them more than once, none of them the origin.
PointCloud integers(std::uint32_t dimension, std::uint32_t size, int low, int high, std::uint64_t seed) {
    Random random(seed);
    PointCloud cloud{dimension, {}};
    while (cloud.size() < size) {
        std::vector<double> point;
        for (std::uint32_t axis = 0; axis < dimension; ++axis) {
            point.push_back(low + static_cast<int>(random.next_bits() % static_cast<std::uint64_t>(high - low + 1)));
        }
        if (std::count(point.begin(), point.end(), 0.0) == dimension) continue;
        cloud.coordinates.insert(cloud.coordinates.end(), point.begin(), point.end());
    }
    return cloud;
}

PointCloud with_matrix(const Table& table, bool rooted) {
    PointCloud cloud;
    cloud.distances.size = static_cast<std::uint32_t>(table.size());
    for (std::size_t a = 0; a < table.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b) {
            cloud.distances.entries.push_back(rooted ? std::sqrt(table[a][b]) : table[a][b]);
        }
    }
    return cloud;
}

MetricOptions by(Metric metric, std::vector<double> box = {}) {
    MetricOptions options;
    options.metric = metric;
    options.box = std::move(box);
    return options;
}

struct MetricCase {
    std::string name;
    PointCloud cloud;
    MetricOptions options;
    Table table;                             ///< orders as the distances do
    std::function<double(double)> distance;  ///< of an entry of the table; none where it is a rank
};

std::ostream& operator<<(std::ostream& out, const MetricCase& value) {
    return out << value.name;
}

std::vector<MetricCase> metric_cases() {
    const auto root = [](double squared) { return std::sqrt(squared); };
    const auto itself = [](double value) { return value; };
    std::vector<MetricCase> cases;
    const struct {
        std::string name;
        PointCloud cloud;
    } clouds[] = {{"grid2", integers(2, 60, -3, 4, 1)}, {"grid3", integers(3, 60, -1, 2, 2)},
                  {"grid5", integers(5, 40, -1, 1, 3)}, {"uniform2", uniform(2, 70, 4)},
                  {"uniform3", uniform(3, 70, 5)},      {"uniform8", uniform(8, 50, 6)}};
    for (const auto& [name, cloud] : clouds) {
        cases.push_back({name + "_euclidean", cloud, by(Metric::Euclidean), euclidean_table(cloud), root});
        cases.push_back({name + "_l1", cloud, by(Metric::L1), sum_table(cloud), itself});
        cases.push_back({name + "_linf", cloud, by(Metric::LInf), maximum_table(cloud), itself});
        const PointCloud matrix = with_matrix(euclidean_table(cloud), true);
        cases.push_back({name + "_matrix", matrix, by(Metric::Matrix), euclidean_table(cloud), root});
        for (const std::uint32_t k : {6u, 9u}) {
            MetricOptions options = by(Metric::Geodesic);
            options.neighbors = k;
            cases.push_back({name + "_geodesic" + std::to_string(k), cloud, options,
                             path_table(cloud, static_cast<int>(k)), itself});
        }
        if (name.substr(0, 4) != "grid") continue;
        cases.push_back({name + "_angular", cloud, by(Metric::Angular), angle_ranks(cloud, false), nullptr});
        cases.push_back({name + "_projective", cloud, by(Metric::Projective), angle_ranks(cloud, true), nullptr});
    }
    const PointCloud torus = integers(2, 60, 0, 7, 7);
    cases.push_back({"grid_periodic", torus, by(Metric::Periodic, {8, 8}), periodic_table(torus, {8, 8}), root});
    cases.push_back({"grid_half_periodic", torus, by(Metric::Periodic, {0, 8}), periodic_table(torus, {0, 8}), root});
    PointCloud unit = uniform(3, 60, 8);
    cases.push_back({"unit_periodic", unit, by(Metric::Periodic), periodic_table(unit, {1, 1, 1}), root});
    return cases;
}

std::unique_ptr<LandmarkLists> lists_for(const PointCloud& cloud, const MetricOptions& options, std::uint32_t kappa) {
    if (options.metric == Metric::Euclidean) return std::make_unique<LandmarkLists>(cloud, kappa);
    return std::make_unique<LandmarkLists>(make_distance_rows(cloud, options), cloud.size(), kappa);
}

class MetricReference : public testing::TestWithParam<MetricCase> {};

TEST_P(MetricReference, HoldsTheNearestLandmarksAtEveryStep) {
    const MetricCase& one = GetParam();
    const auto n = static_cast<std::uint32_t>(one.table.size());
    ASSERT_FALSE(check_metric(one.cloud, one.options)) << check_metric(one.cloud, one.options)->message;
    for (const int first : {0, static_cast<int>(n) - 1}) {
        const TableOrder order = farthest_order(one.table, first);
        for (const std::uint32_t kappa : {1u, 3u, 5u}) {
            const auto lists = lists_for(one.cloud, one.options, kappa);
            while (!lists->prepare(Deadline(0))) {
            }
            ASSERT_FALSE(lists->failure()) << lists->failure()->message;
            for (std::size_t i = 0; i < order.landmarks.size(); ++i) {
                const auto step = static_cast<std::uint32_t>(i + 1);
                SCOPED_TRACE("kappa " + std::to_string(kappa) + ", step " + std::to_string(step));
                const auto expected = lists_of(one.table, order, static_cast<int>(step));
                const auto entries = lists->insert(static_cast<std::uint32_t>(order.landmarks[i]), step);
                std::vector<bool> entered(n);
                for (const ListEntry& entry : entries) {
                    ASSERT_EQ(lists->list(entry.witness)[entry.rank], step);
                    entered[entry.witness] = true;
                }
                for (std::uint32_t w = 0; w < n; ++w) {
                    std::vector<int> nearest = expected[lists->input_index(w)];
                    nearest.resize(kappa);
                    const auto list = lists->list(w);
                    ASSERT_EQ(std::vector<int>(list.begin(), list.end()), nearest) << "witness " << w;
                    ASSERT_EQ(entered[w], std::find(list.begin(), list.end(), step) != list.end());
                }
                if (i + 1 < order.landmarks.size()) {
                    ASSERT_EQ(lists->farthest(), static_cast<std::uint32_t>(order.landmarks[i + 1]));
                }
                const double epsilon = lists->distance(lists->farthest_comparable());
                ASSERT_EQ(epsilon > 0, order.epsilon[i] > 0);
                if (one.distance) {
                    ASSERT_EQ(epsilon, one.distance(order.epsilon[i]));
                }
            }
        }
    }
}

TEST_P(MetricReference, NearestOtherIsTheLeastOfTheRow) {
    const MetricCase& one = GetParam();
    const auto lists = lists_for(one.cloud, one.options, 2);
    ASSERT_TRUE(lists->prepare(kNoDeadline));
    for (std::uint32_t w = 0; w < lists->size(); ++w) {
        std::vector<double> row = one.table[lists->input_index(w)];
        row.erase(row.begin() + lists->input_index(w));
        const double nearest = lists->distance(lists->nearest_other_comparable(w));
        if (one.distance) {
            ASSERT_EQ(nearest, one.distance(*std::min_element(row.begin(), row.end())));
        }
        ASSERT_EQ(nearest == 0, *std::min_element(row.begin(), row.end()) == 0);
    }
}

TEST_P(MetricReference, RunsAgreeAtEveryStep) {
    const MetricCase& one = GetParam();
    const TableOrder order = farthest_order(one.table, 0);
    RunOptions options;
    options.metric = one.options;
    options.family = Family::Witness;
    options.max_dimension = 2;
    options.nu = {1, 3, 4, 4};
    options.max_steps = 40;
    for (const std::uint32_t prime : {2u, 3u}) {
        options.field = prime;
        auto opened = Session::open(one.cloud, options);
        ASSERT_TRUE(opened) << opened.error().message;
        Session session = std::move(opened).value();
        while (session.progress().state < RunState::Finished) session.run({.milliseconds = 0});
        ASSERT_EQ(session.progress().state, RunState::Finished);
        const Timeline& timeline = session.timeline();
        ASSERT_EQ(timeline.step_count, std::min<std::size_t>(order.landmarks.size(), 40));
        ASSERT_EQ(timeline.dimension, 3u);
        EXPECT_EQ(timeline_is_valid(timeline), "");
        for (Step step = 1; step <= timeline.step_count; ++step) {
            const auto lists = lists_of(one.table, order, static_cast<int>(step));
            const Complex complex = witness_complex(lists, {1, 3, 4, 4}, 3);
            for (int k = 1; k <= 3; ++k) {
                std::set<Simplex> living;
                for (const SimplexIndex s : timeline.living(k, 0, step)) {
                    const auto tuple = timeline.table(k).tuple(s);
                    living.insert(Simplex(tuple.begin(), tuple.end()));
                }
                ASSERT_EQ(living, complex[static_cast<std::size_t>(k)]) << "step " << step;
            }
            if (step % 5 != 0) continue;
            const auto betti = timeline.betti_at(step);
            ASSERT_EQ(std::vector<int>(betti.begin(), betti.end()), betti_numbers(complex, 3, static_cast<int>(prime)))
                << "step " << step;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Metrics, MetricReference, testing::ValuesIn(metric_cases()),
                         [](const auto& instance) { return instance.param.name; });

TEST(Metrics, AnglesAreThoseOfTheLibrary) {
    for (const bool lines : {false, true}) {
        const Metric metric = lines ? Metric::Projective : Metric::Angular;
        for (PointCloud cloud : {uniform(2, 40, 11), uniform(3, 40, 12), uniform(60, 20, 13)}) {
            for (double& coordinate : cloud.coordinates) coordinate = (coordinate - 0.5) * 1e140;
            for (std::uint32_t axis = 0; axis < cloud.dimension; ++axis) {
                cloud.coordinates.push_back(-cloud.coordinates[axis] * 1e-280);  // opposite to the first point
            }
            const auto rows = make_distance_rows(cloud, by(metric));
            const Table table = angle_table(cloud, lines);
            std::vector<double> row(cloud.size());
            for (std::uint32_t w = 0; w < cloud.size(); ++w) {
                rows->fill(w, {}, row);
                EXPECT_EQ(row[w], 0);
                // By squared cosines nothing below 1e-8 can be told from 0, nor that much around a right angle.
                for (std::uint32_t v = 0; v < cloud.size(); ++v) EXPECT_NEAR(rows->distance(row[v]), table[w][v], 3e-8);
            }
        }
    }
}

TEST(Metrics, ScanAndTreeGiveTheSameListsAndTheSameHash) {
    for (const std::uint32_t dimension : {2u, 3u, 4u, 7u}) {
        const PointCloud cloud = uniform(dimension, 150, 20 + dimension);
        LandmarkLists tree(cloud, 4);
        LandmarkLists scan(make_coordinate_rows(cloud, by(Metric::Euclidean)), cloud.size(), 4);
        ASSERT_TRUE(tree.prepare(kNoDeadline));
        ASSERT_TRUE(scan.prepare(kNoDeadline));
        std::uint32_t next = 3;
        for (std::uint32_t step = 1; step <= cloud.size(); ++step) {
            ASSERT_EQ(tree.insert(next, step).size(), scan.insert(next, step).size());
            for (std::uint32_t point = 0; point < cloud.size(); ++point) {
                const auto a = tree.comparable_distances(tree.witness(point));
                const auto b = scan.comparable_distances(point);
                ASSERT_TRUE(std::equal(a.begin(), a.end(), b.begin())) << dimension;
                ASSERT_TRUE(std::equal(a.begin(), a.end(), b.begin()));
                const auto steps = tree.list(tree.witness(point));
                ASSERT_TRUE(std::equal(steps.begin(), steps.end(), scan.list(point).begin()));
            }
            next = tree.farthest();
            ASSERT_EQ(scan.farthest(), next);
            ASSERT_EQ(scan.farthest_comparable(), tree.farthest_comparable());
        }
        // A box so large that nothing is nearer around it: the same distances, but by rows.
        RunOptions by_tree;
        by_tree.family = Family::Witness;
        by_tree.max_dimension = std::min(dimension - 1, 3u);
        RunOptions by_scan = by_tree;
        by_scan.metric = by(Metric::Periodic, {64});
        std::vector<std::uint64_t> hashes;
        for (const RunOptions& options : {by_tree, by_scan}) {
            Session session = Session::open(cloud, options).value();
            session.run({});
            EXPECT_EQ(session.timeline().step_count, 150u);
            hashes.push_back(session.hash());
        }
        EXPECT_EQ(hashes[0], hashes[1]) << dimension;
    }
}

TEST(Metrics, MatrixAndCoordinatesAgree) {
    for (const std::uint32_t dimension : {2u, 3u, 4u}) {
        for (const bool is_integer : {true, false}) {
            const PointCloud cloud = is_integer ? integers(dimension, 90, 0, 12, 31) : uniform(dimension, 90, 32);
            const PointCloud matrix = with_matrix(euclidean_table(cloud), true);
            RunOptions options;
            options.family = Family::Witness;
            options.max_dimension = 2;
            Session by_points = Session::open(cloud, options).value();
            options.metric.metric = Metric::Matrix;
            Session by_matrix = Session::open(matrix, options).value();
            by_points.run({});
            by_matrix.run({});
            if (is_integer) {
                EXPECT_EQ(by_points.hash(), by_matrix.hash()) << dimension;
            }
            EXPECT_EQ(by_points.timeline().betti, by_matrix.timeline().betti) << dimension;
            EXPECT_GT(by_points.timeline().step_count, 60u);
        }
    }
}

TEST(Metrics, SinglePrecisionIsTakenAsItIs) {
    const PointCloud cloud = integers(2, 60, 0, 5, 40);
    PointCloud wide = with_matrix(sum_table(cloud), false);
    PointCloud narrow = wide;
    for (const double entry : wide.distances.entries) narrow.distances.narrow.push_back(static_cast<float>(entry));
    narrow.distances.entries = {};
    RunOptions options;
    options.metric.metric = Metric::Matrix;
    Session a = Session::open(wide, options).value();
    Session b = Session::open(narrow, options).value();
    a.run({});
    b.run({});
    EXPECT_EQ(a.hash(), b.hash());
}

}  // namespace
}  // namespace plateau
