// The surface in numbers against the surface from its definition: components by walking over shared edges, areas by
// Heron, volumes by prisms over the plane z = 0.

#include "surface/surface_report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "cloud/samples.h"
#include "clouds.h"
#include "comparison.h"
#include "session/session.h"

namespace plateau {
namespace {

using reference::Reference;
using reference::ShownFamily;
using reference::Surface;

using Corner = std::array<long double, 3>;

struct Part {
    long vertices = 0, edges = 0, triangles = 0, euler = 0, genus = 0;
    long double area = 0, volume = 0;
};

struct Expected {
    std::vector<Part> parts;
    std::map<int, int> copies_of_vertex;                // doubled ones, by step
    std::map<std::pair<int, int>, int> copies_of_edge;  // doubled ones, by steps
};

long double distance(const Corner& a, const Corner& b) {
    return std::sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2]));
}

long double heron(const Corner& p, const Corner& q, const Corner& r) {
    std::array<long double, 3> side = {distance(p, q), distance(q, r), distance(r, p)};
    std::sort(side.begin(), side.end());
    const auto [c, b, a] = side;
    return std::sqrt(std::max(0.0L, (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c)))) / 4;
}

long double prism(const Corner& p, const Corner& q, const Corner& r) {
    const long double shadow = ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])) / 2;
    return shadow * (p[2] + q[2] + r[2]) / 3;
}

Expected from_definition(const Surface& surface, const PointCloud& cloud, const std::vector<int>& landmarks) {
    const auto corner = [&](int step, int origin) {
        Corner place{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto at = [&](int s) {
                const int landmark = landmarks[static_cast<std::size_t>(s) - 1];
                return static_cast<long double>(cloud.point(static_cast<std::uint32_t>(landmark))[axis]);
            };
            place[axis] = at(step) - at(origin);
        }
        return place;
    };
    std::map<int, std::vector<std::size_t>> rows_at_side;
    for (std::size_t row = 0; row < surface.rows.size(); ++row) {
        for (const int side : surface.sides[row]) rows_at_side[side].push_back(row);
    }
    Expected expected;
    std::vector<bool> seen(surface.rows.size());
    for (std::size_t first = 0; first < surface.rows.size(); ++first) {
        if (seen[first]) continue;
        seen[first] = true;
        Part part;
        std::set<int> vertices, sides;
        const int origin = surface.rows[first].triangle[0];
        for (std::vector<std::size_t> waiting = {first}; !waiting.empty();) {
            const std::size_t row = waiting.back();
            waiting.pop_back();
            ++part.triangles;
            vertices.insert(surface.corners[row].begin(), surface.corners[row].end());
            sides.insert(surface.sides[row].begin(), surface.sides[row].end());
            const auto& triangle = surface.rows[row].triangle;
            const Corner p = corner(triangle[0], origin);
            const Corner q = corner(triangle[1], origin);
            const Corner r = corner(triangle[2], origin);
            part.area += heron(p, q, r);
            part.volume += surface.rows[row].side == 0 ? prism(p, q, r) : -prism(p, q, r);
            for (const int side : surface.sides[row]) {
                for (const std::size_t next : rows_at_side[side]) {
                    if (seen[next]) continue;
                    seen[next] = true;
                    waiting.push_back(next);
                }
            }
        }
        part.vertices = static_cast<long>(vertices.size());
        part.edges = static_cast<long>(sides.size());
        part.euler = part.vertices - part.edges + part.triangles;
        part.genus = 1 - part.euler / 2;
        expected.parts.push_back(part);
    }

    std::map<int, std::set<int>> vertices_at;
    std::map<std::pair<int, int>, std::set<int>> sides_at;
    for (std::size_t row = 0; row < surface.rows.size(); ++row) {
        const auto& triangle = surface.rows[row].triangle;
        for (std::size_t k = 0; k < 3; ++k) {
            vertices_at[triangle[k]].insert(surface.corners[row][k]);
            const int u = triangle[k == 0 ? 1 : 0];
            const int v = triangle[k == 2 ? 1 : 2];
            sides_at[{u, v}].insert(surface.sides[row][k]);
        }
    }
    for (const auto& [step, copies] : vertices_at) {
        if (copies.size() > 1) expected.copies_of_vertex[step] = static_cast<int>(copies.size());
    }
    for (const auto& [edge, copies] : sides_at) {
        if (copies.size() > 1) expected.copies_of_edge[edge] = static_cast<int>(copies.size());
    }
    return expected;
}

/// How many steps had something doubled, and several parts.
struct Met {
    int surfaces = 0, vertices = 0, edges = 0, several = 0;
};

void expect_equal(const SurfaceReport& report, Expected expected, const std::string& where, Met& met) {
    ASSERT_EQ(report.parts.size(), expected.parts.size()) << where;
    std::sort(expected.parts.begin(), expected.parts.end(),
              [](const Part& a, const Part& b) { return a.area > b.area; });
    long double area = 0;
    long double volume = 0;
    std::multiset<std::array<long, 5>> counted, wanted;
    for (std::size_t k = 0; k < expected.parts.size(); ++k) {
        const SurfacePart& part = report.parts[k];
        const Part& want = expected.parts[k];
        EXPECT_NEAR(part.area, static_cast<double>(want.area), 1e-12 * static_cast<double>(want.area)) << where;
        const long double size = want.area * std::sqrt(want.area);
        EXPECT_LE(std::abs(static_cast<long double>(part.volume) - want.volume), 1e-12L * size) << where;
        // Parts of one area may come in either order.
        counted.insert({long{part.vertices}, long{part.edges}, long{part.triangles},
                        static_cast<long>(part.euler_characteristic), long{part.genus}});
        wanted.insert({want.vertices, want.edges, want.triangles, want.euler, want.genus});
        area += want.area;
        volume += want.volume;
    }
    EXPECT_EQ(counted, wanted) << where;
    EXPECT_LE(std::abs(report.area - area), 1e-12L * area) << where;
    EXPECT_LE(std::abs(report.volume - volume), 1e-12L * area * std::sqrt(area)) << where;

    std::map<int, int> vertices;
    for (const DoubledVertex& vertex : report.doubled_vertices) {
        vertices[static_cast<int>(vertex.landmark)] = static_cast<int>(vertex.copies);
    }
    EXPECT_EQ(vertices, expected.copies_of_vertex) << where;
    std::map<std::pair<int, int>, int> edges;
    for (const DoubledEdge& edge : report.doubled_edges) {
        edges[{static_cast<int>(edge.u), static_cast<int>(edge.v)}] = static_cast<int>(edge.copies);
    }
    EXPECT_EQ(edges, expected.copies_of_edge) << where;
    EXPECT_EQ(vertices.size(), report.doubled_vertices.size()) << where;
    EXPECT_EQ(edges.size(), report.doubled_edges.size()) << where;

    met.surfaces += expected.parts.empty() ? 0 : 1;
    met.several += expected.parts.size() > 1 ? 1 : 0;
    met.vertices += vertices.empty() ? 0 : 1;
    met.edges += edges.empty() ? 0 : 1;
}

TEST(SurfaceReport, IsThatOfTheDefinition) {
    Met met;
    for (const char* name :
         {"touching_at_vertex", "touching_at_edge", "two_spheres", "torus_with_disk_dense", "helix_dense", "grid_tenth",
          "nested_octahedra", "octahedron", "cube_with_center", "grid", "lattice_shell", "slab", "coplanar_skew",
          "sphere", "torus_large", "tiny_sphere", "huge_torus", "far_away", "four_points"}) {
        const TestCloud cloud = test_cloud(name);
        Reference expected(cloud.cloud, 0, cloud.max_steps);
        RunOptions options;
        options.family = Family::Surface;
        options.max_steps = static_cast<std::uint32_t>(cloud.max_steps);
        Session session = Session::open(cloud.cloud, options).value();
        session.run({});
        const int steps = expected.step_count();
        ASSERT_EQ(static_cast<int>(session.timeline().step_count), steps) << name;
        for (int step = 1; step <= steps; step += steps > 60 ? steps / 20 : 1) {
            const reference::Settings settings{ShownFamily::Surface, {1, 6, 6, 4}};
            const Surface surface = expected.state(settings, step).surface;
            const SurfaceReport report = surface_report(session.cloud(), session.timeline(), static_cast<Step>(step));
            expect_equal(report, from_definition(surface, cloud.cloud, expected.order().landmarks),
                         std::string(name) + ", step " + std::to_string(step), met);
        }
    }
    EXPECT_GT(met.surfaces, 30);
    EXPECT_GT(met.several, 3);
    EXPECT_GT(met.vertices, 10);
    EXPECT_GT(met.edges, 10);
}

TEST(SurfaceReport, OfATorusIsThatOfATorus) {
    Session session = Session::open(sample_shape("torus", {.size = 3000}).value(), {}).value();
    session.run({});
    const auto plateaus = session.plateaus();
    const Step step = middle_step(session.timeline(), plateaus[ranked(plateaus).front()]);
    const SurfaceReport report = surface_report(session.cloud(), session.timeline(), step);
    ASSERT_EQ(report.parts.size(), 1u);
    EXPECT_EQ(report.parts[0].genus, 1u);
    EXPECT_EQ(report.parts[0].euler_characteristic, 0);
    EXPECT_NEAR(report.area, 15.79, 1.5);    // 4 pi^2 R r, from within
    EXPECT_NEAR(report.volume, 3.158, 0.6);  // 2 pi^2 R r^2
    EXPECT_TRUE(report.doubled_vertices.empty());
}

}  // namespace
}  // namespace plateau
