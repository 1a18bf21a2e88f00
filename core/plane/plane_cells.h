#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "plane/plane_complex.h"

namespace plateau {

/// A rectangle: what of the plane is drawn.
struct PlaneBox {
    double left = 0, bottom = 0, right = 1, top = 1;
};

/// Convex polygons one after the other, corners counter-clockwise; a cell that has nothing in the box has none.
struct PlanePolygons {
    std::vector<double> corners;                 ///< x, y of each
    std::vector<std::uint32_t> first_corner{0};  ///< of each polygon, and one more: the number of corners
};

/// The Voronoi cells of the landmarks within the box, one a landmark: where it is the nearest one.
PlanePolygons voronoi_cells(const PlaneScene& scene, const PlaneComplex& complex, const PlaneBox& box);

/// The cells of order two within the box, one for each edge {p, q} of D(L), in its order: where p and q are the two
/// nearest landmarks. No other pair has a cell; of landmarks on a circle the perturbation of D(L) decides which pairs
/// have one, and some of those have no area.
///
/// Which landmarks bound a cell is exact, from D(L): those next to p or to q. Corners are rounded.
PlanePolygons order_two_cells(const PlaneScene& scene, const PlaneComplex& complex, const PlaneBox& box);

}  // namespace plateau
