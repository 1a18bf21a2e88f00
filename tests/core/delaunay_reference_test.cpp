// The triangulation that the slow references trust, against empty circumspheres in exact integers, in three insertion
// orders, and in the plane against CGAL's triangulation of the plane.

#include <gtest/gtest.h>

#include <algorithm>

#include "clouds.h"
#include "delaunay/delaunay.h"
#include "reference/run.h"

namespace plateau::reference {
namespace {

class DelaunayReference : public testing::TestWithParam<TestCloud> {};

TEST_P(DelaunayReference, HasEmptySpheresAndNoMemory) {
    const PointCloud& cloud = GetParam().cloud;
    Reference reference(cloud, 0, GetParam().max_steps);
    const auto& landmarks = reference.order().landmarks;
    const int all = reference.step_count();
    for (int step = 1; step <= all; ++step) {
        SCOPED_TRACE("step " + std::to_string(step));
        const Triangulation& triangulation = reference.triangulation(step);
        const bool compare_fully = all <= 60 || step % 9 == 0 || step == all;
        const std::size_t exhaustive = cloud.dimension == 2 ? 24 : 16;
        if (static_cast<std::size_t>(step) <= exhaustive) {
            ASSERT_EQ(complaint_about(triangulation, empty_spheres(reference.points(), step)), "");
        } else if (compare_fully) {
            ASSERT_EQ(complaint_about_cells(triangulation, reference.points(), step), "");
        }
        ASSERT_EQ(triangulation.dimension, affine_dimension(reference.points(), step));
        if (!compare_fully) continue;
        for (const auto order : {InsertionOrder::Reversed, InsertionOrder::Lexicographic, InsertionOrder::Shuffled}) {
            ASSERT_EQ(delaunay(cloud, landmarks, step, order).cells, triangulation.cells);
        }
        if (cloud.dimension == 2) {
            ASSERT_EQ(delaunay_in_plane(cloud, landmarks, step).cells, triangulation.cells);
        }
    }
}

/// Cells of the engine's triangulation without the infinite ones.
std::set<Simplex> finite_cells(const Delaunay& triangulation) {
    std::set<Simplex> cells;
    for (CellId id = 0; id < triangulation.cell_capacity(); ++id) {
        const DelaunayCell& cell = triangulation.cell(id);
        if (!cell.alive || !cell.finite(triangulation.dimension())) continue;
        Simplex vertices(cell.vertex.begin(), cell.vertex.begin() + triangulation.dimension() + 1);
        std::sort(vertices.begin(), vertices.end());
        cells.insert(vertices);
    }
    return cells;
}

TEST_P(DelaunayReference, EqualsTheIncrementalTriangulation) {
    const PointCloud& cloud = GetParam().cloud;
    Reference reference(cloud, 0, GetParam().max_steps);
    Delaunay engine(cloud.dimension);
    for (int step = 1; step <= reference.step_count(); ++step) {
        SCOPED_TRACE("step " + std::to_string(step));
        const int landmark = reference.order().landmarks[static_cast<std::size_t>(step - 1)];
        // The earlier landmark nearest to the new one comes second in its list, after itself.
        const int hint = step == 1 ? 0 : reference.lists(step)[static_cast<std::size_t>(landmark)][1];
        const auto change =
            engine.insert(static_cast<std::uint32_t>(step), cloud.point(static_cast<std::uint32_t>(landmark)),
                          static_cast<std::uint32_t>(hint));
        ASSERT_TRUE(change);
        ASSERT_EQ(engine.dimension(), reference.triangulation(step).dimension);
        ASSERT_EQ(finite_cells(engine), reference.triangulation(step).cells);
    }
}

INSTANTIATE_TEST_SUITE_P(Clouds, DelaunayReference, testing::ValuesIn(test_clouds()),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace plateau::reference
