#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "io/binary_text.h"
#include "io/exact_text.h"
#include "io/family_name.h"
#include "io/mesh_files.h"
#include "io/step_mesh.h"

namespace plateau {
namespace {

using Position = std::array<double, 3>;

/// Numbers of the specification.
constexpr int kPoints = 0;
constexpr int kLines = 1;
constexpr int kTriangles = 4;
constexpr int kFloat = 5126;
constexpr int kUnsignedInt = 5125;
constexpr int kVertexBuffer = 34962;
constexpr int kIndexBuffer = 34963;

/// Where the positions of the file lie: p = center + scale * q.
struct Placement {
    Position center{};
    double scale = 1;
};

Placement placement_of(const std::vector<Position>& points) {
    Placement placement;
    double reach = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        double low = points.front()[axis];
        double high = low;
        for (const Position& point : points) {
            low = std::min(low, point[axis]);
            high = std::max(high, point[axis]);
        }
        placement.center[axis] = low / 2 + high / 2;
        reach = std::max({reach, high - placement.center[axis], placement.center[axis] - low});
    }
    // A power of two rounds nothing.
    int exponent = 0;
    if (reach > 0) std::frexp(reach, &exponent);
    placement.scale = std::ldexp(1, exponent);
    return placement;
}

/// Buffer, views and accessors grow together; an accessor is named by its place.
class Parts {
public:
    int add_vectors(const std::vector<std::array<float, 3>>& vectors, bool with_bounds) {
        std::string fields = ",\"type\":\"VEC3\",\"componentType\":" + std::to_string(kFloat);
        if (with_bounds) fields += bounds(vectors);
        const std::size_t begin = bytes_.size();
        for (const auto& vector : vectors) {
            for (const float value : vector) append_f32(bytes_, value, ByteOrder::LittleEndian);
        }
        return add(begin, vectors.size(), kVertexBuffer, fields);
    }

    template <std::size_t Corners>
    int add_indices(const std::vector<std::array<std::uint32_t, Corners>>& simplices) {
        const std::size_t begin = bytes_.size();
        for (const auto& simplex : simplices) {
            for (const std::uint32_t vertex : simplex) append_u32(bytes_, vertex, ByteOrder::LittleEndian);
        }
        return add(begin, simplices.size() * Corners, kIndexBuffer,
                   ",\"type\":\"SCALAR\",\"componentType\":" + std::to_string(kUnsignedInt));
    }

    const std::string& bytes() const { return bytes_; }
    std::string json() const {
        return "\"buffers\":[{\"byteLength\":" + std::to_string(bytes_.size()) + "}],\"bufferViews\":[" + views_ +
               "],\"accessors\":[" + accessors_ + "]";
    }

private:
    // Every number takes four bytes, so that all views are aligned.
    int add(std::size_t begin, std::size_t count, int target, const std::string& fields) {
        const std::string separator = count_ > 0 ? "," : "";
        views_ += separator + "{\"buffer\":0,\"byteOffset\":" + std::to_string(begin) +
                  ",\"byteLength\":" + std::to_string(bytes_.size() - begin) + ",\"target\":" + std::to_string(target) +
                  "}";
        accessors_ += separator + "{\"bufferView\":" + std::to_string(count_) + ",\"count\":" + std::to_string(count) +
                      fields + "}";
        return count_++;
    }

    static std::string bounds(const std::vector<std::array<float, 3>>& vectors) {
        std::string low_text;
        std::string high_text;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto less = [axis](const auto& a, const auto& b) { return a[axis] < b[axis]; };
            const auto [low, high] = std::minmax_element(vectors.begin(), vectors.end(), less);
            const char* separator = axis > 0 ? "," : "";
            low_text += separator + exact(double{(*low)[axis]});
            high_text += separator + exact(double{(*high)[axis]});
        }
        return ",\"min\":[" + low_text + "],\"max\":[" + high_text + "]";
    }

    std::string bytes_;
    std::string views_;
    std::string accessors_;
    int count_ = 0;
};

Position cross(const Position& a, const Position& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

std::array<float, 3> unit(const Position& v) {
    const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    // What has no direction must have one in the file all the same.
    if (!(length > 0)) return {0, 0, 1};
    return {static_cast<float>(v[0] / length), static_cast<float>(v[1] / length), static_cast<float>(v[2] / length)};
}

/// The sum of the triangles around each vertex, weighted by area.
std::vector<std::array<float, 3>> normals_of(const StepMesh& mesh, const std::vector<std::array<float, 3>>& places) {
    std::vector<Position> sums(places.size());
    for (const auto& triangle : mesh.triangles) {
        const auto& a = places[triangle[0]];
        const auto from_a = [&](const std::array<float, 3>& b) {
            return Position{double{b[0]} - double{a[0]}, double{b[1]} - double{a[1]}, double{b[2]} - double{a[2]}};
        };
        const Position area = cross(from_a(places[triangle[1]]), from_a(places[triangle[2]]));
        for (const std::uint32_t vertex : triangle) {
            for (std::size_t axis = 0; axis < 3; ++axis) sums[vertex][axis] += area[axis];
        }
    }
    std::vector<std::array<float, 3>> normals;
    normals.reserve(sums.size());
    for (const Position& sum : sums) normals.push_back(unit(sum));
    return normals;
}

std::string primitive(int mode, const std::string& attributes, int indices) {
    std::string text = "{\"attributes\":{" + attributes + "},\"mode\":" + std::to_string(mode) + ",\"material\":0";
    if (indices >= 0) text += ",\"indices\":" + std::to_string(indices);
    return text + "}";
}

std::string extras(const Session& session, Step step) {
    const Timeline& timeline = session.timeline();
    return "\"extras\":{\"step\":" + std::to_string(step) + ",\"epsilon\":" + exact(timeline.epsilon(step)) +
           ",\"family\":\"" + std::string(family_name(timeline.shown_family[step - 1])) + "\",\"betti\":[" +
           joined(timeline.betti_at(step), ",") + "]}";
}

/// Header, a chunk of JSON and one of numbers, each filled up to four bytes.
std::string container(std::string json, std::string numbers) {
    while (json.size() % 4 != 0) json += ' ';
    while (numbers.size() % 4 != 0) numbers += '\0';
    constexpr std::size_t kHeader = 12;
    constexpr std::size_t kChunkHeader = 8;
    std::size_t length = kHeader + kChunkHeader + json.size();
    if (!numbers.empty()) length += kChunkHeader + numbers.size();
    std::string bytes = "glTF";
    append_u32(bytes, 2, ByteOrder::LittleEndian);
    append_u32(bytes, static_cast<std::uint32_t>(length), ByteOrder::LittleEndian);
    append_u32(bytes, static_cast<std::uint32_t>(json.size()), ByteOrder::LittleEndian);
    bytes += "JSON" + json;
    if (!numbers.empty()) {
        append_u32(bytes, static_cast<std::uint32_t>(numbers.size()), ByteOrder::LittleEndian);
        bytes += std::string("BIN\0", 4) + numbers;
    }
    return bytes;
}

}  // namespace

std::string mesh_glb(const Session& session, std::optional<Step> step) {
    const StepMesh mesh = step_mesh(session, step);
    const std::string head = "{\"asset\":{\"version\":\"2.0\",\"generator\":\"Plateau\"},\"scene\":0,\"scenes\":[";
    // The format knows no mesh without vertices.
    if (mesh.vertex_landmark.empty()) return container(head + "{}]}", "");

    std::vector<Position> points;
    for (std::size_t vertex = 0; vertex < mesh.vertex_landmark.size(); ++vertex) {
        points.push_back(vertex_position(session, mesh, vertex));
    }
    const Placement placement = placement_of(points);
    std::vector<std::array<float, 3>> places;
    for (const Position& point : points) {
        std::array<float, 3> place{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            place[axis] = static_cast<float>((point[axis] - placement.center[axis]) / placement.scale);
        }
        places.push_back(place);
    }

    Parts parts;
    std::string attributes = "\"POSITION\":" + std::to_string(parts.add_vectors(places, true));
    std::string primitives;
    const auto add = [&](int mode, int indices) {
        if (!primitives.empty()) primitives += ',';
        primitives += primitive(mode, attributes, indices);
    };
    if (mesh.is_surface) {
        attributes += ",\"NORMAL\":" + std::to_string(parts.add_vectors(normals_of(mesh, places), false));
    } else {
        add(kPoints, -1);
        if (!mesh.edges.empty()) add(kLines, parts.add_indices(mesh.edges));
    }
    if (!mesh.triangles.empty()) add(kTriangles, parts.add_indices(mesh.triangles));

    const auto& [x, y, z] = placement.center;
    const std::string scale = exact(placement.scale);
    std::string json = head + "{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0,\"translation\":[" + exact(x) + "," + exact(y) +
                       "," + exact(z) + "],\"scale\":[" + scale + "," + scale + "," + scale + "]," +
                       extras(session, mesh.step) + "}],\"meshes\":[{\"primitives\":[" + primitives +
                       "]}],\"materials\":[{\"doubleSided\":true,\"pbrMetallicRoughness\":{\"metallicFactor\":0," +
                       "\"roughnessFactor\":0.75}}]," + parts.json() + "}";
    return container(std::move(json), parts.bytes());
}

}  // namespace plateau
