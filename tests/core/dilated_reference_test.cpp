// Family dilated against its definition, at every step.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include "base/random.h"
#include "cloud/samples.h"
#include "clouds.h"
#include "comparison.h"
#include "laws.h"
#include "reference/dilated.h"
#include "reference/elimination.h"
#include "reference/witness.h"
#include "session/session.h"

namespace plateau {
namespace {

using reference::Complex;
using reference::Simplex;

PointCloud uniform(std::uint32_t dimension, std::uint32_t size, std::uint64_t seed) {
    Random random(seed);
    PointCloud cloud{dimension, {}};
    for (std::uint32_t i = 0; i < dimension * size; ++i) cloud.coordinates.push_back(random.next_unit());
    return cloud;
}

/// Points of a grid, the first `size` of them, `twice`: each two times.
PointCloud grid(std::uint32_t dimension, std::uint32_t side, std::uint32_t size, double spacing) {
    PointCloud cloud{dimension, {}};
    for (std::uint32_t i = 0; i < size; ++i) {
        std::uint32_t rest = i;
        for (std::uint32_t axis = 0; axis < dimension; ++axis) {
            cloud.coordinates.push_back(spacing * (rest % side));
            rest /= side;
        }
    }
    return cloud;
}

/// The points with one coordinate of +-2 and others 0, or all of +-1: in R^4 the 24-cell, all at a distance of 2.
PointCloud cospherical(std::uint32_t dimension) {
    PointCloud cloud{dimension, {}};
    for (std::uint32_t bits = 0; bits < 1u << dimension; ++bits) {
        for (std::uint32_t axis = 0; axis < dimension; ++axis) cloud.coordinates.push_back(bits >> axis & 1 ? 1 : -1);
    }
    for (std::uint32_t place = 0; place < dimension * dimension * 2; ++place) {
        const bool is_axis = place / 2 / dimension == place / 2 % dimension;
        cloud.coordinates.push_back(is_axis ? (place < dimension * dimension ? 2 : -2) : 0);
    }
    return cloud;
}

PointCloud scaled(PointCloud cloud, double factor, double offset) {
    for (double& x : cloud.coordinates) x = x * factor + offset;
    return cloud;
}

PointCloud repeated(PointCloud cloud) {
    const auto once = cloud.coordinates;
    cloud.coordinates.insert(cloud.coordinates.end(), once.begin(), once.end());
    return cloud;
}

PointCloud joined_clouds(PointCloud cloud, const PointCloud& other) {
    cloud.coordinates.insert(cloud.coordinates.end(), other.coordinates.begin(), other.coordinates.end());
    return cloud;
}

struct Case {
    std::string name;
    PointCloud cloud;
    std::uint32_t max_steps = 1000000;
    bool has_ties = true;  ///< else what breaks ties must not matter, and the reference does without it
};

/// Squared distance of a point to the nearest one elsewhere; infinity where there is none.
double spacing_squared(const PointCloud& cloud, std::uint32_t index) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::uint32_t other = 0; other < cloud.size(); ++other) {
        const double squared = distance_squared(cloud.point(index), cloud.point(other));
        if (squared > 0) nearest = std::min(nearest, squared);
    }
    return nearest;
}

std::ostream& operator<<(std::ostream& out, const Case& value) {
    return out << value.name;
}

std::vector<Case> cases() {
    const bool full = std::getenv("PLATEAU_FULL") != nullptr;
    std::vector<Case> result = {
        {"uniform_2", uniform(2, 60, 1)},
        {"uniform_3", uniform(3, 50, 2)},
        {"uniform_4", uniform(4, 35, 3), 30},
        {"uniform_5", uniform(5, 24, 4), 20},
        {"torus", sample_shape("torus", {.size = 150}).value(), 36},
        {"grid_2", grid(2, 7, 49, 1)},
        {"grid_3", grid(3, 3, 27, 0.1)},
        {"grid_4", grid(4, 2, 16, 1)},
        {"cospherical_3", cospherical(3)},
        {"cospherical_4", cospherical(4)},
        {"duplicates", repeated(uniform(3, 20, 5))},
        {"grid_of_duplicates", repeated(grid(2, 5, 25, 0.3))},
        {"tiny", scaled(uniform(3, 40, 6), 1e-9, 0)},
        {"huge", scaled(uniform(3, 40, 7), 1e9, 0)},
        {"tiny_grid", grid(3, 4, 30, 1e-9)},
        {"huge_grid", grid(2, 6, 36, 1e9)},
        {"far_away", scaled(uniform(3, 40, 8), 1, 4096)},
        {"line_in_space", scaled(grid(3, 20, 20, 0.1), 1, 0)},
        {"one_point", uniform(4, 1, 9)},
        // What breaks ties for the first landmarks, which are far apart, must be small beside the spacing of the last.
        {"outlier", joined_clouds(uniform(3, 40, 14), {3, {1e6, 0, 0}}), 41, false},
        {"two_clusters", joined_clouds(uniform(2, 30, 15), scaled(uniform(2, 30, 16), 1, 1e6)), 60, false},
    };
    for (TestCloud& cloud : test_clouds()) {
        const auto size = cloud.cloud.size();
        if (!full && size > 40) continue;
        result.push_back({"known_" + cloud.name, std::move(cloud.cloud), full ? 60u : 40u});
    }
    if (!full) return result;
    // The reference looks at every witness for every candidate, so that a step costs the square of the landmarks and
    // more; the bounds keep each of these below some two minutes.
    result.push_back({"large_uniform_2", uniform(2, 300, 11), 90});
    result.push_back({"large_uniform_3", uniform(3, 300, 12), 60});
    result.push_back({"large_uniform_4", uniform(4, 300, 13), 36});
    result.push_back({"large_grid_3", grid(3, 6, 216, 1), 60});
    result.push_back({"large_grid_4", grid(4, 3, 81, 1), 40});
    result.push_back({"large_tiny", scaled(uniform(3, 150, 17), 1e-9, 0), 60});
    result.push_back({"large_huge", scaled(uniform(3, 150, 18), 1e9, 0), 60});
    result.push_back({"large_tiny_grid", grid(3, 5, 125, 1e-9), 60});
    result.push_back({"large_huge_grid", grid(3, 5, 125, 1e9), 60});
    return result;
}

Complex complex_at(const Timeline& timeline, Step step) {
    Complex complex;
    for (Step landmark = 1; landmark <= step; ++landmark) complex[0].insert({static_cast<int>(landmark)});
    for (const HiddenLandmark& hidden : timeline.hidden) {
        if (hidden.from <= step) complex[0].erase({static_cast<int>(hidden.landmark)});
    }
    for (const SimplexTable& table : timeline.simplices) {
        for (const SimplexIndex simplex : timeline.living(table.dimension, 0, step)) {
            const auto tuple = table.tuple(simplex);
            complex[static_cast<std::size_t>(table.dimension)].insert(Simplex(tuple.begin(), tuple.end()));
        }
    }
    return complex;
}

std::string differing(const Complex& expected, const Complex& found) {
    for (std::size_t k = 0; k < expected.size(); ++k) {
        for (const Simplex& simplex : expected[k]) {
            if (found[k].count(simplex) == 0) return "lacks " + joined(simplex);
        }
        for (const Simplex& simplex : found[k]) {
            if (expected[k].count(simplex) == 0) return "has " + joined(simplex);
        }
    }
    return "";
}

class DilatedReference : public testing::TestWithParam<Case> {};

TEST_P(DilatedReference, EqualsTheDefinitionAtEveryStep) {
    const auto& [name, cloud, max_steps, has_ties] = GetParam();
    const auto order = reference::farthest_point_order(cloud, 0, static_cast<int>(max_steps));
    int in_doubt = 0;
    int steps = 0;
    for (const auto& [dilation, pumps] : {std::pair{0.2, false}, {0.6, false}, {0.3, true}}) {
        RunOptions options;
        options.dilated.pumps = pumps;
        options.dilated.pump.omega_bar = 0.5;  // so large that landmarks are hidden later
        options.family = Family::Dilated;
        options.dilated.dilation = dilation;
        options.max_steps = max_steps;
        options.field = dilation == 0.2 ? 2 : 3;
        auto opened = Session::open(cloud, options);
        ASSERT_TRUE(opened) << opened.error().message;
        Session session = std::move(opened).value();
        session.run({});
        const Timeline& timeline = session.timeline();
        ASSERT_EQ(timeline_is_valid(timeline), "");
        ASSERT_EQ(timeline.step_count, order.landmarks.size());
        std::vector<double> weights = timeline.weights_squared;
        for (Step step = 1; step <= timeline.step_count; ++step) {
            // Without pumping only what breaks ties.
            const double chosen = pumps ? timeline.pumps[step - 1].weight_squared : 0;
            const double rest = weights[step - 1] - chosen;
            const double rounding = 1e-15 * chosen;
            ASSERT_LE(rest, 0x1p-36 * timeline.epsilon(step) * timeline.epsilon(step) + rounding);
            ASSERT_LE(rest, 0x1p-18 * spacing_squared(cloud, timeline.landmarks[step - 1]) + rounding);
            if (!has_ties) weights[step - 1] = chosen;
        }
        for (Step step = 1; step <= timeline.step_count; ++step) {
            ASSERT_EQ(static_cast<int>(timeline.landmarks[step - 1]), order.landmarks[step - 1]);
            const double epsilon = timeline.epsilon(step);
            const auto count = static_cast<std::ptrdiff_t>(step);
            const auto state = reference::dilated_complex(
                cloud, {{order.landmarks.begin(), order.landmarks.begin() + count},
                        {weights.begin(), weights.begin() + count},
                        dilation * epsilon,
                        (has_ties ? 1e-9 : 1e-5) * (epsilon > 0 ? epsilon : timeline.epsilon(1))});
            ++steps;
            if (state.in_doubt) {
                // At epsilon = 0 ties are decided by weights whose effect is as small as rounding.
                if (epsilon > 0) ++in_doubt;
                continue;
            }
            ASSERT_EQ(differing(state.complex, complex_at(timeline, step)), "")
                << "step " << step << ", dilation " << dilation << (pumps ? ", pumped" : "");
            ASSERT_TRUE(state.complex[cloud.dimension + 1].empty());
            const auto betti = reference::betti_numbers(state.complex, static_cast<int>(cloud.dimension),
                                                        static_cast<int>(options.field));
            const auto found = timeline.betti_at(step);
            ASSERT_EQ(std::vector<int>(found.begin(), found.end()), betti) << "step " << step;
        }
    }
    EXPECT_LE(in_doubt, 2 + steps / 10) << "of " << steps;
}

INSTANTIATE_TEST_SUITE_P(Clouds, DilatedReference, testing::ValuesIn(cases()),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace plateau
