#include "reference/delaunay.h"

#include <algorithm>
#include <cstdint>

namespace plateau::reference {
namespace {

std::vector<LabeledPoint> labeled_points(const PointCloud& cloud, const std::vector<int>& landmarks, int step) {
    std::vector<LabeledPoint> points;
    for (int s = 1; s <= step; ++s) {
        LabeledPoint point{{0, 0, 0}, s};
        const auto row = static_cast<std::size_t>(landmarks[static_cast<std::size_t>(s - 1)]) * cloud.dimension;
        for (std::size_t axis = 0; axis < cloud.dimension; ++axis) {
            point.position[axis] = cloud.coordinates[row + axis];
        }
        points.push_back(point);
    }
    return points;
}

void shuffle(std::vector<LabeledPoint>& points, std::uint64_t seed) {
    for (std::size_t left = points.size(); left > 1; --left) {
        seed = seed * 6364136223846793005u + 1442695040888963407u;
        std::swap(points[left - 1], points[(seed >> 33) % left]);
    }
}

}  // namespace

Triangulation delaunay(const PointCloud& cloud, const std::vector<int>& landmarks, int step, InsertionOrder order) {
    std::vector<LabeledPoint> points = labeled_points(cloud, landmarks, step);
    switch (order) {
        case InsertionOrder::Reversed:
            std::reverse(points.begin(), points.end());
            break;
        case InsertionOrder::Lexicographic:
            std::sort(points.begin(), points.end(),
                      [](const LabeledPoint& a, const LabeledPoint& b) { return a.position < b.position; });
            break;
        case InsertionOrder::Shuffled:
            shuffle(points, static_cast<std::uint64_t>(step));
            break;
    }
    return triangulate_space(points);
}

Triangulation delaunay_in_plane(const PointCloud& cloud, const std::vector<int>& landmarks, int step) {
    std::vector<LabeledPoint> points = labeled_points(cloud, landmarks, step);
    shuffle(points, static_cast<std::uint64_t>(step) + 1000);
    return triangulate_plane(points);
}

EmptySpheres empty_spheres(const ExactPoints& points, int step) {
    EmptySpheres result;
    result.dimension = affine_dimension(points, step);
    Simplex all;
    for (int s = 1; s <= step; ++s) all.push_back(s);
    for (const Simplex& simplex : subsets(all, result.dimension + 1)) {
        const Circumsphere sphere(points, simplex);
        if (sphere.degenerate()) continue;
        int lowest = 1;
        for (int q = 1; q <= step && lowest >= 0; ++q) {
            if (!std::binary_search(simplex.begin(), simplex.end(), q)) lowest = std::min(lowest, sphere.side(q));
        }
        if (lowest > 0) result.empty.insert(simplex);
        if (lowest == 0) result.tied.insert(simplex);
    }
    return result;
}

std::string complaint_about(const Triangulation& triangulation, const EmptySpheres& spheres) {
    if (triangulation.dimension != spheres.dimension) return "wrong dimension";
    for (const Simplex& simplex : spheres.empty) {
        if (triangulation.cells.count(simplex) == 0) return "missing: " + print(simplex);
    }
    for (const Simplex& cell : triangulation.cells) {
        if (spheres.empty.count(cell) + spheres.tied.count(cell) == 0) return "not empty: " + print(cell);
    }
    return "";
}

std::string complaint_about_cells(const Triangulation& triangulation, const ExactPoints& points, int step) {
    for (const Simplex& cell : triangulation.cells) {
        const Circumsphere sphere(points, cell);
        if (sphere.degenerate()) return "flat: " + print(cell);
        for (int q = 1; q <= step; ++q) {
            if (sphere.side(q) < 0) return "not empty: " + print(cell);
        }
    }
    return "";
}

std::string print(const Simplex& simplex) {
    std::string text = "[";
    for (const int vertex : simplex) text += (text.size() > 1 ? " " : "") + std::to_string(vertex);
    return text + "]";
}

}  // namespace plateau::reference
