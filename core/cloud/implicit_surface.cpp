#include "cloud/implicit_surface.h"

#include <cmath>

namespace plateau {
namespace {

/// Signed distance to a torus around the axis through (center_x, 0, 0) parallel to z.
FieldSample torus_field(const Vector3& p, double center_x, double large_radius, double small_radius) {
    const double x = p[0] - center_x;
    const double to_axis = std::sqrt(x * x + p[1] * p[1]);
    const double outward = to_axis - large_radius;
    const double to_core = std::sqrt(outward * outward + p[2] * p[2]);
    FieldSample sample;
    sample.value = to_core - small_radius;
    // On the axis and on the core circle there is no gradient; a zero one keeps the point out of the sample.
    if (to_axis == 0 || to_core == 0) return sample;
    const double along = outward / to_core;
    sample.gradient = {along * (x / to_axis), along * (p[1] / to_axis), p[2] / to_core};
    return sample;
}

/// Smooth minimum of two distances: (a + b - sqrt((a-b)^2 + k^2)) / 2.
FieldSample melted(const FieldSample& a, const FieldSample& b, double k) {
    const double difference = a.value - b.value;
    const double root = std::sqrt(difference * difference + k * k);
    const double weight = (1 - difference / root) * 0.5;
    FieldSample sample;
    sample.value = (a.value + b.value - root) * 0.5;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        sample.gradient[axis] = weight * a.gradient[axis] + (1 - weight) * b.gradient[axis];
    }
    return sample;
}

double squared_norm(const Vector3& v) {
    return v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
}

}  // namespace

FieldSample tanglecube_field(const Vector3& point) {
    FieldSample sample;
    sample.value = 11.8;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double square = point[axis] * point[axis];
        sample.value += square * square - 5 * square;
        sample.gradient[axis] = (4 * square - 10) * point[axis];
    }
    return sample;
}

FieldSample double_torus_field(const Vector3& point) {
    return melted(torus_field(point, 0, 1, 0.4), torus_field(point, 1.72, 0.32, 0.16), 0.1);
}

void fill_from(const ImplicitSurface& surface, Random& random, SpreadPoints& points) {
    constexpr int kNewtonSteps = 5;
    const double shell_squared = surface.shell * surface.shell;
    while (!points.full()) {
        Vector3 point{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            point[axis] = random.next_between(surface.low[axis], surface.high[axis]);
        }
        FieldSample sample = surface.field(point);
        if (!(sample.value * sample.value < shell_squared * squared_norm(sample.gradient))) continue;
        for (int step = 0; step < kNewtonSteps; ++step) {
            const double pace = sample.value / squared_norm(sample.gradient);
            for (std::size_t axis = 0; axis < 3; ++axis) point[axis] -= pace * sample.gradient[axis];
            sample = surface.field(point);
        }
        points.add(point);
    }
}

}  // namespace plateau
