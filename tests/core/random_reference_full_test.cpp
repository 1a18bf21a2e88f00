// The same as random_reference_test.cpp with many more seeds.

#include <gtest/gtest.h>

#include "random_clouds.h"

namespace plateau {
namespace {

TEST(RandomReferenceFull, AgreesOnManySmallInputs) {
    for (std::uint64_t seed = 1000; seed < 7000; ++seed) EXPECT_EQ(random_run_difference(seed), "");
}

}  // namespace
}  // namespace plateau
