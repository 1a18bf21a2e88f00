#include "cloud/samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>

#include "base/hash.h"
#include "cloud/implicit_surface.h"

namespace plateau {
namespace {

PointCloud sampled(std::string_view name, const SampleOptions& options) {
    auto result = sample_shape(name, options);
    EXPECT_TRUE(result) << result.error().message;
    return std::move(result).value();
}

std::uint64_t bits(const PointCloud& cloud) {
    Fnv1a64 hash;
    hash.add_u32(cloud.dimension);
    for (const double coordinate : cloud.coordinates) hash.add_f64(coordinate);
    return hash.value();
}

double torus_residual(std::span<const double> p) {
    const double outward = std::sqrt(p[0] * p[0] + p[1] * p[1]) - 1;
    return std::sqrt(outward * outward + p[2] * p[2]) - 0.4;
}

double norm(double x, double y) {
    return std::sqrt(x * x + y * y);
}

double beyond(double x, double low, double high) {
    return std::max(0.0, std::max(low - x, x - high));
}

/// A surface with a border, or a manifold in more dimensions.
double manifold_residual(std::string_view name, std::span<const double> p) {
    const double around = norm(p[0], p[1]);
    if (name == "disk") return std::abs(p[2]) + beyond(around, 0, 1);
    if (name == "annulus") return std::abs(p[2]) + beyond(around, 0.5, 1);
    if (name == "hemisphere") return std::abs(norm(around, p[2]) - 1) + beyond(p[2], 0, 1);
    if (name == "mobius") {
        // Across the band at half of the angle: (outward, up) is along (cos, sin) of it.
        const double half = std::atan2(p[1], p[0]) / 2;
        return std::abs((around - 1) * std::sin(half) - p[2] * std::cos(half)) + beyond(norm(around - 1, p[2]), 0, 0.4);
    }
    if (name == "clifford") return std::abs(around - 1) + std::abs(norm(p[2], p[3]) - 1);
    if (name == "two-scales") return std::abs(around - 1) + std::abs(norm(p[2], p[3]) - 0.25);
    if (name == "klein") {
        const double half = std::atan2(p[1], p[0]) / 2;
        return std::abs(norm(around - 1, norm(p[2], p[3])) - 0.5) +
               std::abs(p[2] * std::sin(half) - p[3] * std::cos(half));
    }
    if (name == "s3") return norm(norm(p[0], p[1]), norm(p[2], p[3])) - 1;
    if (name == "rp2") {
        // With a = xy, b = xz, c = y^2 - z^2, d = 2 yz: d (a^2 - b^2) = 2 a b c, and x^2 = 1 - |(c, d)|.
        const double x_squared = 1 - norm(p[2], p[3]);
        return std::abs(p[3] * (p[0] * p[0] - p[1] * p[1]) - 2 * p[0] * p[1] * p[2]) +
               std::abs(p[0] * p[0] + p[1] * p[1] - x_squared * (1 - x_squared));
    }
    if (name == "s2xs1") return std::abs(norm(around, p[2]) - 1) + std::abs(norm(p[3], p[4]) - 1);
    if (name == "so3") {
        double off = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) {
                double product = i == j ? -1 : 0;
                for (std::size_t k = 0; k < 3; ++k) product += p[3 * i + k] * p[3 * j + k];
                off += std::abs(product);
            }
        }
        const double determinant = p[0] * (p[4] * p[8] - p[5] * p[7]) - p[1] * (p[3] * p[8] - p[5] * p[6]) +
                                   p[2] * (p[3] * p[7] - p[4] * p[6]);
        return off + std::abs(determinant - 1);
    }
    ADD_FAILURE() << "no equation for " << name;
    return 1;
}

/// 0 on the shape, by another formula than the generator's where there is one.
double residual(std::string_view name, std::span<const double> p) {
    const double radius =
        p.size() == 2 ? std::sqrt(p[0] * p[0] + p[1] * p[1]) : std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    if (name == "circle-noise") return std::max(0.0, std::abs(radius - 1) - 0.05);
    if (name == "nested-circles") return std::min(std::abs(radius - 1), std::abs(radius - 0.4));
    if (name == "sphere") return radius - 1;
    if (name == "torus" || name == "helix") return torus_residual(p);
    if (name == "tanglecube") return tanglecube_field({p[0], p[1], p[2]}).value;
    if (name == "double-torus") return double_torus_field({p[0], p[1], p[2]}).value;
    if (name == "trefoil") {
        // With s = x^2 + y^2 = 5 - 4 cos 3t and z = -sin 3t.
        const double cosine = (5 - p[0] * p[0] - p[1] * p[1]) / 4;
        return cosine * cosine + p[2] * p[2] - 1;
    }
    if (name == "swiss-roll") {
        const double turns = std::sqrt(p[0] * p[0] + p[1] * p[1]) * 2.25;
        const double angle = std::atan2(p[1], p[0]) / 6.283185307179586 - turns;
        return (angle - std::round(angle)) + (std::abs(p[2]) <= 0.75 ? 0 : 1) + (turns < 0.75 || turns > 2.25);
    }
    if (name == "corner-curve") {
        // Fold the plane by the star's fivefold symmetry and mirror onto one side, from a tip to an inner corner.
        const double tenth = 0.6283185307179586;
        double angle = std::abs(std::remainder(std::atan2(p[0], p[1]), 2 * tenth));
        const double x = radius * std::cos(angle);
        const double y = radius * std::sin(angle);
        const double inner_x = 0.45 * std::cos(tenth);
        const double inner_y = 0.45 * std::sin(tenth);
        return (x - 1) * inner_y - y * (inner_x - 1);
    }
    return manifold_residual(name, p);
}

TEST(Samples, EveryShapeOfTheContractInItsOrder) {
    const std::vector<std::string> names = {
        "circle-noise", "nested-circles", "corner-curve", "sphere", "torus",      "double-torus", "helix",
        "tanglecube",   "trefoil",        "swiss-roll",   "disk",   "hemisphere", "mobius",       "annulus",
        "clifford",     "klein",          "s3",           "rp2",    "two-scales", "s2xs1",        "so3"};
    const std::map<std::string_view, std::uint32_t> in_more_dimensions = {
        {"clifford", 4}, {"klein", 4}, {"s3", 4}, {"rp2", 4}, {"two-scales", 4}, {"s2xs1", 5}, {"so3", 9}};
    ASSERT_EQ(sample_shapes().size(), names.size());
    for (std::size_t k = 0; k < names.size(); ++k) {
        const SampleShape& shape = sample_shapes()[k];
        EXPECT_EQ(shape.name, names[k]);
        const auto more = in_more_dimensions.find(shape.name);
        EXPECT_EQ(shape.dimension, more != in_more_dimensions.end() ? more->second : k < 3 ? 2u : 3u);
        EXPECT_GE(shape.default_size, 1000u);
        EXPECT_TRUE(shape.look_for.ends_with(".")) << shape.name;
    }
}

TEST(Samples, SameBitsOnEveryMachine) {
    const std::map<std::string_view, std::uint64_t> golden = {
        {"circle-noise", 0x42fe1a45490d5cb2ull}, {"nested-circles", 0xe8b8c43a280b9323ull},
        {"corner-curve", 0x1e1eab6ecd8ba0a2ull}, {"sphere", 0x8acd3d0d6a4a21fdull},
        {"torus", 0x0e3cc628cfa02133ull},        {"double-torus", 0x2f2dd3202bc0ef80ull},
        {"helix", 0x6630135caa049451ull},        {"tanglecube", 0xac8aed55a8b97cddull},
        {"trefoil", 0x24b479000f96e5b0ull},      {"swiss-roll", 0xb1682d000a38175eull},
        {"disk", 0x02283c86f8cc229dull},         {"hemisphere", 0xc946456a5efb6b50ull},
        {"mobius", 0x66b10d0b33077e88ull},       {"annulus", 0x50a40b46c66ed4d2ull},
        {"clifford", 0xf2b726b37e8b18b7ull},     {"klein", 0x2c645237bd7a6e51ull},
        {"s3", 0xf37654553749beb1ull},           {"rp2", 0x52618854b3cbcac5ull},
        {"two-scales", 0x1490cf0217dfa0fdull},   {"s2xs1", 0x02e764e28fb65057ull},
        {"so3", 0x25abc3b2109a5eabull},
    };
    for (const SampleShape& shape : sample_shapes()) {
        ASSERT_TRUE(golden.contains(shape.name)) << shape.name;
        EXPECT_EQ(bits(sampled(shape.name, {.size = 200, .noise = 0, .seed = 1})), golden.at(shape.name))
            << shape.name << " 0x" << std::hex << bits(sampled(shape.name, {.size = 200, .noise = 0, .seed = 1}));
    }
    EXPECT_EQ(bits(sampled("torus", {.size = 200, .noise = 0.1, .seed = 7})), 0xbac147a9a7a72d83ull)
        << std::hex << bits(sampled("torus", {.size = 200, .noise = 0.1, .seed = 7}));
}

TEST(Samples, PointsLieOnTheShape) {
    for (const SampleShape& shape : sample_shapes()) {
        for (const std::uint32_t size : {1u, 2u, 3u, 2000u}) {
            const PointCloud cloud = sampled(shape.name, {.size = size, .noise = 0, .seed = 3});
            ASSERT_EQ(cloud.dimension, shape.dimension);
            ASSERT_EQ(cloud.size(), size);
            for (std::uint32_t k = 0; k < size; ++k) {
                ASSERT_NEAR(residual(shape.name, cloud.point(k)), 0, 1e-12) << shape.name << " point " << k;
            }
        }
    }
}

TEST(Samples, GradientsOfTheFieldsAreTheirDerivatives) {
    for (const ScalarField field : {&tanglecube_field, &double_torus_field}) {
        Random random(5);
        for (int k = 0; k < 200; ++k) {
            Vector3 p{};
            for (double& coordinate : p) coordinate = random.next_between(-1.5, 1.5);
            const FieldSample here = field(p);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                Vector3 ahead = p;
                Vector3 behind = p;
                ahead[axis] += 1e-6;
                behind[axis] -= 1e-6;
                EXPECT_NEAR((field(ahead).value - field(behind).value) / 2e-6, here.gradient[axis], 1e-4);
            }
        }
    }
}

TEST(Samples, BoxesHoldTheImplicitSurfaces) {
    // A point cut off by the box would pile the sample up at its faces.
    for (const auto& [name, low_x, high_x, high_z] :
         {std::tuple{"tanglecube", -2.35, 2.35, 2.35}, std::tuple{"double-torus", -1.45, 2.45, 0.45}}) {
        const PointCloud cloud = sampled(name, {.size = 20'000, .noise = 0, .seed = 2});
        for (std::uint32_t k = 0; k < cloud.size(); ++k) {
            EXPECT_GT(cloud.point(k)[0], low_x);
            EXPECT_LT(cloud.point(k)[0], high_x);
            EXPECT_LT(std::abs(cloud.point(k)[2]), high_z);
        }
    }
}

TEST(Samples, TorusIsUniformByArea) {
    // The outer half of a torus (beyond R) has the share 1/2 + r / (pi R).
    const PointCloud cloud = sampled("torus", {.size = 40'000, .noise = 0, .seed = 4});
    double outer = 0;
    for (std::uint32_t k = 0; k < cloud.size(); ++k) {
        const auto p = cloud.point(k);
        outer += p[0] * p[0] + p[1] * p[1] > 1;
    }
    EXPECT_NEAR(outer / cloud.size(), 0.5 + 0.4 / 3.14159265, 0.01);
}

TEST(Samples, KleinBottleAndMobiusBandAreUniformByArea) {
    // Shares of the outer half by the integral of the lengths along both angles.
    const auto share = [](auto&& area_at, double low, double high, auto&& is_outer) {
        double outer = 0;
        double all = 0;
        for (int i = 0; i < 400; ++i) {
            for (int j = 0; j < 400; ++j) {
                const double u = 6.283185307179586 * (i + 0.5) / 400;
                const double v = low + (high - low) * (j + 0.5) / 400;
                all += area_at(u, v);
                if (is_outer(u, v)) outer += area_at(u, v);
            }
        }
        return outer / all;
    };
    const auto found = [](const char* name) {
        const PointCloud cloud = sampled(name, {.size = 40'000, .noise = 0, .seed = 4});
        double outer = 0;
        for (std::uint32_t k = 0; k < cloud.size(); ++k) outer += norm(cloud.point(k)[0], cloud.point(k)[1]) > 1;
        return outer / cloud.size();
    };
    EXPECT_NEAR(found("klein"),
                share([](double, double v) { return norm(1 + 0.5 * std::cos(v), 0.25 * std::sin(v)); }, 0,
                      6.283185307179586, [](double, double v) { return std::cos(v) > 0; }),
                0.01);
    EXPECT_NEAR(found("mobius"),
                share([](double u, double s) { return norm(1 + s * std::cos(u / 2), s / 2); }, -0.4, 0.4,
                      [](double u, double s) { return s * std::cos(u / 2) > 0; }),
                0.01);
}

TEST(Samples, NoTwoPointsNearlyCoincide) {
    // Half of the mean spacing for the random surfaces and curves; a purely random sample would be far below.
    for (const auto& [name, spacing] :
         {std::pair{"torus", 0.5 * std::sqrt(15.79 / 2000)}, std::pair{"sphere", 0.5 * std::sqrt(12.566 / 2000)},
          std::pair{"tanglecube", 0.5 * std::sqrt(101.0 / 2000)},
          std::pair{"circle-noise", 0.5 * std::sqrt(0.628 / 2000)},
          std::pair{"nested-circles", 0.49 * 6.283 * 1.4 / 2000}}) {
        const PointCloud cloud = sampled(name, {.size = 2000, .noise = 0, .seed = 6});
        double least = 1e9;
        for (std::uint32_t a = 0; a < cloud.size(); ++a) {
            for (std::uint32_t b = 0; b < a; ++b) {
                least = std::min(least, std::sqrt(distance_squared(cloud.point(a), cloud.point(b))));
            }
        }
        EXPECT_GT(least, spacing * 0.999) << name;
    }
}

TEST(SpreadPoints, AlwaysFillsUp) {
    SpreadPoints points(2, 10, 1);
    int tries = 0;
    while (!points.full()) {
        points.add({0.25, 0.5, 0});
        ASSERT_LT(++tries, 5000);
    }
    EXPECT_EQ(points.take().size(), 20u);
}

TEST(Samples, NoiseIsABallOfItsRadiusAndMovesNothingElse) {
    for (const SampleShape& shape : sample_shapes()) {
        const PointCloud clean = sampled(shape.name, {.size = 3000, .noise = 0, .seed = 9});
        const PointCloud noisy = sampled(shape.name, {.size = 3000, .noise = 0.25, .seed = 9});
        double largest = 0;
        double inner_half = 0;
        for (std::uint32_t k = 0; k < clean.size(); ++k) {
            const double distance = std::sqrt(distance_squared(clean.point(k), noisy.point(k)));
            EXPECT_LE(distance, 0.25 * (1 + 1e-9));
            largest = std::max(largest, distance);
            inner_half += distance < 0.125;
        }
        EXPECT_GT(largest, 0.24) << shape.name;
        EXPECT_NEAR(inner_half / clean.size(), std::pow(0.5, shape.dimension), 0.03) << shape.name;
    }
}

TEST(Samples, SeedsDiffer) {
    for (const SampleShape& shape : sample_shapes()) {
        std::set<std::uint64_t> seen;
        for (const std::uint64_t seed : {0ull, 1ull, 2ull, ~0ull}) {
            seen.insert(bits(sampled(shape.name, {.size = 50, .noise = 0.01, .seed = seed})));
        }
        EXPECT_EQ(seen.size(), 4u) << shape.name;
    }
}

TEST(Samples, CurvesWithoutNoiseIgnoreTheSeed) {
    for (const char* name : {"helix", "trefoil"}) {
        EXPECT_EQ(bits(sampled(name, {.size = 50, .noise = 0, .seed = 1})),
                  bits(sampled(name, {.size = 50, .noise = 0, .seed = 2})));
    }
}

TEST(Samples, Errors) {
    const auto unknown = sample_shape("cube", {});
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().code, ErrorCode::InvalidOption);
    for (const SampleShape& shape : sample_shapes()) {
        EXPECT_NE(unknown.error().message.find(shape.name), std::string::npos) << unknown.error().message;
    }
    EXPECT_EQ(sample_shape("torus", {.size = 0}).error().code, ErrorCode::InvalidOption);
    EXPECT_EQ(sample_shape("torus", {.size = 10'000'001}).error().code, ErrorCode::InvalidOption);
    for (const double noise :
         {-1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_EQ(sample_shape("torus", {.size = 5, .noise = noise}).error().code, ErrorCode::InvalidOption);
    }
}

}  // namespace
}  // namespace plateau
