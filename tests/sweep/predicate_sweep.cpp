#include "sweep/predicate_sweep.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <vector>

#include "base/hash.h"
#include "base/random.h"
#include "delaunay/delaunay.h"
#include "delaunay/predicates.h"

namespace plateau::sweep {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Big = boost::multiprecision::cpp_int;
using Point = std::array<double, 3>;
using BigPoint = std::array<Big, 3>;

// All coordinates times one power of two, so that they are integers.
std::vector<BigPoint> scaled(const std::vector<Point>& points) {
    int smallest = 2000;
    for (const Point& p : points) {
        for (const double x : p) {
            int exponent = 0;
            if (std::frexp(x, &exponent) != 0) smallest = std::min(smallest, exponent - 53);
        }
    }
    std::vector<BigPoint> result;
    for (const Point& p : points) {
        BigPoint big;
        for (std::size_t i = 0; i < 3; ++i) {
            int exponent = 0;
            const double mantissa = std::frexp(p[i], &exponent);
            if (mantissa == 0) continue;
            big[i] = static_cast<std::int64_t>(std::ldexp(mantissa, 53));
            big[i] <<= exponent - 53 - smallest;
        }
        result.push_back(big);
    }
    return result;
}

BigPoint minus(const BigPoint& a, const BigPoint& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Big dot(const BigPoint& a, const BigPoint& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
BigPoint cross(const BigPoint& a, const BigPoint& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Big determinant(const BigPoint& a, const BigPoint& b, const BigPoint& c) {
    return dot(cross(a, b), c);
}
int sign(const Big& value) {
    return value.sign();
}

// Positive iff e lies inside the sphere through a, b, c, d when these are positively oriented.
Big in_sphere(const std::vector<BigPoint>& p) {
    const BigPoint a = minus(p[0], p[4]);
    const BigPoint b = minus(p[1], p[4]);
    const BigPoint c = minus(p[2], p[4]);
    const BigPoint d = minus(p[3], p[4]);
    return dot(a, a) * determinant(b, c, d) - dot(b, b) * determinant(a, c, d) + dot(c, c) * determinant(a, b, d) -
           dot(d, d) * determinant(a, b, c);
}

// The same in the plane, coordinates 0 and 1; positive iff d is inside when abc turns counter-clockwise.
Big in_circle(const std::vector<BigPoint>& p) {
    std::array<BigPoint, 3> rows;
    for (std::size_t i = 0; i < 3; ++i) {
        const Big x = p[i][0] - p[3][0];
        const Big y = p[i][1] - p[3][1];
        rows[i] = {x, y, x * x + y * y};
    }
    return determinant(rows[0], rows[1], rows[2]);
}

double nudged(double x, Random& random) {
    const auto choice = random.next_bits() % 5;
    for (std::uint64_t i = 0; i < choice / 2; ++i) x = std::nextafter(x, choice % 2 == 0 ? 1e300 : -1e300);
    return x;
}

Point grid_point(double spacing, Random& random) {
    Point p{};
    for (double& x : p) x = (static_cast<double>(random.next_bits() % 7) - 3) * spacing;
    return p;
}

// Integer points at distance 3 from the origin: (+-3, 0, 0) and (+-1, +-2, +-2) with their permutations.
Point sphere_point(double spacing, Random& random) {
    const bool on_axis = random.next_bits() % 5 == 0;
    const auto axis = static_cast<std::size_t>(random.next_bits() % 3);
    Point p{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double size = on_axis ? (i == axis ? 3 : 0) : (i == axis ? 1 : 2);
        p[i] = (random.next_bits() % 2 == 0 ? size : -size) * spacing;
    }
    return p;
}

std::vector<Point> input(int kind, double spacing, Random& random) {
    std::vector<Point> points;
    for (int i = 0; i < 5; ++i) {
        points.push_back(kind == 1 ? sphere_point(spacing, random) : grid_point(spacing, random));
    }
    if (kind == 2) {  // the last two almost in the plane of the first three
        for (std::size_t i = 3; i < 5; ++i) {
            const double s = random.next_between(-2, 2);
            const double t = random.next_between(-2, 2);
            for (std::size_t k = 0; k < 3; ++k) {
                points[i][k] = points[0][k] + s * (points[1][k] - points[0][k]) + t * (points[2][k] - points[0][k]);
            }
        }
    }
    for (Point& p : points) {
        for (double& x : p) x = nudged(x, random);
    }
    return points;
}

void compare(int given, const Big& exact, Outcome& outcome) {
    ++outcome.calls;
    if (given != sign(exact)) ++outcome.mismatches;
}

void check(const std::vector<Point>& p, Outcome& outcome) {
    const auto big = scaled(p);
    const BigPoint u = minus(big[1], big[0]);
    const BigPoint v = minus(big[2], big[0]);
    const BigPoint w = minus(big[3], big[0]);
    const auto space = [&](std::size_t i) { return Kernel::Point_3(p[i][0], p[i][1], p[i][2]); };
    const auto plane = [&](std::size_t i) { return Kernel::Point_2(p[i][0], p[i][1]); };

    compare(CGAL::orientation(plane(0), plane(1), plane(2)), u[0] * v[1] - u[1] * v[0], outcome);
    const Big volume = determinant(u, v, w);
    compare(CGAL::orientation(space(0), space(1), space(2), space(3)), volume, outcome);
    compare(CGAL::side_of_oriented_circle(plane(0), plane(1), plane(2), plane(3)), in_circle(big), outcome);
    compare(CGAL::side_of_oriented_sphere(space(0), space(1), space(2), space(3), space(4)), in_sphere(big), outcome);
    compare(orientation(p[0], p[1], p[2], p[3]), volume, outcome);
    compare(sign_of_wedge(p[0], p[1], p[2], p[3]), dot(cross(u, v), cross(u, w)), outcome);
}

}  // namespace

Outcome sweep_predicates(std::uint32_t rounds) {
    Outcome outcome;
    Random random(7);
    for (const double spacing : {1e-3, 0.1, 1.0 / 3, 1.0, 1e6}) {
        for (int kind = 0; kind < 3; ++kind) {
            for (std::uint32_t round = 0; round < rounds; ++round) check(input(kind, spacing, random), outcome);
        }
    }
    return outcome;
}

std::uint64_t grid_delaunay_hash(std::uint32_t edge, double spacing) {
    std::vector<Point> points;
    for (std::uint32_t i = 0; i < edge * edge * edge; ++i) {
        points.push_back({spacing * (i % edge), spacing * (i / edge % edge), spacing * (i / edge / edge)});
    }
    Random random(3);
    for (std::size_t i = points.size(); i > 1; --i) std::swap(points[i - 1], points[random.next_bits() % i]);

    Delaunay delaunay(3);
    for (std::uint32_t step = 1; step <= points.size(); ++step) {
        if (!delaunay.insert(step, points[step - 1], step - 1)) return 0;
    }
    std::vector<std::array<std::uint32_t, 4>> cells;
    for (CellId id = 0; id < delaunay.cell_capacity(); ++id) {
        const DelaunayCell& cell = delaunay.cell(id);
        if (!cell.alive || !cell.finite(3)) continue;
        auto vertices = cell.vertex;
        std::sort(vertices.begin(), vertices.end());
        cells.push_back(vertices);
    }
    std::sort(cells.begin(), cells.end());
    Fnv1a64 hash;
    for (const auto& cell : cells) {
        for (const std::uint32_t vertex : cell) hash.add_u32(vertex);
    }
    return hash.value();
}

}  // namespace plateau::sweep
