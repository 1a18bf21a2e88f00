#include "surface/surface_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "surface/surface_mesh.h"

namespace plateau {

namespace {

using Vector = std::array<double, 3>;
using Triangle = std::array<std::uint32_t, 3>;

Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Triangles that share a vertex of the mesh are glued: its copies are apart already.
std::vector<std::uint32_t> part_of_vertex(const SurfaceMesh& mesh) {
    std::vector<std::uint32_t> parent(mesh.vertex_landmark.size());
    std::iota(parent.begin(), parent.end(), 0u);
    const auto find = [&](std::uint32_t vertex) {
        while (parent[vertex] != vertex) vertex = parent[vertex] = parent[parent[vertex]];
        return vertex;
    };
    for (const Triangle& triangle : mesh.triangles) {
        parent[find(triangle[1])] = find(triangle[0]);
        parent[find(triangle[2])] = find(triangle[0]);
    }
    std::vector<std::uint32_t> part(parent.size());
    constexpr std::uint32_t kUnnumbered = 0xFFFFFFFFu;
    std::vector<std::uint32_t> number(parent.size(), kUnnumbered);
    std::uint32_t count = 0;
    for (std::uint32_t vertex = 0; vertex < parent.size(); ++vertex) {
        std::uint32_t& root = number[find(vertex)];
        if (root == kUnnumbered) root = count++;
        part[vertex] = root;
    }
    return part;
}

// Corners relative to the first vertex of the part and to the size of the mesh, so that neither a cloud far from the
// origin nor a tiny or huge one loses digits.
class Measure {
public:
    Measure(const PointCloud& cloud, const Timeline& timeline, const SurfaceMesh& mesh)
        : cloud_(&cloud), timeline_(&timeline), mesh_(&mesh) {
        double reach = 0;
        for (std::uint32_t vertex = 0; vertex < mesh.vertex_landmark.size(); ++vertex) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                reach = std::max(reach, std::abs(point(vertex)[axis] - point(0)[axis]));
            }
        }
        int exponent = 0;
        if (reach > 0) std::frexp(reach, &exponent);
        scale_ = std::ldexp(1, exponent);
    }

    Vector relative(std::uint32_t vertex, std::uint32_t origin) const {
        const auto to = point(vertex);
        const auto from = point(origin);
        return {(to[0] - from[0]) / scale_, (to[1] - from[1]) / scale_, (to[2] - from[2]) / scale_};
    }
    double scale() const { return scale_; }

private:
    std::span<const double> point(std::uint32_t vertex) const {
        return cloud_->point(timeline_->landmarks[mesh_->vertex_landmark[vertex] - 1]);
    }

    const PointCloud* cloud_;
    const Timeline* timeline_;
    const SurfaceMesh* mesh_;
    double scale_ = 1;
};

std::vector<SurfacePart> parts_of(const SurfaceMesh& mesh, const Measure& measure) {
    const std::vector<std::uint32_t> part_of = part_of_vertex(mesh);
    std::vector<SurfacePart> parts;
    std::vector<std::uint32_t> origin;  // first vertex of each part
    for (std::uint32_t vertex = 0; vertex < part_of.size(); ++vertex) {
        if (part_of[vertex] == parts.size()) {
            parts.emplace_back();
            origin.push_back(vertex);
        }
        ++parts[part_of[vertex]].vertices;
    }
    for (const Triangle& triangle : mesh.triangles) {
        const std::uint32_t number = part_of[triangle[0]];
        SurfacePart& part = parts[number];
        ++part.triangles;
        const Vector a = measure.relative(triangle[0], origin[number]);
        const Vector b = measure.relative(triangle[1], origin[number]);
        const Vector c = measure.relative(triangle[2], origin[number]);
        const Vector span =
            cross(measure.relative(triangle[1], triangle[0]), measure.relative(triangle[2], triangle[0]));
        part.area += std::sqrt(dot(span, span)) / 2;
        part.volume += dot(a, cross(b, c)) / 6;
    }
    const double scale = measure.scale();
    for (SurfacePart& part : parts) {
        part.edges = part.triangles / 2 * 3;
        part.euler_characteristic = std::int64_t{part.vertices} - part.edges + part.triangles;
        part.genus = static_cast<std::uint32_t>((2 - part.euler_characteristic) / 2);
        part.area = part.area * scale * scale;
        part.volume = part.volume * scale * scale * scale;
    }
    std::stable_sort(parts.begin(), parts.end(),
                     [](const SurfacePart& a, const SurfacePart& b) { return a.area > b.area; });
    return parts;
}

std::vector<DoubledVertex> doubled_vertices(const SurfaceMesh& mesh) {
    std::vector<Step> landmarks = mesh.vertex_landmark;
    std::sort(landmarks.begin(), landmarks.end());
    std::vector<DoubledVertex> doubled;
    for (std::size_t begin = 0, end = 0; begin < landmarks.size(); begin = end) {
        while (end < landmarks.size() && landmarks[end] == landmarks[begin]) ++end;
        if (end - begin > 1) doubled.push_back({landmarks[begin], static_cast<std::uint32_t>(end - begin)});
    }
    return doubled;
}

// An edge of the surface has two triangles, so four at one place are two edges.
std::vector<DoubledEdge> doubled_edges(const SurfaceMesh& mesh) {
    std::vector<std::pair<Step, Step>> sides;
    for (const Triangle& triangle : mesh.triangles) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const Step a = mesh.vertex_landmark[triangle[corner]];
            const Step b = mesh.vertex_landmark[triangle[(corner + 1) % 3]];
            sides.push_back(std::minmax(a, b));
        }
    }
    std::sort(sides.begin(), sides.end());
    std::vector<DoubledEdge> doubled;
    for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
        while (end < sides.size() && sides[end] == sides[begin]) ++end;
        const auto copies = static_cast<std::uint32_t>((end - begin) / 2);
        if (copies > 1) doubled.push_back({sides[begin].first, sides[begin].second, copies});
    }
    return doubled;
}

}  // namespace

SurfaceReport surface_report(const PointCloud& cloud, const Timeline& timeline, Step step) {
    const SurfaceMesh mesh = surface_mesh(cloud, timeline, step);
    SurfaceReport report;
    report.parts = parts_of(mesh, Measure(cloud, timeline, mesh));
    report.doubled_vertices = doubled_vertices(mesh);
    report.doubled_edges = doubled_edges(mesh);
    for (const SurfacePart& part : report.parts) {
        report.area += part.area;
        report.volume += part.volume;
    }
    return report;
}

}  // namespace plateau
