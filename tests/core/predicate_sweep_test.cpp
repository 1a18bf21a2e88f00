#include "sweep/predicate_sweep.h"

#include <gtest/gtest.h>

namespace plateau::sweep {
namespace {

TEST(PredicateSweep, EverySignIsThatOfTheExactDeterminant) {
    const Outcome outcome = sweep_predicates(4000);
    EXPECT_EQ(outcome.calls, 5u * 3u * 4000u * 6u);
    EXPECT_EQ(outcome.mismatches, 0u);
}

// The module must print the same: tests/wasm/predicate-sweep.test.ts.
TEST(PredicateSweep, GridOfSpacingOneTenth) {
    EXPECT_EQ(grid_delaunay_hash(20, 0.1), 0x062319d005b19696ull);
}

}  // namespace
}  // namespace plateau::sweep
