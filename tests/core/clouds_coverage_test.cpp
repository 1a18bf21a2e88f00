// The test clouds are worth their time only if what could go wrong happens in them: each rare event is asked for here.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "clouds.h"
#include "reference/run.h"

namespace plateau::reference {
namespace {

TEST(Clouds, AreManyAndNamedOnce) {
    std::set<std::string> names;
    for (const TestCloud& cloud : test_clouds()) EXPECT_TRUE(names.insert(cloud.name).second) << cloud.name;
    EXPECT_GE(names.size(), 34u);
}

/// How often something happens in the surfaces of a run.
struct Events {
    int doubled_vertices = 0;
    int doubled_edges = 0;         ///< two mesh edges between the same landmarks
    int edges_with_same_ends = 0;  ///< even between the same mesh vertices
    int two_sided_facets = 0;
    int hidden_triangles = 0;  ///< kept, but inside
    int returns = 0;           ///< a row that comes back after a pause
    int several_components = 0;
    int handles = 0;
};

Events events_of(const std::string& name) {
    const TestCloud cloud = test_cloud(name);
    Reference reference(cloud.cloud, 0, cloud.max_steps);
    Events events;
    std::map<Row, int> last_seen;
    const int stride = reference.step_count() <= 60 ? 1 : 5;
    for (int step = stride; step <= reference.step_count(); step += stride) {
        const StepState state = reference.state({ShownFamily::Surface, {1, 6, 6, 4}}, step);
        const Surface& surface = state.surface;
        if (surface.rows.empty()) continue;
        EXPECT_EQ(surface.betti(), surface.betti_by_elimination()) << name << ", step " << step;
        std::set<int> landmarks;
        std::set<Simplex> triangles;
        std::map<Simplex, std::set<int>> edges_of_landmarks, edges_of_vertices;
        for (std::size_t r = 0; r < surface.rows.size(); ++r) {
            const Row& row = surface.rows[r];
            landmarks.insert(row.triangle.begin(), row.triangle.end());
            events.two_sided_facets += !triangles.insert(row.triangle).second;
            for (std::size_t k = 0; k < 3; ++k) {
                Simplex ends = {surface.corners[r][(k + 1) % 3], surface.corners[r][(k + 2) % 3]};
                std::sort(ends.begin(), ends.end());
                edges_of_vertices[ends].insert(surface.sides[r][k]);
                edges_of_landmarks[facets(row.triangle)[k]].insert(surface.sides[r][k]);
            }
            const auto seen = last_seen.find(row);
            events.returns += seen != last_seen.end() && seen->second < step - stride;
            last_seen[row] = step;
        }
        const auto several = [](const auto& entry) { return entry.second.size() > 1; };
        const auto& by_landmarks = edges_of_landmarks;
        const auto& by_vertices = edges_of_vertices;
        events.doubled_vertices += surface.vertex_count - static_cast<int>(landmarks.size());
        events.doubled_edges += static_cast<int>(std::count_if(by_landmarks.begin(), by_landmarks.end(), several));
        events.edges_with_same_ends += static_cast<int>(std::count_if(by_vertices.begin(), by_vertices.end(), several));
        const auto kept = without_sharp_edges(state.tracks[0][2], reference.points(), 0);
        events.hidden_triangles += static_cast<int>(kept.size() - triangles.size());
        events.several_components += surface.component_count > 1;
        events.handles += surface.betti()[1] > 0;
    }
    return events;
}

TEST(Clouds, TouchingBodiesDoubleVertices) {
    const Events events = events_of("touching_at_vertex");
    EXPECT_GT(events.doubled_vertices, 0);
    EXPECT_GT(events.several_components, 0);
}

TEST(Clouds, GridsDoubleEdgesEvenBetweenTheSameVertices) {
    const Events events = events_of("grid_tenth");
    EXPECT_GT(events.doubled_edges, 0);
    EXPECT_GT(events.edges_with_same_ends, 0);
    EXPECT_GT(events.returns, 0);
}

TEST(Clouds, TorusHasAHandle) {
    EXPECT_GT(events_of("torus_dense").handles, 0);
}

TEST(Clouds, DiskAcrossTheHoleHasTwoOuterSides) {
    EXPECT_GT(events_of("torus_with_disk_dense").two_sided_facets, 0);
}

TEST(Clouds, ShellsHideTheInnerOne) {
    EXPECT_GT(events_of("shells_large").hidden_triangles, 0);
}

TEST(Clouds, AutoChangesItsMindOnTheHelix) {
    const TestCloud cloud = test_cloud("helix_dense");
    Reference reference(cloud.cloud, 0, cloud.max_steps);
    std::set<ShownFamily> shown;
    for (int step = 10; step <= reference.step_count(); step += 10) {
        shown.insert(reference.state({ShownFamily::Auto, {1, 6, 6, 4}}, step).shown);
    }
    EXPECT_EQ(shown, (std::set{ShownFamily::Delaunay, ShownFamily::Surface}));
}

TEST(Clouds, SomeRiseInDimensionLate) {
    for (const char* name : {"rising_from_plane", "rising_from_skew_plane", "rising_twice", "plane_rising"}) {
        Reference reference(test_cloud(name).cloud);
        const int last = reference.step_count();
        EXPECT_GT(reference.triangulation(last).dimension, reference.triangulation(last / 2).dimension) << name;
    }
}

TEST(Clouds, SomeSpheresAreTied) {
    for (const char* name : {"plane_cocircular", "plane_grid_tenth", "grid", "cospherical_9"}) {
        Reference reference(test_cloud(name).cloud);
        EXPECT_FALSE(empty_spheres(reference.points(), 12).tied.empty()) << name;
    }
}

}  // namespace
}  // namespace plateau::reference
