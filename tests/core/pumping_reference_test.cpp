// Pumping against the star of the new landmark, from the definition, at a grid of weights.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ostream>
#include <string>
#include <vector>

#include "base/random.h"
#include "cloud/samples.h"
#include "dilated/pumping.h"
#include "laws.h"
#include "reference/dilated.h"
#include "session/session.h"

namespace plateau {
namespace {

bool is_full_run() {
    return std::getenv("PLATEAU_FULL") != nullptr;
}

PointCloud uniform(std::uint32_t dimension, std::uint32_t size, std::uint64_t seed) {
    Random random(seed);
    PointCloud cloud{dimension, {}};
    for (std::uint32_t i = 0; i < dimension * size; ++i) cloud.coordinates.push_back(random.next_unit());
    return cloud;
}

struct Case {
    std::string name;
    PointCloud cloud;
    std::uint32_t steps;
    SliverMeasure measure = SliverMeasure::Literal;
    double omega_bar = 0.25;
    double dilation = 0.2;     ///< zeta_1 / epsilon
    std::uint32_t stride = 1;  ///< of the steps that are looked at, the last one and before
    int grid = 16;             ///< weights at each of them
};

std::ostream& operator<<(std::ostream& out, const Case& value) {
    return out << value.name;
}

std::vector<Case> cases() {
    using enum SliverMeasure;
    std::vector<Case> result = {
        {"plane", uniform(2, 40, 1), 30},
        {"space", uniform(3, 40, 2), 20},
        {"space_normalized", uniform(3, 40, 3), 20, Normalized},
        {"torus", sample_shape("torus", {.size = 80}).value(), 22},
        {"four_normalized", uniform(4, 24, 4), 14, Normalized},
        // Weights so large that landmarks are hidden in the complex of radius zeta_1 = 0, and not in that of zeta_2.
        {"hidden", uniform(2, 400, 102), 132, Literal, 0.5, 0, is_full_run() ? 4u : 33u, 4},
    };
    if (!is_full_run()) return result;
    for (const double omega_bar : {0.25, 0.5}) {
        const std::string name = omega_bar == 0.25 ? "fine_quarter_" : "fine_half_";
        result.push_back({name + "plane", uniform(2, 60, 5), 45, Literal, omega_bar, 0.2, 1, 256});
        result.push_back({name + "space", uniform(3, 40, 6), 22, Literal, omega_bar, 0.2, 1, 256});
        result.push_back({name + "space_normalized", uniform(3, 40, 7), 20, Normalized, omega_bar, 0, 1, 256});
        result.push_back({name + "four", uniform(4, 24, 8), 14, Literal, omega_bar, 0.2, 1, 64});
    }
    return result;
}

class PumpingReference : public testing::TestWithParam<Case> {};

TEST_P(PumpingReference, ChoosesTheSmallestBestWeight) {
    const auto& [name, cloud, steps, measure, omega_bar, dilation, stride, grid] = GetParam();
    RunOptions options;
    options.family = Family::Dilated;
    options.max_steps = steps;
    options.dilated.dilation = dilation;
    options.dilated.pumps = true;
    options.dilated.pump.measure = measure;
    options.dilated.pump.omega_bar = omega_bar;
    Session session = Session::open(cloud, options).value();
    session.run({});
    const Timeline& timeline = session.timeline();
    ASSERT_EQ(timeline_is_valid(timeline), "");
    ASSERT_EQ(timeline.pumps.size(), timeline.step_count);

    std::uint32_t pumped = 0;
    for (Step step = 2; step <= timeline.step_count; ++step) {
        const Pump& pump = timeline.pumps[step - 1];
        const double epsilon = timeline.epsilon(step);
        if (epsilon == 0 || (timeline.step_count - step) % stride != 0) continue;
        std::vector<int> landmarks(timeline.landmarks.begin(), timeline.landmarks.begin() + step);
        std::vector<double> weights(timeline.weights_squared.begin(), timeline.weights_squared.begin() + step);
        const double tie_breaking = weights.back() - pump.weight_squared;
        ASSERT_LE(tie_breaking, 0x1p-36 * epsilon * epsilon * (1 + 1e-3));
        // The smallest sliver measure in the star of p at a weight, and whether p is a vertex.
        const auto at_weight = [&](double weight_squared) {
            weights.back() = weight_squared + tie_breaking;
            const double zeta = options.dilated.pump.dilation * epsilon;
            const auto state = reference::dilated_complex_around_youngest(cloud, {landmarks, weights, zeta, 0});
            double smallest = 1;
            for (const auto& simplices : state.complex) {
                for (const auto& simplex : simplices) {
                    if (simplex.back() != static_cast<int>(step)) continue;
                    smallest = std::min(smallest, reference::sliver_measure(cloud, landmarks, simplex,
                                                                            measure == SliverMeasure::Normalized));
                }
            }
            return state.complex[0].count({static_cast<int>(step)}) > 0 ? smallest : 0;
        };
        double nearest = 1e300;
        for (Step other = 1; other < step; ++other) {
            nearest = std::min(nearest, distance_squared(cloud.point(timeline.landmarks[step - 1]),
                                                         cloud.point(timeline.landmarks[other - 1])));
        }
        const double largest = nearest * omega_bar * omega_bar;
        ASSERT_LE(pump.weight_squared, largest * (1 + 1e-12));
        EXPECT_NEAR(at_weight(0), pump.before, 1e-9) << name << ", step " << step;
        EXPECT_NEAR(at_weight(pump.weight_squared), pump.after, 1e-9) << name << ", step " << step;
        const double level = largest / Pumping::kLevels;
        if (pump.weight_squared > 0) {
            ++pumped;
            EXPECT_LT(at_weight(pump.weight_squared - level), pump.after - 1e-12) << name << ", step " << step;
        }
        for (int i = 1; i <= grid; ++i) {
            const double weight = largest * i / grid;
            const double found = at_weight(weight);
            EXPECT_LE(found, pump.after + 1e-9) << name << ", step " << step << ", grid " << i;
            if (weight < pump.weight_squared - level / 2) {
                EXPECT_LT(found, pump.after - 1e-12) << name << ", step " << step << ", grid " << i;
            }
        }
        // Every other weight so far counts, too.
        double amplitude = 0;
        for (Step a = 1; a <= step; ++a) {
            for (Step b = 1; b <= step; ++b) {
                if (a == b) continue;
                const double apart =
                    distance_squared(cloud.point(timeline.landmarks[a - 1]), cloud.point(timeline.landmarks[b - 1]));
                amplitude = std::max(amplitude, std::sqrt(timeline.weights_squared[a - 1] / apart));
            }
        }
        EXPECT_NEAR(pump.amplitude, amplitude, 1e-12);
    }
    // These few points of the plane and of R^4 leave it nothing to improve.
    if (cloud.dimension == 3) {
        EXPECT_GT(pumped, 0u);
    }
    if (name == "hidden") {
        EXPECT_FALSE(timeline.hidden.empty()) << "else the cloud does not ask what it is here to ask";
    }
}

INSTANTIATE_TEST_SUITE_P(Clouds, PumpingReference, testing::ValuesIn(cases()),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace plateau
