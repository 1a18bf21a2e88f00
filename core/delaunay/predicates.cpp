#include "delaunay/predicates.h"

#include <CGAL/MP_Float.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace plateau {

namespace {

template <class Number>
using Vector = std::array<Number, 3>;

template <class Number>
Vector<Number> difference(std::span<const double> a, std::span<const double> b) {
    return {Number(a[0]) - Number(b[0]), Number(a[1]) - Number(b[1]), Number(a[2]) - Number(b[2])};
}

template <class Number>
Number dot(const Vector<Number>& a, const Vector<Number>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class Number>
Vector<Number> cross(const Vector<Number>& a, const Vector<Number>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double largest(const Vector<double>& a) {
    double size = 0;
    for (const double x : a) size = x > size ? x : (-x > size ? -x : size);
    return size;
}

int exact_sign(const CGAL::MP_Float& value) {
    return static_cast<int>(value.sign());
}

// The sign if |value| exceeds the error bound and the bound is trustworthy (no underflow, no overflow), else 2.
int filtered_sign(double value, double error_bound) {
    constexpr double kSmallestTrusted = 1e-250;
    if (error_bound < kSmallestTrusted || !(error_bound <= std::numeric_limits<double>::max())) return 2;
    if (value > error_bound) return 1;
    if (value < -error_bound) return -1;
    return 2;
}

}  // namespace

int sign_of_wedge(std::span<const double> u, std::span<const double> v, std::span<const double> p,
                  std::span<const double> q) {
    const auto e = difference<double>(v, u);
    const auto a = difference<double>(p, u);
    const auto b = difference<double>(q, u);
    const double value = dot(cross(e, a), cross(e, b));
    // Each factor is off by at most 2^-53 relative; the value is a sum of 12 products of four factors, each product of
    // magnitude at most |e|^2 |a| |b| (largest entries), with at most 4 + 3 + 5 roundings: 12 * 12 * 2^-53 < 1e-13.
    const double size_e = largest(e);
    const int quick = filtered_sign(value, 1e-13 * size_e * size_e * largest(a) * largest(b));
    if (quick != 2) return quick;
    using Exact = CGAL::MP_Float;
    const auto exact_e = difference<Exact>(v, u);
    return exact_sign(dot(cross(exact_e, difference<Exact>(p, u)), cross(exact_e, difference<Exact>(q, u))));
}

int orientation(std::span<const double> a, std::span<const double> b, std::span<const double> c,
                std::span<const double> d) {
    const auto x = difference<double>(b, a);
    const auto y = difference<double>(c, a);
    const auto z = difference<double>(d, a);
    // Six products of three factors, at most 3 + 2 + 4 roundings each.
    const int quick = filtered_sign(dot(cross(x, y), z), 1e-14 * largest(x) * largest(y) * largest(z));
    if (quick != 2) return quick;
    using Exact = CGAL::MP_Float;
    return exact_sign(dot(cross(difference<Exact>(b, a), difference<Exact>(c, a)), difference<Exact>(d, a)));
}

// With squared edges a, b, c and the cross product x of two edges, R^2 = abc / (4 |x|^2); so R > rho sqrt(c) iff
// ab > 4 rho^2 |x|^2, and the shortest edge is the one that makes this easiest.
bool radius_edge_ratio_exceeds(double rho, std::span<const double> p, std::span<const double> q,
                               std::span<const double> r) {
    const auto excess = [&]<class Number>(const Number& ratio, int without) {
        const auto x = difference<Number>(q, p);
        const auto y = difference<Number>(r, p);
        const auto z = difference<Number>(r, q);
        const auto normal = cross(x, y);
        const std::array<Number, 3> squared{dot(x, x), dot(y, y), dot(z, z)};
        const auto first = static_cast<std::size_t>(without + 1) % 3;
        const auto second = static_cast<std::size_t>(without + 2) % 3;
        return squared[first] * squared[second] - Number(4) * ratio * ratio * dot(normal, normal);
    };
    const double longest = std::max(
        {largest(difference<double>(q, p)), largest(difference<double>(r, p)), largest(difference<double>(r, q))});
    const double error_bound = 1e-13 * (1 + 4 * rho * rho) * longest * longest * longest * longest;
    for (const int without : {0, 1, 2}) {
        int sign = filtered_sign(excess(rho, without), error_bound);
        if (sign == 2) sign = exact_sign(excess(CGAL::MP_Float(rho), without));
        if (sign > 0) return true;
    }
    return false;
}

}  // namespace plateau
