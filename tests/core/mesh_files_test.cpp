// Meshes as OFF, read by CGAL; the rules of their names. PLY is read in io_writers_test, GLB by the module's tests.

#include "io/mesh_files.h"

#include <CGAL/IO/OFF.h>
#include <CGAL/Simple_cartesian.h>
#include <gtest/gtest.h>

#include <sstream>
#include <vector>

#include "cloud/samples.h"
#include "io/step_mesh.h"

namespace plateau {
namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;

Session finished(const char* shape, std::uint32_t size, const RunOptions& options = {}) {
    Session session = Session::open(sample_shape(shape, {.size = size}).value(), options).value();
    session.run({});
    return session;
}

void expect_read_by_cgal(const Session& session, Step step) {
    const StepMesh mesh = step_mesh(session, step);
    std::istringstream text(mesh_off(session, step));
    std::vector<Point> points;
    std::vector<std::vector<std::size_t>> faces;
    ASSERT_TRUE(CGAL::IO::read_OFF(text, points, faces)) << "step " << step;
    ASSERT_EQ(points.size(), mesh.vertex_landmark.size());
    for (std::size_t vertex = 0; vertex < points.size(); ++vertex) {
        const std::uint32_t landmark = session.timeline().landmarks[mesh.vertex_landmark[vertex] - 1];
        const auto point = session.cloud().point(landmark);
        EXPECT_EQ(points[vertex], Point(point[0], point[1], point.size() > 2 ? point[2] : 0));
    }
    std::vector<std::vector<std::size_t>> expected;
    for (const auto& edge : mesh.edges) expected.emplace_back(edge.begin(), edge.end());
    for (const auto& triangle : mesh.triangles) expected.emplace_back(triangle.begin(), triangle.end());
    EXPECT_EQ(faces, expected);
}

TEST(MeshFiles, OffIsReadByCgal) {
    const Session torus = finished("torus", 400);
    EXPECT_TRUE(step_mesh(torus, 60).is_surface);
    EXPECT_FALSE(step_mesh(torus, 10).is_surface);
    for (const Step step : {1u, 2u, 10u, 60u, 200u, 400u}) expect_read_by_cgal(torus, step);
    const Session plane = finished("circle-noise", 150);
    for (const Step step : {1u, 9u, 150u}) expect_read_by_cgal(plane, step);
}

TEST(MeshFiles, TheEndingNamesTheFormat) {
    EXPECT_EQ(mesh_format_of("a.ply"), MeshFormat::Ply);
    EXPECT_EQ(mesh_format_of("a.b/c.OFF"), MeshFormat::Off);
    EXPECT_EQ(mesh_format_of("a.ply.glb"), MeshFormat::Glb);
    EXPECT_EQ(mesh_format_of("-"), MeshFormat::Ply);
    EXPECT_EQ(mesh_format_of("/dev/stdout"), MeshFormat::Ply);
    EXPECT_EQ(mesh_format_of("./mesh"), MeshFormat::Ply);
    EXPECT_EQ(mesh_format_of("a.obj"), std::nullopt);
    EXPECT_EQ(mesh_format_of("a."), std::nullopt);
    const Session session = finished("torus", 100);
    EXPECT_EQ(mesh_file(session, MeshFormat::Ply, 50u), mesh_ply(session, 50u));
    EXPECT_EQ(mesh_file(session, MeshFormat::Off, 50u), mesh_off(session, 50u));
    EXPECT_EQ(mesh_file(session, MeshFormat::Glb, 50u), mesh_glb(session, 50u));
}

TEST(MeshFiles, NothingIsWrittenWell) {
    const Session session = Session::open(sample_shape("torus", {.size = 100}).value(), {}).value();
    EXPECT_EQ(mesh_off(session, std::nullopt), "OFF\n0 0 0\n");
    EXPECT_EQ(mesh_glb(session, std::nullopt).substr(0, 4), "glTF");
}

}  // namespace
}  // namespace plateau
