#include "plane/plane_cells.h"

#include <algorithm>
#include <span>

namespace plateau {

namespace {

using Point = std::array<double, 2>;
using Polygon = std::vector<Point>;
/// [landmark] = those that it shares an edge of D(L) with, ascending.
using Neighbors = std::vector<std::vector<Step>>;

Neighbors neighbors_of(const PlaneComplex& complex) {
    Neighbors neighbors(complex.landmark_count() + std::size_t{1});
    for (const auto& [a, b] : complex.delaunay_edges()) {
        neighbors[a].push_back(b);
        neighbors[b].push_back(a);
    }
    for (auto& list : neighbors) std::sort(list.begin(), list.end());
    return neighbors;
}

/// What remains of a convex polygon where p is no farther than q.
void cut(Polygon& polygon, std::span<const double> p, std::span<const double> q) {
    const Point normal = {q[0] - p[0], q[1] - p[1]};
    const Point middle = {p[0] + normal[0] / 2, p[1] + normal[1] / 2};
    const auto beyond = [&](const Point& corner) {
        return (corner[0] - middle[0]) * normal[0] + (corner[1] - middle[1]) * normal[1];
    };
    Polygon rest;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point& from = polygon[i];
        const Point& to = polygon[(i + 1) % polygon.size()];
        const double a = beyond(from);
        const double b = beyond(to);
        if (a <= 0) rest.push_back(from);
        if ((a < 0 && b > 0) || (a > 0 && b < 0)) {
            const double part = a / (a - b);
            rest.push_back({from[0] + part * (to[0] - from[0]), from[1] + part * (to[1] - from[1])});
        }
    }
    if (rest.size() < 3) rest.clear();
    polygon.swap(rest);
}

Polygon whole(const PlaneBox& box) {
    return {{box.left, box.bottom}, {box.right, box.bottom}, {box.right, box.top}, {box.left, box.top}};
}

void append(PlanePolygons& polygons, const Polygon& polygon) {
    for (const Point& corner : polygon) polygons.corners.insert(polygons.corners.end(), corner.begin(), corner.end());
    polygons.first_corner.push_back(static_cast<std::uint32_t>(polygons.corners.size() / 2));
}

}  // namespace

PlanePolygons voronoi_cells(const PlaneScene& scene, const PlaneComplex& complex, const PlaneBox& box) {
    const Neighbors neighbors = neighbors_of(complex);
    PlanePolygons cells;
    for (Step p = 1; p <= complex.landmark_count(); ++p) {
        Polygon cell = whole(box);
        for (const Step q : neighbors[p]) cut(cell, scene.landmarks.point(p - 1), scene.landmarks.point(q - 1));
        append(cells, cell);
    }
    return cells;
}

// Without p, the cell of q is bounded by neighbors of q and of p; and the other way round.
PlanePolygons order_two_cells(const PlaneScene& scene, const PlaneComplex& complex, const PlaneBox& box) {
    const Neighbors neighbors = neighbors_of(complex);
    PlanePolygons cells;
    for (const auto& [p, q] : complex.delaunay_edges()) {
        std::vector<Step> others = neighbors[p];
        others.insert(others.end(), neighbors[q].begin(), neighbors[q].end());
        std::sort(others.begin(), others.end());
        others.erase(std::unique(others.begin(), others.end()), others.end());
        Polygon cell = whole(box);
        for (const Step other : others) {
            if (other == p || other == q) continue;
            cut(cell, scene.landmarks.point(p - 1), scene.landmarks.point(other - 1));
            cut(cell, scene.landmarks.point(q - 1), scene.landmarks.point(other - 1));
        }
        append(cells, cell);
    }
    return cells;
}

}  // namespace plateau
