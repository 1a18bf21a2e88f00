// The engine against the references at some steps of runs of a thousand, where blocks of steps, long peelings and long
// voids occur that small clouds do not have.

#include <gtest/gtest.h>

#include "cloud/samples.h"
#include "comparison.h"

namespace plateau {
namespace {

using reference::Counting;
using reference::Settings;
using reference::ShownFamily;

struct LargeRun {
    const char* shape;
    std::uint32_t size;
    Settings settings;
};

void expect_agreement(const LargeRun& run) {
    const PointCloud cloud = sample_shape(run.shape, {.size = run.size}).value();
    reference::Reference expected(cloud);
    EXPECT_EQ(run_difference(cloud, expected, run.settings, 0, reference::kAllSteps, 149), "")
        << run.shape << ", " << name_of(run.settings.family);
}

TEST(LargeReference, Torus) {
    expect_agreement({"torus", 1000, {ShownFamily::Auto, {1, 6, 6, 4}, 0, 2, Counting::Duality}});
}
TEST(LargeReference, Helix) {
    expect_agreement({"helix", 700, {ShownFamily::Auto, {1, 6, 6, 4}, 0, 2, Counting::Duality}});
}
TEST(LargeReference, Tanglecube) {
    expect_agreement({"tanglecube", 1000, {ShownFamily::Surface, {1, 6, 6, 4}, 1.038, 2, Counting::Duality}});
}
TEST(LargeReference, Sphere) {
    expect_agreement({"sphere", 1000, {ShownFamily::Delaunay, {1, 6, 6, 4}, 0, 2, Counting::Duality}});
}
TEST(LargeReference, Circles) {
    expect_agreement({"nested-circles", 800, {ShownFamily::Delaunay, {1, 2, 3}}});
}

}  // namespace
}  // namespace plateau
