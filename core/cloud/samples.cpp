#include "cloud/samples.h"

#include <array>
#include <cmath>
#include <string>

#include "base/random.h"
#include "cloud/implicit_surface.h"
#include "cloud/trigonometry.h"

namespace plateau {
namespace {

constexpr std::uint32_t kMaxSampleSize = 10'000'000;
constexpr double kTorusLarge = 1;
constexpr double kTorusSmall = 0.4;

using Coordinates = std::vector<double>;
using Generator = void (*)(std::uint32_t size, Random& random, Coordinates& coordinates);

struct NamedGenerator {
    SampleShape shape;
    Generator generate;
};

/// Adds a uniform vector of the ball of the given radius to the last `dimension` numbers: rejection from the cube.
void add_ball_noise(std::uint32_t dimension, double radius, Random& random, double* point) {
    std::array<double, 3> offset{};
    double norm_squared = 2;
    while (norm_squared > 1) {
        norm_squared = 0;
        for (std::uint32_t axis = 0; axis < dimension; ++axis) {
            offset[axis] = random.next_between(-1, 1);
            norm_squared += offset[axis] * offset[axis];
        }
    }
    for (std::uint32_t axis = 0; axis < dimension; ++axis) point[axis] += radius * offset[axis];
}

/// k / n of a turn times `winding`, reduced in integers so that the angle is exact up to one division.
SineCosine winding_angle(std::uint32_t k, std::uint32_t n, std::uint64_t winding) {
    return sine_cosine_of_turns(static_cast<double>(winding * k % n) / n);
}

void circle_noise(std::uint32_t size, Random& random, Coordinates& out) {
    constexpr double kBuiltInNoise = 0.05;
    for (std::uint32_t k = 0; k < size; ++k) {
        const SineCosine angle = sine_cosine_of_turns(random.next_unit());
        out.insert(out.end(), {angle.cosine, angle.sine});
        add_ball_noise(2, kBuiltInNoise, random, &out[out.size() - 2]);
    }
}

void nested_circles(std::uint32_t size, Random& random, Coordinates& out) {
    constexpr double kInnerRadius = 0.4;
    for (std::uint32_t k = 0; k < size; ++k) {
        const double radius = random.next_unit() * (1 + kInnerRadius) < 1 ? 1 : kInnerRadius;
        const SineCosine angle = sine_cosine_of_turns(random.next_unit());
        out.insert(out.end(), {radius * angle.cosine, radius * angle.sine});
    }
}

/// A five-pointed star; one random point in each of n stretches of equal length, so that it is dense without ties.
void corner_curve(std::uint32_t size, Random& random, Coordinates& out) {
    constexpr std::uint32_t kCorners = 10;
    constexpr double kInnerRadius = 0.45;
    std::array<std::array<double, 2>, kCorners> corners{};
    for (std::uint32_t k = 0; k < kCorners; ++k) {
        const double radius = k % 2 == 0 ? 1 : kInnerRadius;
        const SineCosine angle = winding_angle(k, kCorners, 1);
        corners[k] = {radius * angle.sine, radius * angle.cosine};  // one tip upwards
    }
    for (std::uint32_t k = 0; k < size; ++k) {
        const double position = (k + random.next_unit()) / size * kCorners;  // all sides have the same length
        std::uint32_t side = static_cast<std::uint32_t>(position);
        if (side >= kCorners) side = kCorners - 1;
        const double along = position - side;
        const auto& from = corners[side];
        const auto& to = corners[(side + 1) % kCorners];
        for (std::size_t axis = 0; axis < 2; ++axis) out.push_back(from[axis] + along * (to[axis] - from[axis]));
    }
}

void sphere(std::uint32_t size, Random& random, Coordinates& out) {
    for (std::uint32_t k = 0; k < size;) {
        const double x = random.next_between(-1, 1);
        const double y = random.next_between(-1, 1);
        const double z = random.next_between(-1, 1);
        const double norm_squared = x * x + y * y + z * z;
        if (norm_squared > 1 || norm_squared < 0.01) continue;  // too near the center the direction is rounded
        const double norm = std::sqrt(norm_squared);
        out.insert(out.end(), {x / norm, y / norm, z / norm});
        ++k;
    }
}

/// The point of the torus at an angle around the axis and one around the tube.
void append_on_torus(const SineCosine& around_axis, const SineCosine& around_tube, Coordinates& out) {
    const double to_axis = kTorusLarge + kTorusSmall * around_tube.cosine;
    out.insert(out.end(), {to_axis * around_axis.cosine, to_axis * around_axis.sine, kTorusSmall * around_tube.sine});
}

/// Uniform by area, which is proportional to the distance from the axis: rejection.
void torus(std::uint32_t size, Random& random, Coordinates& out) {
    for (std::uint32_t k = 0; k < size;) {
        const SineCosine tube = sine_cosine_of_turns(random.next_unit());
        const double height = random.next_unit() * (kTorusLarge + kTorusSmall);
        if (height > kTorusLarge + kTorusSmall * tube.cosine) continue;
        const SineCosine axis = sine_cosine_of_turns(random.next_unit());
        append_on_torus(axis, tube, out);
        ++k;
    }
}

void double_torus(std::uint32_t size, Random& random, Coordinates& out) {
    append_uniform_on({double_torus_field, {-1.5, -1.5, -0.5}, {2.5, 1.5, 0.5}, 0.01}, size, random, out);
}

void helix(std::uint32_t size, Random&, Coordinates& out) {
    constexpr std::uint64_t kWindings = 17;
    for (std::uint32_t k = 0; k < size; ++k) {
        append_on_torus(winding_angle(k, size, 1), winding_angle(k, size, kWindings), out);
    }
}

void tanglecube(std::uint32_t size, Random& random, Coordinates& out) {
    append_uniform_on({tanglecube_field, {-2.4, -2.4, -2.4}, {2.4, 2.4, 2.4}, 0.02}, size, random, out);
}

void trefoil(std::uint32_t size, Random&, Coordinates& out) {
    for (std::uint32_t k = 0; k < size; ++k) {
        const SineCosine once = winding_angle(k, size, 1);
        const SineCosine twice = winding_angle(k, size, 2);
        const SineCosine thrice = winding_angle(k, size, 3);
        out.insert(out.end(), {once.sine + 2 * twice.sine, once.cosine - 2 * twice.cosine, -thrice.sine});
    }
}

/// A sheet rolled one and a half turns, uniform by area: the spiral's speed at t turns is sqrt(1 + (2 pi t)^2).
void swiss_roll(std::uint32_t size, Random& random, Coordinates& out) {
    constexpr double kInnerTurn = 0.75;
    constexpr double kOuterTurn = 2.25;
    constexpr double kHalfWidth = 0.75;
    const auto speed = [](double turns) {
        const double angle = kTwoPi * turns;
        return std::sqrt(1 + angle * angle);
    };
    for (std::uint32_t k = 0; k < size;) {
        const double turns = random.next_between(kInnerTurn, kOuterTurn);
        const double height = random.next_unit() * speed(kOuterTurn);
        if (height > speed(turns)) continue;
        const double across = random.next_between(-kHalfWidth, kHalfWidth);
        const SineCosine angle = sine_cosine_of_turns(turns);
        const double radius = turns / kOuterTurn;
        out.insert(out.end(), {radius * angle.cosine, radius * angle.sine, across});
        ++k;
    }
}

constexpr std::array<NamedGenerator, 10> kGenerators = {{
    {{"circle-noise", 2, 1000, "One loop, seen through noise: one piece and one hole until the noise itself shows."},
     circle_noise},
    {{"nested-circles", 2, 1000, "Two loops, one inside the other: two pieces and two holes."}, nested_circles},
    {{"corner-curve", 2, 1000, "One loop with sharp corners: a star of one piece and one hole."}, corner_curve},
    {{"sphere", 3, 3000, "A closed surface without a handle: one piece and one cavity."}, sphere},
    {{"torus", 3, 5000, "A ring: one piece, two independent loops and one cavity."}, torus},
    {{"double-torus", 3, 15000, "A ring with a large hole first; closer by, a second, small handle appears."},
     double_torus},
    {{"helix", 3, 3000, "Two answers: from afar the ring that the curve winds on, closer by the curve itself."}, helix},
    {{"tanglecube", 3, 15000, "A cube of tubes with five handles: ten independent loops and one cavity."}, tanglecube},
    {{"trefoil", 3, 3000, "A knotted loop: knotted or not, it is one piece with one hole."}, trefoil},
    {{"swiss-roll", 3, 5000, "A rolled sheet: a surface with a border, one piece without a hole."}, swiss_roll},
}};

constexpr auto kShapes = [] {
    std::array<SampleShape, kGenerators.size()> shapes{};
    for (std::size_t k = 0; k < shapes.size(); ++k) shapes[k] = kGenerators[k].shape;
    return shapes;
}();

Error unknown_shape(std::string_view name) {
    std::string message = "There is no shape \"" + std::string(name) + "\"; the shapes are";
    for (const NamedGenerator& known : kGenerators) {
        message += (&known == &kGenerators.front() ? " " : ", ") + std::string(known.shape.name);
    }
    return {ErrorCode::InvalidOption, message + "."};
}

}  // namespace

std::span<const SampleShape> sample_shapes() {
    return kShapes;
}

Result<PointCloud> sample_shape(std::string_view name, const SampleOptions& options) {
    const NamedGenerator* found = nullptr;
    for (const NamedGenerator& known : kGenerators) {
        if (known.shape.name == name) found = &known;
    }
    if (found == nullptr) return unknown_shape(name);
    if (options.size == 0 || options.size > kMaxSampleSize) {
        return Error{ErrorCode::InvalidOption,
                     "The number of points must be between 1 and 10000000, not " + std::to_string(options.size) + "."};
    }
    if (!(options.noise >= 0) || options.noise > kMaxCoordinate) {
        return Error{ErrorCode::InvalidOption, "The noise is a radius: a finite number that is not negative."};
    }
    PointCloud cloud;
    cloud.dimension = found->shape.dimension;
    cloud.coordinates.reserve(static_cast<std::size_t>(options.size) * cloud.dimension);
    Random random(options.seed);
    found->generate(options.size, random, cloud.coordinates);
    if (options.noise > 0) {
        // A stream of its own: the noiseless points stay the same whatever the noise.
        Random noise_random(~options.seed);
        for (std::uint32_t k = 0; k < cloud.size(); ++k) {
            double* point = cloud.coordinates.data() + static_cast<std::size_t>(k) * cloud.dimension;
            add_ball_noise(cloud.dimension, options.noise, noise_random, point);
        }
    }
    return cloud;
}

}  // namespace plateau
