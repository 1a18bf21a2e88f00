#include "reference/exact.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plateau::reference {
namespace {

Integer determinant(const std::vector<std::vector<Integer>>& m) {
    if (m.empty()) return 1;
    Integer sum = 0;
    for (std::size_t column = 0; column < m.size(); ++column) {
        std::vector<std::vector<Integer>> minor(m.begin() + 1, m.end());
        for (auto& row : minor) row.erase(row.begin() + static_cast<std::ptrdiff_t>(column));
        const Integer term = m[0][column] * determinant(minor);
        if (column % 2 == 0) {
            sum += term;
        } else {
            sum -= term;
        }
    }
    return sum;
}

}  // namespace

ExactPoints exact_points(const PointCloud& cloud, const std::vector<int>& landmarks) {
    // A finite double is a 53-bit integer times 2^(exponent - 53).
    int lowest = std::numeric_limits<int>::max();
    for (const double number : cloud.coordinates) {
        int exponent = 0;
        std::frexp(number, &exponent);
        if (number != 0) lowest = std::min(lowest, exponent - 53);
    }
    ExactPoints points(1);
    for (const int landmark : landmarks) {
        Vector point;
        for (std::size_t axis = 0; axis < cloud.dimension; ++axis) {
            const double number = cloud.coordinates[static_cast<std::size_t>(landmark) * cloud.dimension + axis];
            int exponent = 0;
            const double fraction = std::frexp(number, &exponent);
            if (number == 0) continue;
            const auto mantissa = static_cast<long long>(std::ldexp(fraction, 53));
            point[axis] = Integer(mantissa) << static_cast<unsigned>(exponent - 53 - lowest);
        }
        points.push_back(point);
    }
    return points;
}

Integer dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector difference(const Vector& a, const Vector& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

int affine_dimension(const ExactPoints& points, int step) {
    // Greedy: a point is added when the Gram matrix of the edges stays regular.
    Simplex basis = {1};
    for (int s = 2; s <= step; ++s) {
        Simplex larger = basis;
        larger.push_back(s);
        if (larger.size() <= 4 && !Circumsphere(points, larger).degenerate()) basis = larger;
    }
    return static_cast<int>(basis.size()) - 1;
}

Circumsphere::Circumsphere(const ExactPoints& points, const Simplex& simplex) : points_(points), origin_(simplex[0]) {
    const auto at = [&](int step) { return points[static_cast<std::size_t>(step)]; };
    for (std::size_t j = 1; j < simplex.size(); ++j) edges_.push_back(difference(at(simplex[j]), at(origin_)));
    // The center c satisfies 2 (c - origin).u = u.u for every edge u: G x = b with c - origin = sum x_j u_j / 2.
    const std::size_t m = edges_.size();
    std::vector<std::vector<Integer>> gram(m, std::vector<Integer>(m));
    for (std::size_t i = 0; i < m; ++i) {
        for (std::size_t j = 0; j < m; ++j) gram[i][j] = dot(edges_[i], edges_[j]);
    }
    determinant_ = determinant(gram);
    for (std::size_t j = 0; j < m; ++j) {
        auto replaced = gram;
        for (std::size_t i = 0; i < m; ++i) replaced[i][j] = gram[i][i];
        solution_.push_back(determinant(replaced));
    }
}

int Circumsphere::side(int q) const {
    const auto at = [&](int step) { return points_[static_cast<std::size_t>(step)]; };
    const Vector r = difference(at(q), at(origin_));
    Integer value = determinant_ * dot(r, r);
    for (std::size_t j = 0; j < edges_.size(); ++j) value -= dot(r, edges_[j]) * solution_[j];
    return value.sign();
}

int orientation(const ExactPoints& points, int a, int b, int c, int d) {
    const auto at = [&](int step) { return points[static_cast<std::size_t>(step)]; };
    return dot(cross(difference(at(b), at(a)), difference(at(c), at(a))), difference(at(d), at(a))).sign();
}

int wedge_sign(const ExactPoints& points, const Simplex& edge, int third, int other_third) {
    const auto at = [&](int step) { return points[static_cast<std::size_t>(step)]; };
    const Vector e = difference(at(edge[1]), at(edge[0]));
    const Vector a = difference(at(third), at(edge[0]));
    const Vector b = difference(at(other_third), at(edge[0]));
    return dot(cross(e, a), cross(e, b)).sign();
}

bool radius_edge_ratio_exceeds(const ExactPoints& points, const Simplex& triangle, double rho) {
    const auto at = [&](int vertex) {
        return points[static_cast<std::size_t>(triangle[static_cast<std::size_t>(vertex)])];
    };
    const Vector u = difference(at(1), at(0));
    const Vector v = difference(at(2), at(0));
    const Vector w = difference(at(2), at(1));
    const Integer a = dot(u, u), b = dot(v, v), c = dot(w, w);
    const Vector normal = cross(u, v);
    // R^2 = a b c / (16 area^2) and 4 area^2 = normal.normal.
    using Rational = boost::multiprecision::cpp_rational;
    const Rational ratio_squared(a * b * c, 4 * dot(normal, normal) * std::min({a, b, c}));
    return ratio_squared > Rational(rho) * Rational(rho);
}

}  // namespace plateau::reference
