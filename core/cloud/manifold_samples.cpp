#include "cloud/manifold_samples.h"

#include <array>
#include <cmath>

#include "cloud/spread_points.h"
#include "cloud/trigonometry.h"

namespace plateau {
namespace {

using Coordinates = std::vector<double>;

template <std::size_t N>
void append(Coordinates& out, const std::array<double, N>& point) {
    out.insert(out.end(), point.begin(), point.end());
}

/// Uniform on the unit sphere of R^N: rejection from the cube, and of what is so near the center that its direction is
/// rounded.
template <std::size_t N>
std::array<double, N> on_sphere(Random& random) {
    for (;;) {
        std::array<double, N> point{};
        double norm_squared = 0;
        for (double& coordinate : point) {
            coordinate = random.next_between(-1, 1);
            norm_squared += coordinate * coordinate;
        }
        if (norm_squared > 1 || norm_squared < 0.01) continue;
        const double norm = std::sqrt(norm_squared);
        for (double& coordinate : point) coordinate /= norm;
        return point;
    }
}

SineCosine random_angle(Random& random) {
    return sine_cosine_of_turns(random.next_unit());
}

/// Flat, so that points spread in the plane of both angles are spread on it; but for the seam, where a few are close.
Coordinates product_of_circles(double second_radius, std::uint32_t size, Random& random) {
    SpreadPoints flat(2, size, kTwoPi * kTwoPi * second_radius);
    while (!flat.full()) {
        const double along = random.next_unit();
        const double across = random.next_unit();
        flat.add({kTwoPi * along, kTwoPi * second_radius * across, 0});
    }
    const Coordinates lengths = flat.take();
    Coordinates out;
    for (std::size_t k = 0; k < lengths.size(); k += 2) {
        const SineCosine a = sine_cosine_of_turns(lengths[k] / kTwoPi);
        const SineCosine b = sine_cosine_of_turns(lengths[k + 1] / (kTwoPi * second_radius));
        append(out, std::array{a.cosine, a.sine, second_radius * b.cosine, second_radius * b.sine});
    }
    return out;
}

constexpr double kAnnulusHole = 0.5;

/// Points of the unit disk beyond a radius.
Coordinates flat_ring(double hole, std::uint32_t size, Random& random) {
    SpreadPoints points(3, size, kTwoPi / 2 * (1 - hole * hole));
    while (!points.full()) {
        const double x = random.next_between(-1, 1);
        const double y = random.next_between(-1, 1);
        const double norm_squared = x * x + y * y;
        if (norm_squared <= 1 && norm_squared >= hole * hole) points.add({x, y, 0});
    }
    return points.take();
}

}  // namespace

Coordinates sample_clifford(std::uint32_t size, Random& random) {
    return product_of_circles(1, size, random);
}

Coordinates sample_two_scales(std::uint32_t size, Random& random) {
    constexpr double kThin = 0.25;
    return product_of_circles(kThin, size, random);
}

// The lengths along the two angles u, around, and v, along the small circle, are sqrt((1 + r cos v)^2 + (r sin v)^2 /
// 4) and r, at right angles.
Coordinates sample_klein(std::uint32_t size, Random& random) {
    constexpr double kRadius = 0.5;
    Coordinates out;
    while (out.size() < std::size_t{4} * size) {
        const double turns = random.next_unit();
        const SineCosine v = random_angle(random);
        const double height = random.next_unit() * (1 + kRadius);
        const double to_axis = 1 + kRadius * v.cosine;
        const double across = kRadius * v.sine;
        if (height * height > to_axis * to_axis + across * across / 4) continue;
        const SineCosine u = sine_cosine_of_turns(turns);
        const SineCosine half = sine_cosine_of_turns(turns / 2);
        append(out, std::array{to_axis * u.cosine, to_axis * u.sine, across * half.cosine, across * half.sine});
    }
    return out;
}

Coordinates sample_s3(std::uint32_t size, Random& random) {
    Coordinates out;
    for (std::uint32_t k = 0; k < size; ++k) append(out, on_sphere<4>(random));
    return out;
}

Coordinates sample_rp2(std::uint32_t size, Random& random) {
    Coordinates out;
    for (std::uint32_t k = 0; k < size; ++k) {
        const auto [x, y, z] = on_sphere<3>(random);
        append(out, std::array{x * y, x * z, y * y - z * z, 2 * y * z});
    }
    return out;
}

Coordinates sample_s2xs1(std::uint32_t size, Random& random) {
    Coordinates out;
    for (std::uint32_t k = 0; k < size; ++k) {
        const auto [x, y, z] = on_sphere<3>(random);
        const SineCosine angle = random_angle(random);
        append(out, std::array{x, y, z, angle.cosine, angle.sine});
    }
    return out;
}

// By unit quaternions, which cover the rotations twice.
Coordinates sample_so3(std::uint32_t size, Random& random) {
    Coordinates out;
    for (std::uint32_t k = 0; k < size; ++k) {
        const auto [w, x, y, z] = on_sphere<4>(random);
        append(out, std::array{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y), 2 * (x * y + w * z),
                               1 - 2 * (x * x + z * z), 2 * (y * z - w * x), 2 * (x * z - w * y), 2 * (y * z + w * x),
                               1 - 2 * (x * x + y * y)});
    }
    return out;
}

Coordinates sample_disk(std::uint32_t size, Random& random) {
    return flat_ring(0, size, random);
}

Coordinates sample_annulus(std::uint32_t size, Random& random) {
    return flat_ring(kAnnulusHole, size, random);
}

Coordinates sample_hemisphere(std::uint32_t size, Random& random) {
    SpreadPoints points(3, size, kTwoPi);
    while (!points.full()) {
        const auto [x, y, z] = on_sphere<3>(random);
        points.add({x, y, std::abs(z)});
    }
    return points.take();
}

// At distance s from the middle line the length along the angle is sqrt((1 + s cos(u / 2))^2 + s^2 / 4).
Coordinates sample_mobius(std::uint32_t size, Random& random) {
    constexpr double kHalfWidth = 0.4;
    constexpr double kArea = kTwoPi * 2 * kHalfWidth;
    SpreadPoints points(3, size, kArea);
    while (!points.full()) {
        const double turns = random.next_unit();
        const double s = random.next_between(-kHalfWidth, kHalfWidth);
        const double height = random.next_unit() * (1 + 1.25 * kHalfWidth);
        const SineCosine half = sine_cosine_of_turns(turns / 2);
        const double to_axis = 1 + s * half.cosine;
        if (height * height > to_axis * to_axis + s * s / 4) continue;
        const SineCosine u = sine_cosine_of_turns(turns);
        points.add({to_axis * u.cosine, to_axis * u.sine, s * half.sine});
    }
    return points.take();
}

}  // namespace plateau
