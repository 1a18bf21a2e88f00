// The same questions where there is no D(L): other metrics, and family dilated; what is refused; the words.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <utility>

#include "base/random.h"
#include "cloud/samples.h"
#include "clouds.h"
#include "comparison.h"
#include "inspection_comparison.h"
#include "io/inspection_text.h"
#include "reference/dilated.h"
#include "reference/metrics.h"
#include "reference/witness.h"
#include "session/session.h"

namespace plateau {
namespace {

using reference::Simplex;
using reference::Table;

int below(Random& random, std::size_t bound) {
    return static_cast<int>(random.next_bits() % bound);
}

PointCloud integers(std::uint32_t dimension, std::uint32_t size, std::uint64_t seed) {
    Random random(seed);
    PointCloud cloud{dimension, {}};
    for (std::uint32_t i = 0; i < dimension * size; ++i) cloud.coordinates.push_back(1 + below(random, 9));
    return cloud;
}

Simplex some_of(Random& random, const std::vector<int>& list, int size, std::size_t reach) {
    std::set<int> chosen;
    for (int tries = 0; tries < 40 && static_cast<int>(chosen.size()) < size; ++tries) {
        chosen.insert(list[static_cast<std::size_t>(below(random, std::min(reach, list.size())))]);
    }
    return {chosen.begin(), chosen.end()};
}

std::vector<Step> as_steps(const Simplex& simplex) {
    return {simplex.begin(), simplex.end()};
}

Session finished(const PointCloud& cloud, const RunOptions& options) {
    auto opened = Session::open(cloud, options);
    if (!opened) throw std::runtime_error(opened.error().message);
    Session session = std::move(opened).value();
    session.run({});
    return session;
}

struct MetricCase {
    const char* name;
    MetricOptions options;
    std::function<Table(const PointCloud&)> table;
};

std::vector<MetricCase> metrics() {
    using namespace reference;
    return {
        {"l1", {Metric::L1, 8, {}}, sum_table},
        {"linf", {Metric::LInf, 8, {}}, maximum_table},
        {"angular", {Metric::Angular, 8, {}}, [](const PointCloud& cloud) { return angle_ranks(cloud, false); }},
        {"periodic",
         {Metric::Periodic, 8, {11}},
         [](const PointCloud& cloud) { return periodic_table(cloud, std::vector<double>(cloud.dimension, 11)); }},
        {"geodesic", {Metric::Geodesic, 7, {}}, [](const PointCloud& cloud) { return path_table(cloud, 7); }},
        {"euclidean", {Metric::Euclidean, 8, {}}, euclidean_table},
    };
}

// More landmarks than lists are looked at, so that some misses are beyond the horizon.
TEST(InspectionMetrics, AnswersByTheDefinition) {
    int beyond = 0;
    for (const MetricCase& metric : metrics()) {
        for (const std::uint32_t dimension : {2u, 5u}) {
            const PointCloud cloud = integers(dimension, dimension == 2 ? 70 : 150, dimension);
            const Table table = metric.table(cloud);
            const auto order = reference::farthest_order(table, 0);
            const std::vector<int> nu = {1, 3, 4, 4};
            RunOptions options;
            options.metric = metric.options;
            options.family = Family::Witness;
            options.max_dimension = 2;
            options.nu.assign(nu.begin(), nu.end());
            const Session session = finished(cloud, options);
            Random random(dimension);
            for (int i = 0; i < 30; ++i) {
                const auto last = order.landmarks.size();
                const int step = i % 3 == 0 ? static_cast<int>(last) : 1 + below(random, last);
                const auto lists = reference::lists_of(table, order, step);
                const DefinedComplex expected{lists, reference::witness_complex(lists, nu, 3), nu, 3, step, {}, {}};
                const std::size_t reach = i % 5 == 0 ? 1000 : 6;
                const auto& list = lists[static_cast<std::size_t>(below(random, lists.size()))];
                const Simplex asked = some_of(random, list, 1 + below(random, 5), reach);
                const auto found = session.inspect(static_cast<Step>(step), as_steps(asked));
                ASSERT_TRUE(found) << found.error().message;
                ASSERT_EQ(inspection_difference(expected, asked, found.value()), "")
                    << metric.name << ", step " << step << ", " << joined(asked);
                if (found.value().verdict == Verdict::NotWitnessed && !found.value().sightings.best) ++beyond;
            }
        }
    }
    EXPECT_GT(beyond, 0);
}

TEST(InspectionMetrics, MatricesHaveNoCoordinates) {
    const PointCloud points = integers(2, 60, 3);
    const Table squared = reference::euclidean_table(points);
    PointCloud cloud;
    cloud.distances.size = points.size();
    for (std::size_t a = 0; a < squared.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b) cloud.distances.entries.push_back(std::sqrt(squared[a][b]));
    }
    RunOptions options;
    options.metric.metric = Metric::Matrix;
    const Session session = finished(cloud, options);
    const auto order = reference::farthest_order(squared, 0);
    const int last = static_cast<int>(order.landmarks.size());
    const auto lists = reference::lists_of(squared, order, last);
    const std::vector<int> nu = {1, 2, 3, 4};
    const DefinedComplex expected{lists, reference::witness_complex(lists, nu, 3), nu, 3, last, {}, {}};
    Random random(5);
    for (int i = 0; i < 40; ++i) {
        const Simplex asked = some_of(random, lists[static_cast<std::size_t>(i)], 1 + below(random, 4), 5);
        const auto found = session.inspect(static_cast<Step>(last), as_steps(asked));
        ASSERT_TRUE(found) << found.error().message;
        ASSERT_EQ(inspection_difference(expected, asked, found.value()), "") << joined(asked);
    }
}

// Distances by another method: a simplex whose distance is that near to zeta is in doubt, and not asked about.
TEST(InspectionDilated, AnswersByTheDefinition) {
    int asked_in_all = 0;
    std::set<Verdict> met;
    for (const auto& [name, pumps] :
         {std::pair{"plane_uniform", false}, {"torus", false}, {"sphere", true}, {"grid", false}}) {
        const PointCloud cloud = test_cloud(name).cloud;
        RunOptions options;
        options.family = Family::Dilated;
        options.dilated.dilation = 0.3;
        options.dilated.pumps = pumps;
        options.dilated.pump.omega_bar = 0.5;
        options.max_steps = 30;
        const Session session = finished(cloud, options);
        const Timeline& timeline = session.timeline();
        const int dimension = static_cast<int>(cloud.dimension);
        Random random(11);
        for (Step step = 3; step <= timeline.step_count; step += 9) {
            const auto count = static_cast<std::ptrdiff_t>(step);
            const double zeta = options.dilated.dilation * timeline.epsilon(step);
            const double doubt = 1e-9 * timeline.epsilon(step);
            const reference::DilatedSettings settings{
                {timeline.landmarks.begin(), timeline.landmarks.begin() + count},
                {timeline.weights_squared.begin(), timeline.weights_squared.begin() + count},
                zeta,
                doubt};
            const auto state = reference::dilated_complex(cloud, settings);
            if (state.in_doubt) continue;
            DefinedComplex expected;
            expected.complex = state.complex;
            const reference::FarthestOrder order{settings.landmarks, {}};
            const auto lists = reference::landmark_lists(cloud, order, static_cast<int>(step));
            for (int i = 0; i < 12; ++i) {
                const auto& list = lists[static_cast<std::size_t>(below(random, lists.size()))];
                const Simplex asked =
                    some_of(random, list, 1 + below(random, static_cast<std::size_t>(dimension) + 2), 5);
                const auto answer = session.inspect(step, as_steps(asked));
                ASSERT_TRUE(answer) << answer.error().message;
                const Inspection& found = answer.value();
                SCOPED_TRACE(std::string(name) + ", step " + std::to_string(step) + ", " + joined(asked));
                Simplex missing;
                for (int size = 1; size <= static_cast<int>(asked.size()) && missing.empty(); ++size) {
                    auto faces = reference::subsets(asked, size);
                    std::sort(faces.begin(), faces.end());
                    for (const Simplex& face : faces) {
                        const auto k = static_cast<std::size_t>(size - 1);
                        if (missing.empty() && state.complex[k].count(face) == 0) missing = face;
                    }
                }
                const Simplex about = missing.empty() ? asked : missing;
                ASSERT_EQ(Simplex(found.about.begin(), found.about.end()), about);
                met.insert(found.verdict);
                if (static_cast<int>(about.size()) > dimension + 1) {
                    ASSERT_EQ(found.verdict, Verdict::TooManyVertices);
                    continue;
                }
                ASSERT_EQ(found.verdict, missing.empty() ? Verdict::Present : Verdict::NotWitnessed);
                ASSERT_TRUE(found.is_dilated);
                ASSERT_EQ(found.zeta, zeta);
                const double limit = 10 * timeline.epsilon(1);
                const auto distances = reference::distances_to_cell(cloud, settings, about, limit);
                const auto nearest = std::min_element(distances.begin(), distances.end());
                ASSERT_EQ(found.sightings.best.has_value(), *nearest < limit);
                if (!found.sightings.best) continue;
                ASSERT_NEAR(found.sightings.best->distance, *nearest, 1e-6 * timeline.epsilon(step));
                ASSERT_NEAR(distances[found.sightings.best->witness], *nearest, 1e-6 * timeline.epsilon(step));
                const auto within = [&](double slack) {
                    return std::count_if(distances.begin(), distances.end(),
                                         [&](double distance) { return distance <= zeta + slack; });
                };
                ASSERT_LE(within(-doubt), found.sightings.witness_count);
                ASSERT_GE(within(doubt), found.sightings.witness_count);
                ++asked_in_all;
            }
        }
    }
    EXPECT_GT(asked_in_all, 60);
    EXPECT_EQ(met, (std::set{Verdict::Present, Verdict::NotWitnessed}));
}

TEST(InspectionDilated, TellsWhenALandmarkIsHidden) {
    int hidden_later = 0;
    for (const auto& [shape, size] : {std::pair{"helix", 200u}, {"swiss-roll", 300u}}) {
        RunOptions options;
        options.family = Family::Dilated;
        options.dilated.pumps = true;
        options.dilated.pump.omega_bar = 0.5;
        const Session session = finished(sample_shape(shape, {.size = size}).value(), options);
        for (const HiddenLandmark& hidden : session.timeline().hidden) {
            const Inspection after = session.inspect(hidden.from, {hidden.landmark}).value();
            EXPECT_EQ(after.verdict, Verdict::NotWitnessed);
            EXPECT_EQ(after.sightings.witness_count, 0u);
            if (hidden.from == hidden.landmark) continue;
            ++hidden_later;
            const Inspection before = session.inspect(hidden.from - 1, {hidden.landmark}).value();
            EXPECT_EQ(before.verdict, Verdict::Present);
            EXPECT_EQ(before.birth, hidden.landmark);
            EXPECT_EQ(before.death, hidden.from);
        }
    }
    EXPECT_GT(hidden_later, 0);
}

TEST(InspectionWords, NameTheReason) {
    const PointCloud square{2, {0, 0, 1, 0, 0, 1, 1, 1.125, 0.5, 0.75, 0.5, 0.03125, 0.9375, 0.5}};
    RunOptions options;
    options.max_steps = 4;
    const Session session = finished(square, options);
    const auto words = [&](Step step, std::vector<Step> vertices) {
        const auto found = session.inspect(step, std::move(vertices));
        return found ? inspection_text(found.value()) : found.error().message;
    };
    EXPECT_EQ(
        words(2, {1}),
        "Landmark 1 is in the complex at step 2. 4 witnesses have it as their nearest landmark, the best is point "
        "0. It is there from step 1 to the last step so far.");
    EXPECT_EQ(words(2, {4, 1, 3}),
              "The triangle of landmarks 1, 3 and 4 is not in the complex at step 2. Landmarks 3 and 4 come later.");
    EXPECT_EQ(words(5, {1}), "Step 5 is not computed: there are steps 1 to 4.");
    EXPECT_EQ(words(4, {}), "Name at least one landmark by the step that inserted it.");
    EXPECT_EQ(words(4, {2, 2}), "Landmark 2 is named twice.");
    EXPECT_EQ(words(4, {0}), "Landmarks are named by their steps, from 1 on; got 0.");
    EXPECT_EQ(words(4, {1, 2, 3, 4, 5, 6, 7, 8, 9}), "At most 8 landmarks can be asked about at once; got 9.");
    EXPECT_EQ(words(4, {1, 2, 3, 4}).substr(0, 66),
              "The tetrahedron of landmarks 1, 2, 3 and 4 is not in the complex a");
}

}  // namespace
}  // namespace plateau
