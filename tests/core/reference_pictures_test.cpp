// Hand-countable pictures for the slow references themselves: what is compared with must be right on its own.

#include <gtest/gtest.h>

#include <algorithm>

#include "clouds.h"
#include "reference/elimination.h"
#include "reference/run.h"

namespace plateau::reference {
namespace {

using Betti = std::vector<int>;

StepState last_state(const PointCloud& cloud, ShownFamily family, std::vector<int> nu = {}) {
    Reference reference(cloud);
    if (nu.empty()) nu = default_nu(family, static_cast<int>(cloud.dimension));
    return reference.state({family, nu}, reference.step_count());
}

Surface boundary_of(const PointCloud& cloud, const std::set<Simplex>& kept) {
    Reference reference(cloud);
    const int all = reference.step_count();
    return outer_boundary(kept, reference.triangulation(all), reference.points());
}

TEST(ReferenceSubsets, CountsAsBinomials) {
    EXPECT_EQ(subsets({1, 2, 3, 4, 5, 6}, 3).size(), 20u);
    EXPECT_EQ(subsets({1, 2}, 3).size(), 0u);
    EXPECT_EQ(subsets({4, 7}, 1), (std::vector<Simplex>{{4}, {7}}));
}

TEST(ReferenceOrder, SquareGoesToTheOppositeCornerThenToTheLowerIndex) {
    const FarthestOrder order = farthest_point_order(test_cloud("plane_square").cloud, 0);
    EXPECT_EQ(order.landmarks, (std::vector{0, 2, 1, 3}));
    EXPECT_EQ(order.epsilon_squared, (std::vector<double>{2, 1, 1, 0}));
}

TEST(ReferenceOrder, DuplicatesEndIt) {
    const FarthestOrder order = farthest_point_order(test_cloud("all_duplicates").cloud, 3);
    EXPECT_EQ(order.landmarks, std::vector{3});
    EXPECT_EQ(order.epsilon_squared, std::vector<double>{0});
}

TEST(ReferenceLists, TiesGoToTheEarlierStep) {
    const PointCloud cloud = test_cloud("plane_square").cloud;
    const auto lists = landmark_lists(cloud, farthest_point_order(cloud, 0), 4);
    EXPECT_EQ(lists[0], (std::vector{1, 3, 4, 2}));  // itself, two sides, the diagonal
    EXPECT_EQ(lists[1], (std::vector{3, 1, 2, 4}));
}

TEST(ReferenceWitness, ThreePointsOnALine) {
    // 0, 1, 3: the middle one is nearer to 0, so only 3 itself witnesses the edge to 1.
    PointCloud cloud{2, {0, 0, 3, 0, 1, 0}};
    const auto lists = landmark_lists(cloud, farthest_point_order(cloud, 0), 3);
    const Complex plain = witness_complex(lists, {1, 2, 3}, 2);
    EXPECT_EQ(plain[1], (std::set<Simplex>{{1, 3}, {2, 3}}));
    EXPECT_TRUE(plain[2].empty());  // witnessed, but its edge [1 2] is not
    EXPECT_EQ(witness_complex(lists, {1, 3, 3}, 2)[2].size(), 1u);
    EXPECT_TRUE(witness_complex(lists, {1, 3}, 2)[2].empty());
    EXPECT_TRUE(witness_complex(lists, {1, 1, 3}, 2)[1].empty());
    EXPECT_TRUE(witness_complex(lists, {0, 3, 3}, 2)[1].empty());
}

TEST(ReferenceElimination, KnownSpaces) {
    Complex circle = closure({{1, 2}, {2, 3}, {1, 3}});
    EXPECT_EQ(betti_numbers(circle, 2), (Betti{1, 1}));
    EXPECT_EQ(betti_numbers(closure({{1, 2, 3}, {4}}), 2), (Betti{2, 0}));
    EXPECT_EQ(betti_numbers(closure({{1, 2, 3}, {1, 2, 4}, {1, 3, 4}, {2, 3, 4}}), 3), (Betti{1, 0, 1}));
    EXPECT_EQ(betti_numbers(closure({{1, 2, 3, 4}}), 3), (Betti{1, 0, 0}));
}

TEST(ReferenceElimination, ProjectivePlaneTellsFieldsApart) {
    const Complex plane = closure(
        {{1, 2, 3}, {1, 3, 4}, {1, 4, 5}, {1, 5, 6}, {1, 2, 6}, {2, 3, 5}, {3, 5, 6}, {3, 4, 6}, {2, 4, 6}, {2, 4, 5}});
    EXPECT_EQ(betti_numbers(plane, 3, 2), (Betti{1, 1, 1}));
    EXPECT_EQ(betti_numbers(plane, 3, 3), (Betti{1, 0, 0}));
}

TEST(ReferenceDuality, AgreesWithElimination) {
    for (const char* name : {"grid", "cospherical_9", "shells_large", "two_spheres", "helix"}) {
        Reference reference(test_cloud(name).cloud);
        for (int step = 10; step <= reference.step_count(); step += 10) {
            Settings settings{ShownFamily::Delaunay, {1, 6, 6, 4}};
            const Betti eliminated = reference.state(settings, step).betti;
            settings.counting = Counting::Duality;
            EXPECT_EQ(reference.state(settings, step).betti, eliminated) << name << ", step " << step;
        }
    }
}

TEST(ReferenceExact, SignsOnIntegers) {
    const ExactPoints points = exact_points(test_cloud("cube").cloud, {0, 1, 2, 4, 7});
    // 000, 001, 010, 100, 111
    EXPECT_EQ(orientation(points, 1, 2, 3, 4), -1);
    EXPECT_EQ(orientation(points, 1, 3, 2, 4), 1);
    EXPECT_EQ(wedge_sign(points, {1, 2}, 3, 4), 0);  // a right angle
    EXPECT_EQ(Circumsphere(points, {1, 2, 3, 4}).side(5), 0);
    EXPECT_EQ(affine_dimension(points, 1), 0);
    EXPECT_EQ(affine_dimension(points, 2), 1);
    EXPECT_EQ(affine_dimension(points, 3), 2);
    EXPECT_EQ(affine_dimension(points, 5), 3);
}

TEST(ReferenceExact, RadiusEdgeRatio) {
    // Right isosceles: R / shortest = 1 / sqrt 2. Angles 30, 30, 120: exactly 1, which does not exceed 1.
    const PointCloud cloud{3, {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 1, 0, 1, 2, 1, 1}};
    const ExactPoints points = exact_points(cloud, {0, 1, 2, 3, 4, 5});
    EXPECT_TRUE(radius_edge_ratio_exceeds(points, {1, 2, 3}, 0.7));
    EXPECT_FALSE(radius_edge_ratio_exceeds(points, {1, 2, 3}, 0.71));
    EXPECT_FALSE(radius_edge_ratio_exceeds(points, {1, 4, 6}, 1));
    EXPECT_TRUE(radius_edge_ratio_exceeds(points, {1, 4, 6}, 0.999));
}

TEST(ReferenceSpheres, SquareIsTiedAndItsCenterIsNot) {
    const ExactPoints square = exact_points(test_cloud("plane_square").cloud, {0, 1, 2, 3});
    EXPECT_EQ(empty_spheres(square, 4).tied.size(), 4u);
    EXPECT_TRUE(empty_spheres(square, 4).empty.empty());
    const PointCloud with_center{2, {0, 0, 2, 0, 2, 2, 0, 2, 1, 1}};
    EXPECT_EQ(empty_spheres(exact_points(with_center, {0, 1, 2, 3, 4}), 5).empty.size(), 4u);
}

TEST(ReferenceSpheres, LowerDimensions) {
    const PointCloud line{3, {0, 0, 0, 3, 3, 3, 1, 1, 1}};
    const EmptySpheres spheres = empty_spheres(exact_points(line, {0, 1, 2}), 3);
    EXPECT_EQ(spheres.dimension, 1);
    EXPECT_EQ(spheres.empty, (std::set<Simplex>{{1, 3}, {2, 3}}));
    EXPECT_EQ(empty_spheres(exact_points(line, {1}), 1).empty, (std::set<Simplex>{{1}}));
}

TEST(ReferenceSurface, OctahedronIsASphere) {
    // D(L) is four tetrahedra around a diagonal. All twelve triangles have a witness, as six landmarks are in every
    // list; no tetrahedron has one: the first four of a list never hold a diagonal.
    const StepState state = last_state(test_cloud("octahedron").cloud, ShownFamily::Auto);
    EXPECT_EQ(state.tracks[0][2].size(), 12u);
    EXPECT_EQ(state.tracks[0][3].size(), 0u);
    EXPECT_EQ(state.surface.rows.size(), 8u);
    EXPECT_EQ(state.shown, ShownFamily::Surface);
    EXPECT_EQ(state.betti, (Betti{1, 0, 1}));
    EXPECT_EQ(state.surface.betti_by_elimination(), state.betti);
}

TEST(ReferenceSurface, RightAnglesAreSharp) {
    // A cube has right angles, a regular tetrahedron smaller ones: nothing is left.
    EXPECT_TRUE(last_state(test_cloud("cube").cloud, ShownFamily::Surface, {1, 8, 8, 8}).surface.rows.empty());
    EXPECT_TRUE(last_state(test_cloud("four_points").cloud, ShownFamily::Surface).surface.rows.empty());
    const StepState state = last_state(test_cloud("four_points").cloud, ShownFamily::Surface);
    EXPECT_TRUE(state.empty);
    EXPECT_EQ(state.betti, (Betti{0, 0, 0}));
}

TEST(ReferenceSurface, OneTetrahedronIsCountedOnceFromOutside) {
    const Surface surface = boundary_of(test_cloud("four_points").cloud, closure({{1, 2, 3, 4}})[2]);
    EXPECT_EQ(surface.rows.size(), 4u);
    EXPECT_EQ(surface.vertex_count, 4);
    EXPECT_EQ(surface.betti(), (Betti{1, 0, 1}));
    EXPECT_EQ(surface.betti_by_elimination(), (Betti{1, 0, 1}));
}

/// The origin shared by two tetrahedra that lie opposite to each other, with the points 1 .. 7 in input order.
PointCloud opposite_tetrahedra() {
    return {3, {0, 0, 0, 4, 1, 0, 4, -1, 1, 4, 0, -2, -4, 1, 0, -4, -1, 1, -4, 0, -2}};
}

TEST(ReferenceSurface, BodiesTouchingAtAVertexFallApart) {
    Reference reference(opposite_tetrahedra());
    const auto& landmarks = reference.order().landmarks;
    Simplex right, left;
    int origin = 0;
    for (int step = 1; step <= 7; ++step) {
        const int input = landmarks[static_cast<std::size_t>(step - 1)];
        if (input == 0) origin = step;
        if (input <= 3) right.push_back(step);
        if (input == 0 || input > 3) left.push_back(step);
    }
    ASSERT_GT(origin, 0);
    ASSERT_EQ(reference.triangulation(7).cells.count(right) + reference.triangulation(7).cells.count(left), 2u);
    const Surface surface = boundary_of(opposite_tetrahedra(), closure({right, left})[2]);
    EXPECT_EQ(surface.vertex_count, 8);
    EXPECT_EQ(surface.component_count, 2);
    EXPECT_EQ(surface.betti(), (Betti{2, 0, 2}));
    EXPECT_EQ(surface.betti_by_elimination(), surface.betti());
}

TEST(ReferenceSurface, BodiesTouchingAtAnEdgeAreGluedFromOutside) {
    // Two of the four tetrahedra around the diagonal of the octahedron, opposite to each other: the outer cells join
    // them along the diagonal, which becomes two edges with the same two vertices.
    Reference reference(test_cloud("octahedron").cloud);
    const auto& cells = reference.triangulation(6).cells;
    const Simplex first = *cells.begin();
    Simplex second;
    for (const Simplex& cell : cells) {
        int shared = 0;
        for (const int vertex : cell) shared += std::binary_search(first.begin(), first.end(), vertex);
        if (shared == 2) second = cell;
    }
    const Surface surface = boundary_of(test_cloud("octahedron").cloud, closure({first, second})[2]);
    EXPECT_EQ(surface.rows.size(), 8u);
    EXPECT_EQ(surface.vertex_count, 6);
    EXPECT_EQ(surface.edge_count, 12);
    EXPECT_EQ(surface.betti(), (Betti{1, 0, 1}));
    EXPECT_EQ(surface.betti_by_elimination(), surface.betti());
}

TEST(ReferenceSurface, AFacetBetweenTwoOuterCellsCountsTwice) {
    const PointCloud octahedron = test_cloud("octahedron").cloud;
    Reference reference(octahedron);
    const Simplex cell = *reference.triangulation(6).cells.begin();
    const Surface pillow = boundary_of(octahedron, {facets(cell)[0]});
    ASSERT_EQ(pillow.rows.size(), 2u);
    EXPECT_NE(pillow.rows[0].side, pillow.rows[1].side);
    EXPECT_EQ(pillow.vertex_count, 3);
    EXPECT_EQ(pillow.betti(), (Betti{1, 0, 1}));
    EXPECT_EQ(pillow.betti_by_elimination(), pillow.betti());
    EXPECT_TRUE(without_sharp_edges({facets(cell)[0]}, reference.points(), 0).empty());
}

TEST(ReferencePlateaus, RunsAndRatios) {
    std::vector<StepState> states(4);
    const double squares[] = {16, 4, 1, 0};
    for (std::size_t i = 0; i < 4; ++i) {
        states[i].epsilon_squared = squares[i];
        states[i].betti = {1, i < 2 ? 0 : 1};
    }
    const auto runs = plateaus(states);
    ASSERT_EQ(runs.size(), 2u);
    EXPECT_EQ(runs[0].last_step, 2);
    EXPECT_EQ(runs[0].ratio, 4);  // epsilon(1) / epsilon(3)
    EXPECT_EQ(runs[1].ratio, 1);  // the last positive epsilon stands for what is not known
    states[2].empty = states[3].empty = true;
    EXPECT_EQ(plateaus(states).size(), 1u);
}

}  // namespace
}  // namespace plateau::reference
