#pragma once

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <vector>

#include "cloud/point_cloud.h"
#include "reference/complex.h"

namespace plateau::reference {

using Integer = boost::multiprecision::cpp_int;
using Vector = std::array<Integer, 3>;

/// Points of a cloud as integers: all coordinates times one power of two, so that nothing is rounded. In the plane the
/// third coordinate is 0. [s] is the landmark of step s; [0] is unused.
using ExactPoints = std::vector<Vector>;
ExactPoints exact_points(const PointCloud& cloud, const std::vector<int>& landmarks);

Integer dot(const Vector& a, const Vector& b);
Vector cross(const Vector& a, const Vector& b);
Vector difference(const Vector& a, const Vector& b);

/// Dimension of the affine hull of the points of steps 1 .. step.
int affine_dimension(const ExactPoints& points, int step);

/// Where q lies with respect to the smallest sphere through the vertices of an affinely independent simplex, q in the
/// affine hull of the simplex: -1 inside, 0 on it, 1 outside.
class Circumsphere {
public:
    Circumsphere(const ExactPoints& points, const Simplex& simplex);
    /// No sphere: the vertices are affinely dependent.
    bool degenerate() const { return determinant_ == 0; }
    int side(int q) const;

private:
    const ExactPoints& points_;
    int origin_;
    std::vector<Vector> edges_;      ///< from the first vertex to the others
    Integer determinant_;            ///< of the Gram matrix G of the edges
    std::vector<Integer> solution_;  ///< center - origin = sum of solution_[j] edges_[j] / (2 determinant_)
};

/// Sign of the volume of (a, b, c, d): 1 where a, b, c turn counter-clockwise when seen from d.
int orientation(const ExactPoints& points, int a, int b, int c, int d);

/// Sign of (e x a).(e x b) with e the edge and a, b the vectors from its first vertex to two other points.
int wedge_sign(const ExactPoints& points, const Simplex& edge, int third, int other_third);

/// Whether circumradius / shortest edge of a triangle exceeds rho.
bool radius_edge_ratio_exceeds(const ExactPoints& points, const Simplex& triangle, double rho);

}  // namespace plateau::reference
