// Pictures in the plane against their definitions: lists, triangulation, complex, witnesses, Betti numbers, cells.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <utility>

#include "base/random.h"
#include "comparison.h"
#include "inspection_comparison.h"
#include "plane/plane_picture.h"
#include "reference/elimination.h"
#include "reference/witness.h"

namespace plateau {
namespace {

using reference::Complex;
using reference::Simplex;

PointCloud uniform(std::uint32_t size, std::uint64_t seed) {
    Random random(seed);
    PointCloud cloud{2, {}};
    for (std::uint32_t i = 0; i < 2 * size; ++i) cloud.coordinates.push_back(random.next_unit());
    return cloud;
}

/// Points of a grid of so many columns.
PointCloud grid(std::uint32_t size, std::uint32_t columns, double spacing) {
    PointCloud cloud{2, {}};
    for (std::uint32_t i = 0; i < size; ++i) {
        cloud.coordinates.insert(cloud.coordinates.end(), {spacing * (i % columns), spacing * (i / columns)});
    }
    return cloud;
}

/// Integer points of the circle of radius 65 around (70, 70): 36 of them.
PointCloud circle() {
    PointCloud cloud{2, {}};
    for (int x = -65; x <= 65; ++x) {
        for (int y = -65; y <= 65; ++y) {
            if (x * x + y * y == 65 * 65) cloud.coordinates.insert(cloud.coordinates.end(), {70.0 + x, 70.0 + y});
        }
    }
    return cloud;
}

PointCloud line(std::uint32_t size) {
    PointCloud cloud{2, {}};
    for (std::uint32_t i = 0; i < size; ++i) {
        const double x = (i * 7) % size;
        cloud.coordinates.insert(cloud.coordinates.end(), {x, 2 * x + 1});
    }
    return cloud;
}

PointCloud joined_clouds(PointCloud a, const PointCloud& b) {
    a.coordinates.insert(a.coordinates.end(), b.coordinates.begin(), b.coordinates.end());
    return a;
}

struct SceneCase {
    std::string name;
    PointCloud witnesses, landmarks;
    PlaneBox box;
};

std::ostream& operator<<(std::ostream& out, const SceneCase& value) {
    return out << value.name;
}

std::vector<SceneCase> scenes() {
    const PointCloud few = uniform(12, 1);
    const PointCloud circle_with_center = joined_clouds(circle(), {2, {70, 70}});
    return {
        {"uniform", uniform(200, 2), uniform(40, 3), {0, 0, 1, 1}},
        {"few", uniform(30, 4), few, {-0.5, -0.25, 1.5, 2}},
        {"landmarks_are_witnesses", joined_clouds(uniform(40, 5), few), few, {0.25, 0.25, 0.75, 0.5}},
        {"grid", grid(169, 13, 0.5), grid(49, 7, 1), {-1, -1, 7, 7}},
        {"grid_tenth", grid(120, 12, 0.05), grid(30, 6, 0.1), {0, 0, 1, 1}},
        {"cocircular", joined_clouds(uniform(60, 6), circle()), circle(), {0, 0, 140, 140}},
        {"cocircular_with_center", circle(), circle_with_center, {0, 0, 140, 140}},
        {"collinear", joined_clouds(line(31), grid(40, 8, 2)), line(9), {-3, -3, 20, 20}},
        {"one_landmark", uniform(5, 7), uniform(1, 8), {0, 0, 1, 1}},
        {"two_landmarks", uniform(9, 9), uniform(2, 10), {0, 0, 1, 1}},
        {"far_witnesses", grid(20, 5, 0.01), grid(25, 5, 1), {-1, -1, 5, 5}},
        {"outside", uniform(30, 11), uniform(15, 12), {3, 3, 4, 5}},
    };
}

Simplex places(const std::vector<Step>& steps) {
    return {steps.begin(), steps.end()};
}

template <class Tuples>
std::set<Simplex> as_set(const Tuples& tuples) {
    std::set<Simplex> set;
    for (const auto& tuple : tuples) set.insert(Simplex(tuple.begin(), tuple.end()));
    return set;
}

DefinedComplex defined(const PlaneScene& scene) {
    DefinedComplex result;
    result.max_dimension = 2;
    result.nu.assign(scene.nu.begin(), scene.nu.end());
    result.landmark_count = static_cast<int>(scene.landmarks.size());
    for (std::uint32_t w = 0; w < scene.witnesses.size(); ++w) {
        std::vector<std::pair<double, int>> ranked;
        for (std::uint32_t p = 0; p < scene.landmarks.size(); ++p) {
            const double dx = scene.landmarks.point(p)[0] - scene.witnesses.point(w)[0];
            const double dy = scene.landmarks.point(p)[1] - scene.witnesses.point(w)[1];
            ranked.emplace_back(dx * dx + dy * dy, static_cast<int>(p) + 1);
        }
        std::sort(ranked.begin(), ranked.end());
        result.lists.emplace_back();
        for (const auto& [squared, landmark] : ranked) result.lists.back().push_back(landmark);
    }
    result.complex = reference::witness_complex(result.lists, result.nu, 2);
    if (!scene.within_delaunay) return result;
    for (std::uint32_t p = 0; p < scene.landmarks.size(); ++p) {
        const auto place = scene.landmarks.point(p);
        result.points.push_back({{place[0], place[1], 0}, static_cast<int>(p) + 1});
    }
    result.triangulation = reference::triangulate_plane(result.points);
    result.complex = reference::intersection(result.complex, reference::closure(result.triangulation->cells));
    return result;
}

double area(const PlanePolygons& polygons, std::size_t index) {
    double twice = 0;
    const std::uint32_t first = polygons.first_corner[index];
    const std::uint32_t last = polygons.first_corner[index + 1];
    for (std::uint32_t i = first; i < last; ++i) {
        const std::uint32_t next = i + 1 < last ? i + 1 : first;
        twice += polygons.corners[2 * i] * polygons.corners[2 * next + 1] -
                 polygons.corners[2 * next] * polygons.corners[2 * i + 1];
    }
    return twice / 2;
}

/// Whether the point is left of every side by more than a hair: certainly in; 1 in, -1 out, 0 on the boundary.
int side_of(const PlanePolygons& polygons, std::size_t index, double x, double y, double hair) {
    const std::uint32_t first = polygons.first_corner[index];
    const std::uint32_t last = polygons.first_corner[index + 1];
    if (first == last) return -1;
    int side = 1;
    for (std::uint32_t i = first; i < last; ++i) {
        const std::uint32_t next = i + 1 < last ? i + 1 : first;
        const double ax = polygons.corners[2 * i], ay = polygons.corners[2 * i + 1];
        const double bx = polygons.corners[2 * next], by = polygons.corners[2 * next + 1];
        const double length = std::hypot(bx - ax, by - ay);
        if (length < hair) continue;
        const double left = ((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / length;
        if (left < -hair) return -1;
        if (left < hair) side = 0;
    }
    return side;
}

class PlaneReference : public testing::TestWithParam<SceneCase> {};

TEST_P(PlaneReference, DrawsTheDefinition) {
    const SceneCase& one = GetParam();
    for (const std::vector<std::uint32_t>& nu :
         {std::vector<std::uint32_t>{1, 2, 3}, {1, 6, 6}, {2, 3, 5}, {1, 4}, {3, 1, 3}}) {
        for (const bool within : {true, false}) {
            SCOPED_TRACE("nu " + joined(nu) + (within ? " within D(L)" : ""));
            const PlaneScene scene{one.witnesses, one.landmarks, nu, within};
            const auto drawn = plane_picture(scene, one.box);
            ASSERT_TRUE(drawn) << drawn.error().message;
            const PlanePicture& picture = drawn.value();
            DefinedComplex expected = defined(scene);

            const auto length = std::min<std::size_t>(
                scene.landmarks.size(), std::max<std::size_t>(3, *std::max_element(nu.begin(), nu.end())));
            ASSERT_EQ(picture.list_length, length);
            for (std::size_t w = 0; w < expected.lists.size(); ++w) {
                std::vector<int> list = expected.lists[w];
                list.resize(length);
                const auto begin = picture.lists.begin() + static_cast<std::ptrdiff_t>(w * length);
                ASSERT_EQ(std::vector<int>(begin, begin + static_cast<std::ptrdiff_t>(length)), list);
            }
            if (within) {
                const Complex all = reference::closure(expected.triangulation->cells);
                ASSERT_EQ(as_set(picture.delaunay_edges), all[1]);
                ASSERT_EQ(as_set(picture.delaunay_triangles), all[2]);
            }
            std::set<Simplex> vertices;
            for (const Step vertex : picture.vertices) vertices.insert({static_cast<int>(vertex)});
            ASSERT_EQ(vertices, expected.complex[0]);
            ASSERT_EQ(as_set(picture.edges), expected.complex[1]);
            ASSERT_EQ(as_set(picture.triangles), expected.complex[2]);
            ASSERT_EQ(picture.edges.size(), expected.complex[1].size());
            ASSERT_EQ(picture.triangles.size(), expected.complex[2].size());

            std::array<std::vector<Simplex>, 3> simplices;
            for (const Step vertex : picture.vertices) simplices[0].push_back({static_cast<int>(vertex)});
            for (const auto& edge : picture.edges) simplices[1].push_back({edge.begin(), edge.end()});
            for (const auto& triangle : picture.triangles) simplices[2].push_back({triangle.begin(), triangle.end()});
            for (std::size_t k = 0; k < 3; ++k) {
                const WitnessLists& lists = picture.witnesses[k];
                ASSERT_EQ(lists.first.size(), simplices[k].size() + 1);
                for (std::size_t i = 0; i < simplices[k].size(); ++i) {
                    std::vector<std::uint32_t> witnesses;
                    for (std::uint32_t w = 0; w < expected.lists.size(); ++w) {
                        std::vector<int> nearest = expected.lists[w];
                        nearest.resize(std::min<std::size_t>(nearest.size(), nu[k]));
                        std::sort(nearest.begin(), nearest.end());
                        const Simplex& simplex = simplices[k][i];
                        if (std::includes(nearest.begin(), nearest.end(), simplex.begin(), simplex.end())) {
                            witnesses.push_back(w);
                        }
                    }
                    ASSERT_FALSE(witnesses.empty());
                    ASSERT_EQ(std::vector<std::uint32_t>(lists.witnesses.begin() + lists.first[i],
                                                         lists.witnesses.begin() + lists.first[i + 1]),
                              witnesses);
                }
            }
            const auto betti = reference::betti_numbers(expected.complex, 2);
            ASSERT_EQ(std::vector<int>(picture.betti.begin(), picture.betti.end()), betti);
        }
    }
}

TEST_P(PlaneReference, CellsCoverTheBoxAndHoldWhatIsNearest) {
    const SceneCase& one = GetParam();
    const PlaneScene scene{one.witnesses, one.landmarks, {1, 2, 3}, true};
    const PlanePicture picture = plane_picture(scene, one.box).value();
    const double width = one.box.right - one.box.left;
    const double height = one.box.top - one.box.bottom;
    const double whole = width * height;
    const std::uint32_t count = scene.landmarks.size();
    ASSERT_EQ(picture.cells.first_corner.size(), count + 1);
    ASSERT_EQ(picture.pair_cells.first_corner.size(), picture.delaunay_edges.size() + 1);
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) sum += area(picture.cells, i);
    EXPECT_NEAR(sum, whole, 1e-12 * whole * 100);
    double pairs = 0;
    for (std::size_t i = 0; i < picture.delaunay_edges.size(); ++i) {
        EXPECT_GE(area(picture.pair_cells, i), -1e-12 * whole);
        pairs += area(picture.pair_cells, i);
    }
    EXPECT_NEAR(pairs, count < 2 ? 0 : whole, 1e-12 * whole * 100);

    Random random(99);
    const double hair = 1e-9 * (width + height);
    for (int i = 0; i < 2000; ++i) {
        const double x = one.box.left + width * random.next_unit();
        const double y = one.box.bottom + height * random.next_unit();
        std::vector<std::pair<double, Step>> ranked;
        for (std::uint32_t p = 0; p < count; ++p) {
            ranked.emplace_back(std::hypot(scene.landmarks.point(p)[0] - x, scene.landmarks.point(p)[1] - y), p + 1);
        }
        std::sort(ranked.begin(), ranked.end());
        const bool is_first_clear = count < 2 || ranked[1].first - ranked[0].first > 10 * hair;
        if (is_first_clear) {
            for (Step p = 1; p <= count; ++p) {
                const int side = side_of(picture.cells, p - 1, x, y, hair);
                ASSERT_TRUE(p == ranked[0].second ? side >= 0 : side <= 0) << p << " at " << x << ", " << y;
            }
        }
        const bool is_pair_clear = count > 1 && (count < 3 || ranked[2].first - ranked[1].first > 10 * hair);
        if (!is_pair_clear) continue;
        const PlaneComplex::Edge pair = {std::min(ranked[0].second, ranked[1].second),
                                         std::max(ranked[0].second, ranked[1].second)};
        bool found = false;
        for (std::size_t e = 0; e < picture.delaunay_edges.size(); ++e) {
            const int side = side_of(picture.pair_cells, e, x, y, hair);
            const bool is_pair = picture.delaunay_edges[e] == pair;
            found = found || is_pair;
            ASSERT_TRUE(is_pair ? side >= 0 : side <= 0) << joined(pair) << " at " << x << ", " << y;
        }
        ASSERT_TRUE(found) << joined(pair);
    }
}

TEST_P(PlaneReference, SaysWhy) {
    const SceneCase& one = GetParam();
    Random random(7);
    const auto below = [&](std::uint64_t bound) { return static_cast<int>(random.next_bits() % bound); };
    for (const bool within : {true, false}) {
        const PlaneScene scene{one.witnesses, one.landmarks, {1, 2, 3}, within};
        const DefinedComplex expected = defined(scene);
        for (int i = 0; i < 40; ++i) {
            const std::vector<int>& list = expected.lists[static_cast<std::size_t>(below(expected.lists.size()))];
            const int size = 1 + below(4);
            std::set<int> chosen;
            for (int tries = 0; tries < 20 && static_cast<int>(chosen.size()) < size; ++tries) {
                const auto reach = std::min<std::size_t>(list.size(), i % 3 == 0 ? list.size() : 4);
                chosen.insert(list[static_cast<std::size_t>(below(reach))]);
            }
            const Simplex asked(chosen.begin(), chosen.end());
            const auto found = plane_why(scene, {chosen.begin(), chosen.end()});
            ASSERT_TRUE(found) << found.error().message;
            ASSERT_EQ(inspection_difference(expected, asked, found.value()), "") << joined(asked);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, PlaneReference, testing::ValuesIn(scenes()),
                         [](const auto& instance) { return instance.param.name; });

std::string refusal(const PlaneScene& scene) {
    const auto drawn = plane_picture(scene, {0, 0, 1, 1});
    return drawn ? "" : drawn.error().message;
}

TEST(Plane, RefusesWhatIsNoPicture) {
    const PointCloud some = uniform(4, 1);
    EXPECT_EQ(refusal({some, {2, {0, 0, 1, 0, 0, 0}}}),
              "Landmarks 1 and 3 are in one place: move one of them, or leave it out.");
    EXPECT_EQ(refusal({some, {2, {0, 0, 1, std::nan("")}}}),
              "A coordinate of landmark 2 is no number that can be computed with.");
    EXPECT_EQ(refusal({{2, {1, 2, 3}}, some}), "A witness lacks its second coordinate.");
    EXPECT_NE(refusal({some, some, {}}), "");
    EXPECT_NE(refusal({some, some, {0, 2}}), "");
    EXPECT_NE(refusal({some, some, {1, 33}}), "");
    EXPECT_FALSE(plane_picture({some, some}, {1, 0, 1, 1}));
    EXPECT_FALSE(plane_picture({some, some}, {0, 0, 1, std::nan("")}));
}

TEST(Plane, DrawsNothingOfNothing) {
    const PlanePicture empty = plane_picture({{2, {}}, {2, {}}}, {0, 0, 1, 1}).value();
    EXPECT_EQ(empty.cells.first_corner.size(), 1u);
    EXPECT_EQ(empty.betti, (std::array<std::uint32_t, 2>{0, 0}));
    const PlanePicture unwitnessed = plane_picture({{2, {}}, uniform(5, 3)}, {0, 0, 1, 1}).value();
    EXPECT_TRUE(unwitnessed.vertices.empty());
    EXPECT_TRUE(unwitnessed.edges.empty());
    EXPECT_FALSE(unwitnessed.delaunay_triangles.empty());
    const Inspection why = plane_why({{2, {}}, uniform(5, 3)}, {2}).value();
    EXPECT_EQ(why.verdict, Verdict::NotWitnessed);
    EXPECT_FALSE(why.sightings.best);
    EXPECT_EQ(places(why.about), Simplex{2});
}

}  // namespace
}  // namespace plateau
