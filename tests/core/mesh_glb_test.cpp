// Binary glTF: the frame of the file and where its positions lie. The module's tests hand the same bytes to the
// validator of Khronos and to three.js.

#include <gtest/gtest.h>

#include <boost/property_tree/json_parser.hpp>
#include <cmath>
#include <cstring>
#include <sstream>
#include <vector>

#include "cloud/samples.h"
#include "clouds.h"
#include "io/mesh_files.h"
#include "io/step_mesh.h"

namespace plateau {
namespace {

using Tree = boost::property_tree::ptree;

std::uint32_t word(const std::string& bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t k = 4; k-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
    return value;
}

struct Glb {
    Tree json;
    std::string numbers;
};

Glb read_glb(const std::string& bytes) {
    Glb glb;
    EXPECT_EQ(bytes.substr(0, 4), "glTF");
    EXPECT_EQ(word(bytes, 4), 2u);
    EXPECT_EQ(word(bytes, 8), bytes.size());
    const std::uint32_t length = word(bytes, 12);
    EXPECT_EQ(bytes.substr(16, 4), "JSON");
    EXPECT_EQ(length % 4, 0u);
    std::istringstream text(bytes.substr(20, length));
    boost::property_tree::read_json(text, glb.json);
    const std::size_t next = 20 + length;
    if (next == bytes.size()) return glb;
    EXPECT_EQ(word(bytes, next) % 4, 0u);
    EXPECT_EQ(bytes.substr(next + 4, 4), std::string("BIN\0", 4));
    glb.numbers = bytes.substr(next + 8);
    EXPECT_EQ(glb.numbers.size(), word(bytes, next));
    return glb;
}

std::vector<double> numbers_at(const Tree& tree, const char* path) {
    std::vector<double> numbers;
    for (const auto& [key, value] : tree.get_child(path)) numbers.push_back(value.get_value<double>());
    return numbers;
}

void expect_positions(const Session& session, Step step) {
    const StepMesh mesh = step_mesh(session, step);
    const Glb glb = read_glb(mesh_glb(session, step));
    const Tree& node = glb.json.get_child("nodes").front().second;
    const auto center = numbers_at(node, "translation");
    const auto scale = numbers_at(node, "scale");
    const Tree& accessor = glb.json.get_child("accessors").front().second;
    ASSERT_EQ(accessor.get<std::size_t>("count"), mesh.vertex_landmark.size());
    const auto low = numbers_at(accessor, "min");
    const auto high = numbers_at(accessor, "max");
    int exponent = 0;
    EXPECT_EQ(std::frexp(scale[0], &exponent), 0.5) << "a power of two";
    double reach = 0;
    for (std::size_t vertex = 0; vertex < mesh.vertex_landmark.size(); ++vertex) {
        const auto position = vertex_position(session, mesh, vertex);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::uint32_t bits = word(glb.numbers, 12 * vertex + 4 * axis);
            float place = 0;
            std::memcpy(&place, &bits, sizeof place);
            EXPECT_GE(place, low[axis]);
            EXPECT_LE(place, high[axis]);
            reach = std::max(reach, std::abs(double{place}));
            const double rounding = 0x1p-24 * scale[axis] + 0x1p-51 * std::abs(position[axis]);
            EXPECT_LE(std::abs(center[axis] + scale[axis] * double{place} - position[axis]), rounding);
        }
    }
    if (mesh.vertex_landmark.size() > 1) {
        EXPECT_GE(reach, 0.5) << "no digit is wasted";
        EXPECT_LE(reach, 1);
    }
}

TEST(MeshGlb, PositionsAreThoseOfTheLandmarks) {
    for (const char* name :
         {"torus", "far_away", "huge_torus", "tiny_sphere", "plane_huge", "plane_tiny", "one_point"}) {
        SCOPED_TRACE(name);
        Session session = Session::open(test_cloud(name).cloud, {}).value();
        session.run({});
        const Step steps = session.timeline().step_count;
        for (Step step = 1; step <= steps; step += steps / 5 + 1) expect_positions(session, step);
    }
}

TEST(MeshGlb, PrimitivesAreThoseOfTheShape) {
    Session session = Session::open(sample_shape("torus", {.size = 300}).value(), {}).value();
    session.run({});
    const auto primitives = [&](Step step) {
        const Glb glb = read_glb(mesh_glb(session, step));
        std::vector<int> modes;
        for (const auto& [key, primitive] : glb.json.get_child("meshes").front().second.get_child("primitives")) {
            modes.push_back(primitive.get<int>("mode"));
        }
        return modes;
    };
    ASSERT_TRUE(step_mesh(session, 80).is_surface);
    EXPECT_EQ(primitives(80), std::vector<int>{4});
    EXPECT_EQ(primitives(1), std::vector<int>{0});
    EXPECT_EQ(primitives(2), (std::vector<int>{0, 1}));
    ASSERT_FALSE(step_mesh(session, 12).triangles.empty());
    EXPECT_EQ(primitives(12), (std::vector<int>{0, 1, 4}));
}

TEST(MeshGlb, AnEmptySurfaceIsAnEmptyScene) {
    RunOptions options;
    options.family = Family::Surface;
    Session session = Session::open(test_cloud("four_points").cloud, options).value();
    session.run({});
    const Glb glb = read_glb(mesh_glb(session, 1));
    EXPECT_EQ(glb.json.get_child("scenes").size(), 1u);
    EXPECT_EQ(glb.json.count("nodes"), 0u);
    EXPECT_EQ(glb.numbers, "");
}

}  // namespace
}  // namespace plateau
