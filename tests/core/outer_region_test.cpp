// The outer region against a flood over all cells. The landmarks come in any order, which a session never does: then
// pockets are cut off by triangles of a new star alone.

#include "surface/outer_region.h"

#include <gtest/gtest.h>

#include <vector>

#include "base/random.h"
#include "cloud/point_cloud.h"
#include "complex/nu_complex.h"
#include "landmarks/landmark_lists.h"

namespace plateau {
namespace {

/// Cells reached from the infinite ones through facets that are not in K, by the definition.
std::vector<bool> flooded(const Delaunay& delaunay, const DelaunayFaces& faces, const Peeling& peeling) {
    std::vector<bool> outer(delaunay.cell_capacity(), false);
    std::vector<CellId> stack;
    const auto reach = [&](CellId cell) {
        if (outer[cell]) return;
        outer[cell] = true;
        stack.push_back(cell);
    };
    for (CellId cell = 0; cell < delaunay.cell_capacity(); ++cell) {
        if (delaunay.cell(cell).alive && !delaunay.cell(cell).finite(3)) reach(cell);
    }
    while (!stack.empty()) {
        const CellId cell = stack.back();
        stack.pop_back();
        for (int i = 0; i < 4; ++i) {
            const SimplexIndex triangle = faces.triangle(cell, i);
            const bool open = triangle == kNoSimplex || !peeling.kept(triangle);
            if (open) reach(delaunay.cell(cell).neighbor[static_cast<std::size_t>(i)]);
        }
    }
    return outer;
}

/// How many cells that stayed an insertion enclosed or opened.
struct Flips {
    int enclosed = 0, opened = 0;
};

/// Inserts so many points in input order and compares at every step. All points are witnesses.
void expect_flooded_at_every_step(const PointCloud& cloud, const std::vector<std::uint32_t>& nu, Step landmark_count,
                                  Flips& flips) {
    LandmarkLists lists(cloud, 6);
    while (!lists.prepare(Deadline::never())) continue;
    Delaunay delaunay(3);
    NuComplex complex({nu}, 3, cloud.size());
    std::vector<SimplexTable> tables(3);
    for (int k = 1; k <= 3; ++k) tables[static_cast<std::size_t>(k - 1)].dimension = k;
    Peeling peeling(0);
    OuterRegion region;
    std::vector<std::uint32_t> landmarks;
    const LandmarkPoints points{&cloud, &landmarks};
    bool started = false;
    for (Step step = 1; step <= landmark_count; ++step) {
        const std::uint32_t hint = lists.list(lists.witness(step - 1))[0];
        const DelaunayChange& change = *delaunay.insert(step, cloud.point(step - 1), hint).value();
        landmarks.push_back(step - 1);
        const Deadline deadline(1e300);
        Slice slice(deadline);
        complex.insert(step, lists, lists.insert(step - 1, step), delaunay, change, tables);
        if (change.dimension < 3) continue;
        ASSERT_TRUE(peeling.update(step, tables, complex, complex.deaths(), points, !started, slice));
        ASSERT_TRUE(region.update(step, delaunay, change, complex.faces(), peeling, !started, slice));
        started = true;
        const std::vector<bool> expected = flooded(delaunay, complex.faces(), peeling);
        for (CellId cell = 0; cell < expected.size(); ++cell) {
            if (!delaunay.cell(cell).alive) continue;
            ASSERT_EQ(region.outer(cell), expected[cell]) << "cell " << cell << " at step " << step;
        }
        for (const CellId cell : region.flipped()) ++(region.outer(cell) ? flips.opened : flips.enclosed);
    }
}

PointCloud random_points(std::uint32_t size, std::uint64_t seed) {
    Random random(seed);
    PointCloud cloud{3, {}};
    for (std::uint32_t i = 0; i < 3 * size; ++i) cloud.coordinates.push_back(random.next_unit());
    return cloud;
}

TEST(OuterRegion, IsFloodedAtEveryStep) {
    Flips flips;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        for (const auto& nu : std::vector<std::vector<std::uint32_t>>{{1, 6, 6, 4}, {1, 5, 5, 5}, {1, 4, 4, 4}}) {
            expect_flooded_at_every_step(random_points(300, seed), nu, 40, flips);
            if (HasFatalFailure()) FAIL() << "seed " << seed << ", nu " << nu[1];
        }
    }
    // Else the clouds would not have asked what they are here to ask.
    EXPECT_GT(flips.enclosed, 100);
    EXPECT_GT(flips.opened, 100);
}

// A rare pocket: no triangle around it was there before, so only the cells that died tell that it was open.
TEST(OuterRegion, IsCutOffByTheStarOfTheLandmarkAlone) {
    Flips flips;
    for (const auto& nu : std::vector<std::vector<std::uint32_t>>{{1, 6, 6, 6}, {1, 6, 5, 4}}) {
        expect_flooded_at_every_step(random_points(300, 60), nu, 60, flips);
    }
}

}  // namespace
}  // namespace plateau
