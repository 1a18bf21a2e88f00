// The same as random_reference_test.cpp and session_reference_test.cpp with more seeds, larger inputs, every step.

#include <gtest/gtest.h>

#include "clouds.h"
#include "comparison.h"
#include "random_clouds.h"

namespace plateau {
namespace {

TEST(RandomReferenceFull, AgreesOnManySmallInputs) {
    for (std::uint64_t seed = 1000; seed < 7000; ++seed) EXPECT_EQ(random_run_difference(seed), "");
}

TEST(RandomReferenceFull, AgreesOnLargerInputs) {
    for (std::uint64_t seed = 0; seed < 150; ++seed) EXPECT_EQ(random_run_difference(seed, 150), "");
}

TEST(RandomReferenceFull, SurfacesOfDenseCloudsAgreeAtEveryStep) {
    for (const char* name : {"torus_dense", "torus_with_disk_dense", "helix_dense", "shells_large", "torus_large"}) {
        const TestCloud cloud = test_cloud(name);
        reference::Reference expected(cloud.cloud, 0, cloud.max_steps);
        for (const double rho : {0.0, 1.038}) {
            const reference::Settings settings{reference::ShownFamily::Auto, {1, 6, 6, 4}, rho};
            EXPECT_EQ(run_difference(cloud.cloud, expected, settings, 0, cloud.max_steps, 1), "")
                << name << ", rho " << rho;
        }
    }
}

}  // namespace
}  // namespace plateau
