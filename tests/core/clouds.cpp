#include "clouds.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <ostream>
#include <sstream>
#include <stdexcept>

namespace plateau {
namespace {

using Point = std::array<double, 3>;
using Points = std::vector<Point>;

/// Numbers in [0, 1) from a linear congruence; the seed is fixed for each cloud.
class Numbers {
public:
    explicit Numbers(std::uint64_t seed) : state_(seed * 2654435761u + 12345) {}
    double unit() {
        state_ = state_ * 6364136223846793005u + 1442695040888963407u;
        return static_cast<double>(state_ >> 33) / 2147483648.0;
    }
    double between(double low, double high) { return low + (high - low) * unit(); }
    int below(int bound) { return static_cast<int>(unit() * bound); }

private:
    std::uint64_t state_;
};

PointCloud in_space(const Points& points) {
    PointCloud cloud;
    cloud.dimension = 3;
    for (const Point& point : points) cloud.coordinates.insert(cloud.coordinates.end(), point.begin(), point.end());
    return cloud;
}

PointCloud in_plane(const Points& points) {
    PointCloud cloud;
    cloud.dimension = 2;
    for (const Point& point : points)
        cloud.coordinates.insert(cloud.coordinates.end(), point.begin(), point.begin() + 2);
    return cloud;
}

Points joined(Points a, const Points& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

/// Each point scaled, then moved.
Points placed(Points points, double scale, const Point& offset) {
    for (Point& point : points) {
        for (std::size_t axis = 0; axis < 3; ++axis) point[axis] = point[axis] * scale + offset[axis];
    }
    return points;
}

/// The unit circle without sine and cosine: a point of parameter t in a quarter turn, turned by quarters.
Point on_circle(double turn) {
    const double quarter = std::floor(4 * turn);
    const double t = 4 * turn - quarter;
    const double x = (1 - t * t) / (1 + t * t), y = 2 * t / (1 + t * t);
    switch (static_cast<int>(quarter) % 4) {
        case 0:
            return {x, y, 0};
        case 1:
            return {-y, x, 0};
        case 2:
            return {-x, -y, 0};
        default:
            return {y, -x, 0};
    }
}

Points uniform(int n, std::uint64_t seed, const Point& size) {
    Numbers numbers(seed);
    Points points;
    for (int i = 0; i < n; ++i) {
        const double x = numbers.unit(), y = numbers.unit(), z = numbers.unit();
        points.push_back({size[0] * x, size[1] * y, size[2] * z});
    }
    return points;
}

Points circle(int n, std::uint64_t seed, double noise) {
    Numbers numbers(seed);
    Points points;
    for (int i = 0; i < n; ++i) {
        Point point = on_circle(numbers.unit());
        point[0] += numbers.between(-noise, noise);
        point[1] += numbers.between(-noise, noise);
        points.push_back(point);
    }
    return points;
}

Points sphere(int n, std::uint64_t seed) {
    Numbers numbers(seed);
    Points points;
    while (static_cast<int>(points.size()) < n) {
        const double x = numbers.between(-1, 1), y = numbers.between(-1, 1), z = numbers.between(-1, 1);
        const double r = std::sqrt(x * x + y * y + z * z);
        if (r > 0.1 && r < 1) points.push_back({x / r, y / r, z / r});
    }
    return points;
}

Point on_torus(double turn, double small_turn, double tube) {
    const Point ring = on_circle(turn), section = on_circle(small_turn);
    const double r = 1 + tube * section[0];
    return {r * ring[0], r * ring[1], tube * section[1]};
}

Points torus(int n, std::uint64_t seed, double tube) {
    Numbers numbers(seed);
    Points points;
    for (int i = 0; i < n; ++i) {
        const double turn = numbers.unit(), small_turn = numbers.unit();
        points.push_back(on_torus(turn, small_turn, tube));
    }
    return points;
}

/// A closed curve that winds `windings` times around a torus.
Points helix(int n, int windings) {
    Points points;
    for (int i = 0; i < n; ++i) {
        const double turn = static_cast<double>(i) / n;
        const double small = turn * windings;
        points.push_back(on_torus(turn, small - std::floor(small), 0.4));
    }
    return points;
}

Points grid(const std::array<int, 3>& count, double spacing) {
    Points points;
    for (int x = 0; x < count[0]; ++x) {
        for (int y = 0; y < count[1]; ++y) {
            for (int z = 0; z < count[2]; ++z) points.push_back({x * spacing, y * spacing, z * spacing});
        }
    }
    return points;
}

Points lattice(int n, std::uint64_t seed, const std::array<int, 3>& size) {
    Numbers numbers(seed);
    Points points;
    for (int i = 0; i < n; ++i) {
        const int x = numbers.below(size[0]), y = numbers.below(size[1]), z = numbers.below(size[2]);
        points.push_back({double(x), double(y), double(z)});
    }
    return points;
}

/// All integer points with x^2 + y^2 + z^2 = radius_squared and |z| <= height: exactly cospherical.
Points integer_sphere(int radius_squared, int height) {
    const int radius = static_cast<int>(std::sqrt(radius_squared));
    Points points;
    for (int x = -radius; x <= radius; ++x) {
        for (int y = -radius; y <= radius; ++y) {
            for (int z = -height; z <= height; ++z) {
                if (x * x + y * y + z * z == radius_squared) points.push_back({double(x), double(y), double(z)});
            }
        }
    }
    return points;
}

/// Points of the plane z = 0 in the plane spanned by the integer vectors (1, 2, 2) and (2, 1, -2), both of length 3.
Points tilted(Points points) {
    for (Point& p : points) p = {p[0] + 2 * p[1] + 2 * p[2], 2 * p[0] + p[1] - 2 * p[2], 2 * p[0] - 2 * p[1] + p[2]};
    return points;
}

/// x, y, z scaled one by one.
Points stretched(Points points, const Point& factor) {
    for (Point& point : points) {
        for (std::size_t axis = 0; axis < 3; ++axis) point[axis] *= factor[axis];
    }
    return points;
}

Points octahedron() {
    return {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
}

Points icosahedron() {
    const double golden = (1 + std::sqrt(5.0)) / 2;
    Points points;
    for (const double a : {-1.0, 1.0}) {
        for (const double b : {-golden, golden}) points = joined(points, {{0, a, b}, {a, b, 0}, {b, 0, a}});
    }
    return points;
}

Points repeated(const Points& points, int times) {
    Points result;
    for (int i = 0; i < times; ++i) result = joined(result, points);
    return result;
}

/// A disk in the plane z = 0 across the hole of the torus.
Points torus_with_disk(int n, std::uint64_t seed) {
    Points points = torus(2 * n / 3, seed, 0.4);
    Numbers numbers(seed + 1);
    while (static_cast<int>(points.size()) < n) {
        const double x = numbers.between(-0.6, 0.6), y = numbers.between(-0.6, 0.6);
        if (x * x + y * y < 0.36) points.push_back({x, y, 0});
    }
    return points;
}

/// Rows of x,y,z as a scanner writes them: a bumpy surface seen from above, three decimals.
Points scanned() {
    const std::string path = PLATEAU_TEST_DATA "/scan.csv";
    std::ifstream file(path);
    if (!file) throw std::runtime_error("cannot read " + path);
    Points points;
    std::string line;
    std::getline(file, line);  // the header
    while (std::getline(file, line)) {
        for (char& letter : line) letter = letter == ',' ? ' ' : letter;
        std::istringstream numbers(line);
        Point point{};
        if (numbers >> point[0] >> point[1] >> point[2]) points.push_back(point);
    }
    if (points.empty()) throw std::runtime_error("no points in " + path);
    return points;
}

std::vector<TestCloud> plane_clouds() {
    const Points line = grid({9, 1, 1}, 1);
    return {
        {"plane_one_point", in_plane({{3, 4, 0}})},
        {"plane_two_points", in_plane({{3, 4, 0}, {-1, 0.5, 0}})},
        {"plane_three_points", in_plane({{0, 0, 0}, {4, 0, 0}, {1, 1, 0}})},
        {"plane_square", in_plane({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}})},
        {"plane_uniform", in_plane(uniform(48, 1, {1, 1, 0}))},
        {"plane_circle", in_plane(circle(40, 2, 0))},
        {"plane_circle_noise", in_plane(circle(60, 3, 0.08))},
        {"plane_two_circles", in_plane(joined(circle(30, 4, 0.02), placed(circle(30, 5, 0.02), 0.5, {1.8, 0.3, 0})))},
        {"plane_circle_large", in_plane(joined(circle(120, 6, 0.05), placed(circle(60, 7, 0.05), 0.4, {0, 0, 0})))},
        {"plane_cocircular", in_plane(integer_sphere(4225, 0))},
        {"plane_grid", in_plane(grid({7, 7, 1}, 1))},
        {"plane_grid_tenth", in_plane(grid({6, 8, 1}, 0.1))},
        {"plane_lattice", in_plane(lattice(60, 8, {9, 7, 1}))},
        {"plane_duplicates", in_plane(repeated(uniform(14, 9, {1, 1, 0}), 3))},
        {"plane_all_duplicates", in_plane(repeated({{0.1, 0.2, 0}}, 6))},
        {"plane_collinear_axis", in_plane(line)},
        {"plane_collinear_skew", in_plane(tilted(joined(line, {{0.5, 0, 0}, {6.25, 0, 0}})))},
        {"plane_rising", in_plane(joined(grid({20, 1, 1}, 0.5), {{4.5, 1e-9, 0}}))},
        {"plane_tiny", in_plane(placed(uniform(30, 10, {1, 1, 0}), 1e-9, {0, 0, 0}))},
        {"plane_huge", in_plane(placed(circle(30, 11, 0.1), 1e9, {0, 0, 0}))},
    };
}

std::vector<TestCloud> flat_clouds_in_space() {
    const Points line = grid({8, 1, 1}, 1);
    const Points sheet = grid({5, 5, 1}, 1);
    const Points almost_flat = joined(sheet, {{2.125, 2.25, 1e-7}});
    return {
        {"one_point", in_space({{1, 2, 3}})},
        {"two_points", in_space({{1, 2, 3}, {1, 2, 4}})},
        {"three_points", in_space({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}})},
        {"four_points", in_space({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}})},
        {"all_duplicates", in_space(repeated({{0.1, 0.2, 0.3}}, 7))},
        {"duplicates", in_space(repeated(sphere(16, 20), 3))},
        {"collinear_axis", in_space(line)},
        {"collinear_skew", in_space(tilted(joined(line, {{0.5, 0, 0}, {3.25, 0, 0}})))},
        {"coplanar_axis", in_space(placed(sheet, 1, {0, 0, 0.5}))},
        {"coplanar_skew", in_space(tilted(lattice(40, 21, {7, 6, 1})))},
        {"coplanar_circle_skew", in_space(tilted(integer_sphere(4225, 0)))},
        {"rising_from_plane", in_space(almost_flat)},
        {"rising_from_skew_plane", in_space(tilted(joined(sheet, {{2.125, 2.25, 1e-3}})))},
        // The points beside the line lie next to its first one, so they come last.
        {"rising_twice",
         in_space(joined(grid({14, 1, 1}, 2), {{0.25, 0.125, 0}, {0.125, 0, 0.0625}, {0, 0.0625, 0.0625}}))},
        {"slab", in_space(uniform(50, 22, {1, 1, 0.001}))},
    };
}

std::vector<TestCloud> tied_clouds_in_space() {
    const Points cube = grid({2, 2, 2}, 1);
    return {
        {"cube", in_space(cube)},
        {"cube_with_center", in_space(joined(cube, {{0.5, 0.5, 0.5}}))},
        {"octahedron", in_space(octahedron())},
        {"octahedron_with_center", in_space(joined(octahedron(), {{0, 0, 0}}))},
        {"icosahedron", in_space(icosahedron())},
        {"cospherical_9", in_space(integer_sphere(9, 3))},
        {"cospherical_27", in_space(joined(integer_sphere(27, 5), {{0, 0, 0}}))},
        {"grid", in_space(grid({4, 4, 3}, 1))},
        {"grid_tenth", in_space(grid({3, 4, 4}, 0.1))},
        {"lattice", in_space(lattice(55, 30, {4, 5, 4}))},
        {"lattice_shell", in_space(joined(integer_sphere(14, 3), placed(octahedron(), 1, {0, 0, 0})))},
    };
}

std::vector<TestCloud> shapes_in_space() {
    return {
        {"uniform", in_space(uniform(45, 40, {1, 1, 1}))},
        {"sphere", in_space(sphere(60, 41))},
        {"torus", in_space(torus(60, 42, 0.45))},
        {"torus_large", in_space(torus(200, 43, 0.4))},
        {"helix", in_space(helix(60, 5))},
        {"helix_large", in_space(helix(170, 7))},
        {"two_spheres", in_space(joined(sphere(30, 44), placed(sphere(30, 45), 0.8, {2.5, 0.3, 0.1})))},
        {"shells_large", in_space(joined(sphere(90, 46), placed(sphere(40, 47), 0.4, {0, 0, 0})))},
        {"nested_octahedra", in_space(joined(placed(octahedron(), 4, {0, 0, 0}), octahedron()))},
        {"torus_dense", in_space(torus(700, 52, 0.4)), 110},
        {"torus_with_disk_dense", in_space(torus_with_disk(900, 48)), 120},
        {"helix_dense", in_space(helix(600, 9)), 120},
        {"touching_at_vertex", in_space(joined(stretched(icosahedron(), {1, 1, 1}),
                                               placed(icosahedron(), 1, {0, 2, 2 * (1 + std::sqrt(5.0)) / 2})))},
        {"touching_at_edge", in_space(joined(icosahedron(), placed(icosahedron(), 1, {0, 0, 1 + std::sqrt(5.0)})))},
        {"tiny_sphere", in_space(placed(sphere(40, 49), 1e-9, {0, 0, 0}))},
        {"huge_torus", in_space(placed(torus(50, 50, 0.5), 1e9, {0, 0, 0}))},
        {"far_away", in_space(placed(sphere(40, 51), 1, {1e6, -2e6, 3e6}))},
        {"scan_large", in_space(scanned())},
    };
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const TestCloud& cloud) {
    return out << cloud.name;
}

std::vector<TestCloud> test_clouds() {
    std::vector<TestCloud> clouds;
    for (const std::vector<TestCloud>& part :
         {plane_clouds(), flat_clouds_in_space(), tied_clouds_in_space(), shapes_in_space()}) {
        clouds.insert(clouds.end(), part.begin(), part.end());
    }
    return clouds;
}

TestCloud test_cloud(const std::string& name) {
    for (const TestCloud& cloud : test_clouds()) {
        if (cloud.name == name) return cloud;
    }
    throw std::out_of_range("no test cloud " + name);
}

}  // namespace plateau
