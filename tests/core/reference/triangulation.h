#pragma once

#include <array>
#include <set>
#include <vector>

#include "reference/complex.h"

namespace plateau::reference {

/// The maximal simplices of a triangulation of labeled points in their affine hull.
struct Triangulation {
    int dimension = 0;
    std::set<Simplex> cells;
};

struct LabeledPoint {
    std::array<double, 3> position;
    int label;
};

/// A fresh Delaunay triangulation in space by CGAL, the points inserted in the given order, cospherical ties by its
/// symbolic perturbation.
Triangulation triangulate_space(const std::vector<LabeledPoint>& points);

/// The same for points of the plane (third coordinate 0), by CGAL's triangulation of the plane.
Triangulation triangulate_plane(const std::vector<LabeledPoint>& points);

}  // namespace plateau::reference
