// The engine against the slow references on random small inputs. Every seed is its own input; a failure names it.

#include <gtest/gtest.h>

#include "random_clouds.h"

namespace plateau {
namespace {

TEST(RandomReference, AgreesOnSmallInputs) {
    for (std::uint64_t seed = 0; seed < 250; ++seed) EXPECT_EQ(random_run_difference(seed), "");
}

}  // namespace
}  // namespace plateau
