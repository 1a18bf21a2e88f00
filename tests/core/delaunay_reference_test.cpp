// The triangulation that the slow references trust, against empty circumspheres in exact integers, in three insertion
// orders, and in the plane against CGAL's triangulation of the plane.

#include <gtest/gtest.h>

#include "clouds.h"
#include "reference/run.h"

namespace plateau::reference {
namespace {

class DelaunayReference : public testing::TestWithParam<TestCloud> {};

TEST_P(DelaunayReference, HasEmptySpheresAndNoMemory) {
    const PointCloud& cloud = GetParam().cloud;
    Reference reference(cloud);
    const auto& landmarks = reference.order().landmarks;
    const int all = reference.step_count();
    for (int step = 1; step <= all; ++step) {
        SCOPED_TRACE("step " + std::to_string(step));
        const Triangulation& triangulation = reference.triangulation(step);
        const std::size_t exhaustive = cloud.dimension == 2 ? 18 : 13;
        if (static_cast<std::size_t>(step) <= exhaustive) {
            ASSERT_EQ(complaint_about(triangulation, empty_spheres(reference.points(), step)), "");
        } else if (step % 9 == 0 || step == all) {
            ASSERT_EQ(complaint_about_cells(triangulation, reference.points(), step), "");
        }
        ASSERT_EQ(triangulation.dimension, affine_dimension(reference.points(), step));
        for (const auto order : {InsertionOrder::Reversed, InsertionOrder::Lexicographic, InsertionOrder::Shuffled}) {
            ASSERT_EQ(delaunay(cloud, landmarks, step, order).cells, triangulation.cells);
        }
        if (cloud.dimension == 2) ASSERT_EQ(delaunay_in_plane(cloud, landmarks, step).cells, triangulation.cells);
    }
}

INSTANTIATE_TEST_SUITE_P(Clouds, DelaunayReference, testing::ValuesIn(test_clouds()),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace plateau::reference
