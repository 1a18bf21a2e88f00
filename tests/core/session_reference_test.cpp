// The engine against the slow references: every cloud, every family, several nu, at every step.

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "clouds.h"
#include "comparison.h"
#include "session/session.h"

namespace plateau {
namespace {

using reference::Reference;
using reference::Settings;
using reference::ShownFamily;

class SessionReference : public testing::TestWithParam<FamilyCase> {};

TEST_P(SessionReference, AgreesAtEveryStep) {
    const auto& [cloud, family] = GetParam();
    Reference expected(cloud.cloud, 0, cloud.max_steps);
    const int dimension = static_cast<int>(cloud.cloud.dimension);
    std::set<std::vector<int>> sequences = {reference::default_nu(family, dimension)};
    for (std::vector<int> nu : {std::vector{1, 2, 3, 4}, {1, 6, 6, 4}, {1, 3, 4, 5}, {1, 4, 2, 3}}) {
        nu.resize(static_cast<std::size_t>(dimension) + 1);
        sequences.insert(nu);
    }
    for (const std::vector<int>& nu : sequences) {
        EXPECT_EQ(run_difference(cloud.cloud, expected, {family, nu}, 0, cloud.max_steps), "")
            << cloud.name << ", " << name_of(family) << ", nu " << joined(nu);
    }
}

INSTANTIATE_TEST_SUITE_P(Clouds, SessionReference, testing::ValuesIn(family_cases()),
                         [](const auto& instance) { return name_of(instance.param); });

TEST(SessionReferenceOptions, DefaultsAreThoseOfTheFamilies) {
    for (const char* name : {"plane_uniform", "torus"}) {
        const PointCloud cloud = test_cloud(name).cloud;
        for (const auto family :
             {ShownFamily::Witness, ShownFamily::Delaunay, ShownFamily::Surface, ShownFamily::Auto}) {
            if (cloud.dimension == 2 && family != ShownFamily::Witness && family != ShownFamily::Delaunay) continue;
            const std::vector<int> nu = reference::default_nu(family, static_cast<int>(cloud.dimension));
            RunOptions options;
            options.family = family_of(family);
            auto opened = Session::open(cloud, options);
            ASSERT_TRUE(opened) << opened.error().message;
            const auto& filled_in = opened.value().options().nu;
            EXPECT_EQ(std::vector<int>(filled_in.begin(), filled_in.end()), nu) << name << " " << name_of(family);
        }
    }
}

TEST(SessionReferenceOptions, OtherFirstLandmarks) {
    for (const char* name : {"plane_lattice", "grid", "rising_twice", "torus", "duplicates"}) {
        const PointCloud cloud = test_cloud(name).cloud;
        const int last = static_cast<int>(cloud.size()) - 1;
        for (const int first : {1, last / 2, last}) {
            Reference expected(cloud, first);
            const ShownFamily family = cloud.dimension == 2 ? ShownFamily::Delaunay : ShownFamily::Auto;
            const Settings settings{family, reference::default_nu(family, static_cast<int>(cloud.dimension))};
            EXPECT_EQ(run_difference(cloud, expected, settings, first), "") << name << ", first " << first;
        }
    }
}

// On the grids there are triangles of exactly these ratios, or of ratios that differ from them by less than rounding.
TEST(SessionReferenceOptions, RadiusEdgeRatios) {
    for (const char* name : {"sphere", "torus", "grid", "grid_tenth", "lattice", "icosahedron"}) {
        const PointCloud cloud = test_cloud(name).cloud;
        Reference expected(cloud);
        for (const double rho : {0.57735026918962573, 0.6, 0.70710678118654757, 0.75, 1.0, 1.038, 2.0}) {
            const Settings settings{ShownFamily::Surface, {1, 6, 6, 4}, rho};
            EXPECT_EQ(run_difference(cloud, expected, settings), "") << name << ", rho " << rho;
        }
    }
}

TEST(SessionReferenceOptions, OtherFields) {
    for (const char* name : {"plane_lattice", "grid_tenth", "torus", "cospherical_9"}) {
        const PointCloud cloud = test_cloud(name).cloud;
        Reference expected(cloud);
        std::vector<int> nu = {1, 3, 4, 4};
        nu.resize(cloud.dimension + 1);
        EXPECT_EQ(run_difference(cloud, expected, {ShownFamily::Witness, nu, 0, 3}), "") << name;
    }
}

TEST(SessionReferenceOptions, StopsWhereAsked) {
    const PointCloud cloud = test_cloud("torus").cloud;
    const Reference expected(cloud);
    RunOptions options;
    options.max_steps = 17;
    Session by_steps = Session::open(cloud, options).value();
    EXPECT_EQ(by_steps.run({}).state, RunState::Finished);
    EXPECT_EQ(by_steps.timeline().step_count, 17u);
    options = {};
    options.until_epsilon = std::sqrt(expected.order().epsilon_squared[20]);
    Session by_epsilon = Session::open(cloud, options).value();
    EXPECT_EQ(by_epsilon.run({}).state, RunState::Finished);
    EXPECT_EQ(by_epsilon.timeline().step_count, 21u);
}

TEST(SessionReferenceBudget, HashDoesNotDependOnIt) {
    for (const TestCloud& cloud : test_clouds()) {
        for (const Family family : {Family::Witness, Family::Delaunay, Family::Auto}) {
            if (cloud.cloud.dimension == 2 && family == Family::Auto) continue;
            RunOptions options;
            options.family = family;
            options.max_steps = static_cast<std::uint32_t>(cloud.max_steps);
            std::vector<std::uint64_t> hashes;
            for (const Budget budget : {Budget{}, Budget{.steps = 1}, Budget{.milliseconds = 1}, Budget{.steps = 7}}) {
                Session session = Session::open(cloud.cloud, options).value();
                while (session.progress().state != RunState::Finished) session.run(budget);
                hashes.push_back(session.hash());
            }
            for (const std::uint64_t hash : hashes) EXPECT_EQ(hash, hashes[0]) << cloud.name;
        }
    }
}

}  // namespace
}  // namespace plateau
