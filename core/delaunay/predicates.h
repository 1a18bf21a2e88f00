#pragma once

#include <span>

namespace plateau {

/// Exact signs of polynomials in the coordinates of points in space: -1, 0 or 1. Filtered in double, decided in exact
/// arithmetic where rounding could matter.

/// Sign of (e x a) . (e x b) with e = v - u, a = p - u, b = q - u: positive iff the half-planes from the line uv
/// through p and q meet at an angle below pi/2, 0 at a right angle (the sharp-edge test of [GO 3.2.2] for one pair).
int sign_of_wedge(std::span<const double> u, std::span<const double> v, std::span<const double> p,
                  std::span<const double> q);

/// Sign of det(b - a, c - a, d - a): positive iff d is on the side of abc from which abc turns counter-clockwise.
int orientation(std::span<const double> a, std::span<const double> b, std::span<const double> c,
                std::span<const double> d);

/// Whether the radius-edge ratio of the triangle pqr (circumradius over shortest edge) exceeds rho > 0. A triangle
/// without area has an infinite ratio.
bool radius_edge_ratio_exceeds(double rho, std::span<const double> p, std::span<const double> q,
                               std::span<const double> r);

}  // namespace plateau
