// Laws on runs too large for the slow references.

#include <gtest/gtest.h>

#include <algorithm>

#include "cloud/samples.h"
#include "laws.h"
#include "session/session.h"

namespace plateau {
namespace {

struct LargeRun {
    const char* shape;
    Family family;
    std::vector<std::uint32_t> nu;
    double rho;
    std::uint32_t size;
};

void expect_laws(const LargeRun& run) {
    auto sampled = sample_shape(run.shape, {.size = run.size});
    ASSERT_TRUE(sampled) << sampled.error().message;
    RunOptions options;
    options.family = run.family;
    options.nu = run.nu;
    options.rho = run.rho;
    Session session = Session::open(std::move(sampled).value(), options).value();
    ASSERT_EQ(session.run({}).state, RunState::Finished);
    const Timeline& timeline = session.timeline();
    ASSERT_EQ(timeline.step_count, run.size);
    EXPECT_EQ(timeline_is_valid(timeline), "");
    if (timeline.family != Family::Surface && timeline.family != Family::Auto) return;
    for (Step step = 1; step <= timeline.step_count; step += 37) {
        if (timeline.surface_rows(step).empty()) continue;
        ASSERT_EQ(timeline.shown_family[step - 1], Family::Surface);
        ASSERT_EQ(mesh_is_valid(surface_mesh(session.cloud(), timeline, step), timeline.betti_at(step)), "")
            << "step " << step;
    }
}

TEST(TimelineLaws, HoldOnATorus) {
    expect_laws({"torus", Family::Auto, {}, 0, 2000});
}
TEST(TimelineLaws, HoldOnAHelix) {
    expect_laws({"helix", Family::Auto, {}, 0, 1500});
}
TEST(TimelineLaws, HoldOnATanglecube) {
    expect_laws({"tanglecube", Family::Surface, {1, 6, 6, 4}, 0, 2000});
}
TEST(TimelineLaws, HoldWithARatioLimit) {
    expect_laws({"double-torus", Family::Surface, {}, 1.038, 2000});
}
TEST(TimelineLaws, HoldInTheComplexOfASphere) {
    expect_laws({"sphere", Family::Delaunay, {1, 3, 4, 5}, 0, 2000});
}
TEST(TimelineLaws, HoldInThePlane) {
    expect_laws({"nested-circles", Family::Delaunay, {}, 0, 2000});
}
TEST(TimelineLaws, HoldWithoutDelaunay) {
    expect_laws({"torus", Family::Witness, {1, 3, 4, 4}, 0, 300});
}

}  // namespace
}  // namespace plateau
