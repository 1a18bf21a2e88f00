#include "cloud/samples.h"

#include <array>
#include <cmath>
#include <string>

#include "base/random.h"
#include "cloud/implicit_surface.h"
#include "cloud/manifold_samples.h"
#include "cloud/spread_points.h"
#include "cloud/trigonometry.h"

namespace plateau {
namespace {

constexpr std::uint32_t kMaxSampleSize = 10'000'000;
constexpr std::size_t kMostCoordinates = 9;
constexpr double kTorusLarge = 1;
constexpr double kTorusSmall = 0.4;

using Coordinates = std::vector<double>;
struct NamedGenerator {
    SampleShape shape;
    SampleGenerator generator;
};

/// Adds a uniform vector of the ball of the given radius to the last `dimension` numbers: rejection from the cube.
void add_ball_noise(std::uint32_t dimension, double radius, Random& random, double* point) {
    std::array<double, kMostCoordinates> offset{};
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

Coordinates circle_noise(std::uint32_t size, Random& random) {
    constexpr double kBuiltInNoise = 0.05;
    SpreadPoints points(2, size, kTwoPi * 2 * kBuiltInNoise);
    while (!points.full()) {
        const SineCosine angle = sine_cosine_of_turns(random.next_unit());
        Vector3 point = {angle.cosine, angle.sine, 0};
        add_ball_noise(2, kBuiltInNoise, random, point.data());
        points.add(point);
    }
    return points.take();
}

/// A random place in the middle half of the k-th of n stretches, as a part of the whole: dense, without ties and
/// without near coincidences.
double place_along(std::uint32_t k, std::uint32_t n, Random& random) {
    return (k + random.next_between(0.25, 0.75)) / n;
}

Coordinates nested_circles(std::uint32_t size, Random& random) {
    constexpr double kInnerRadius = 0.4;
    const auto inner = static_cast<std::uint32_t>(size * (kInnerRadius / (1 + kInnerRadius)));
    Coordinates out;
    for (std::uint32_t k = 0; k < size; ++k) {
        const bool is_inner = k < inner;
        const double radius = is_inner ? kInnerRadius : 1;
        const double place = is_inner ? place_along(k, inner, random) : place_along(k - inner, size - inner, random);
        const SineCosine angle = sine_cosine_of_turns(place);
        out.insert(out.end(), {radius * angle.cosine, radius * angle.sine});
    }
    return out;
}

/// A five-pointed star.
Coordinates corner_curve(std::uint32_t size, Random& random) {
    constexpr std::uint32_t kCorners = 10;
    constexpr double kInnerRadius = 0.45;
    std::array<std::array<double, 2>, kCorners> corners{};
    for (std::uint32_t k = 0; k < kCorners; ++k) {
        const double radius = k % 2 == 0 ? 1 : kInnerRadius;
        const SineCosine angle = winding_angle(k, kCorners, 1);
        corners[k] = {radius * angle.sine, radius * angle.cosine};  // one tip upwards
    }
    Coordinates out;
    for (std::uint32_t k = 0; k < size; ++k) {
        const double position = place_along(k, size, random) * kCorners;  // all sides have the same length
        const auto side = static_cast<std::uint32_t>(position);           // below 10: places are at most 1 - 1 / (4 n)
        const double along = position - side;
        const auto& from = corners[side];
        const auto& to = corners[(side + 1) % kCorners];
        for (std::size_t axis = 0; axis < 2; ++axis) out.push_back(from[axis] + along * (to[axis] - from[axis]));
    }
    return out;
}

Coordinates sphere(std::uint32_t size, Random& random) {
    SpreadPoints points(3, size, 2 * kTwoPi);
    while (!points.full()) {
        const double x = random.next_between(-1, 1);
        const double y = random.next_between(-1, 1);
        const double z = random.next_between(-1, 1);
        const double norm_squared = x * x + y * y + z * z;
        if (norm_squared > 1 || norm_squared < 0.01) continue;  // too near the center the direction is rounded
        const double norm = std::sqrt(norm_squared);
        points.add({x / norm, y / norm, z / norm});
    }
    return points.take();
}

/// The point of the torus at an angle around the axis and one around the tube.
Vector3 on_torus(const SineCosine& around_axis, const SineCosine& around_tube) {
    const double to_axis = kTorusLarge + kTorusSmall * around_tube.cosine;
    return {to_axis * around_axis.cosine, to_axis * around_axis.sine, kTorusSmall * around_tube.sine};
}

/// Uniform by area, which is proportional to the distance from the axis: rejection.
Coordinates torus(std::uint32_t size, Random& random) {
    SpreadPoints points(3, size, kTwoPi * kTwoPi * kTorusLarge * kTorusSmall);
    while (!points.full()) {
        const SineCosine tube = sine_cosine_of_turns(random.next_unit());
        const double height = random.next_unit() * (kTorusLarge + kTorusSmall);
        if (height > kTorusLarge + kTorusSmall * tube.cosine) continue;
        const SineCosine axis = sine_cosine_of_turns(random.next_unit());
        points.add(on_torus(axis, tube));
    }
    return points.take();
}

Coordinates double_torus(std::uint32_t size, Random& random) {
    constexpr double kArea = 17;
    SpreadPoints points(3, size, kArea);
    fill_from({double_torus_field, {-1.5, -1.5, -0.5}, {2.5, 1.5, 0.5}, 0.01}, random, points);
    return points.take();
}

Coordinates helix(std::uint32_t size, Random&) {
    constexpr std::uint64_t kWindings = 17;
    Coordinates out;
    for (std::uint32_t k = 0; k < size; ++k) {
        const Vector3 point = on_torus(winding_angle(k, size, 1), winding_angle(k, size, kWindings));
        out.insert(out.end(), point.begin(), point.end());
    }
    return out;
}

Coordinates tanglecube(std::uint32_t size, Random& random) {
    constexpr double kArea = 101;
    SpreadPoints points(3, size, kArea);
    fill_from({tanglecube_field, {-2.4, -2.4, -2.4}, {2.4, 2.4, 2.4}, 0.02}, random, points);
    return points.take();
}

Coordinates trefoil(std::uint32_t size, Random&) {
    Coordinates out;
    for (std::uint32_t k = 0; k < size; ++k) {
        const SineCosine once = winding_angle(k, size, 1);
        const SineCosine twice = winding_angle(k, size, 2);
        const SineCosine thrice = winding_angle(k, size, 3);
        out.insert(out.end(), {once.sine + 2 * twice.sine, once.cosine - 2 * twice.cosine, -thrice.sine});
    }
    return out;
}

/// A sheet rolled one and a half turns, uniform by area: the spiral's speed at t turns is sqrt(1 + (2 pi t)^2).
Coordinates swiss_roll(std::uint32_t size, Random& random) {
    constexpr double kInnerTurn = 0.75;
    constexpr double kOuterTurn = 2.25;
    constexpr double kHalfWidth = 0.75;
    constexpr double kArea = 9.5;
    const auto speed = [](double turns) {
        const double angle = kTwoPi * turns;
        return std::sqrt(1 + angle * angle);
    };
    SpreadPoints points(3, size, kArea);
    while (!points.full()) {
        const double turns = random.next_between(kInnerTurn, kOuterTurn);
        const double height = random.next_unit() * speed(kOuterTurn);
        if (height > speed(turns)) continue;
        const double across = random.next_between(-kHalfWidth, kHalfWidth);
        const SineCosine angle = sine_cosine_of_turns(turns);
        const double radius = turns / kOuterTurn;
        points.add({radius * angle.cosine, radius * angle.sine, across});
    }
    return points.take();
}

constexpr std::array<NamedGenerator, 21> kGenerators = {{
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
    {{"swiss-roll", 3, 5000,
      "From afar a solid roll; a sheet with a border encloses nothing, so closer by no closed surface is left."},
     swiss_roll},
    {{"disk", 3, 15000, "A surface with a border, which encloses nothing: one piece and no hole."}, sample_disk},
    {{"hemisphere", 3, 15000, "A bowl: one piece, and neither a hole nor a cavity."}, sample_hemisphere},
    {{"mobius", 3, 15000, "A band with half a turn: one piece and one loop, whatever its one side."}, sample_mobius},
    {{"annulus", 3, 15000, "A flat ring: one piece and one loop."}, sample_annulus},
    {{"clifford", 4, 20000, "A flat torus in four dimensions: one piece, two loops and one cavity."}, sample_clifford},
    {{"klein", 4, 20000, "A Klein bottle: as the torus over Z/2, but only one loop and no cavity over Z/3."},
     sample_klein},
    {{"s3", 4, 20000, "A sphere of three dimensions: one piece and one cavity of the highest kind."}, sample_s3},
    {{"rp2", 4, 20000, "The projective plane: a loop and a cavity over Z/2, neither over Z/3."}, sample_rp2},
    {{"two-scales", 4, 20000, "Two answers in four dimensions: from afar a circle, closer by a torus."},
     sample_two_scales},
    {{"s2xs1", 5, 30000, "A sphere times a circle, in five dimensions: one loop, one cavity and their product."},
     sample_s2xs1},
    {{"so3", 9, 5000, "All rotations of space as matrices: over Z/2 one class in each dimension from 0 to 3."},
     sample_so3},
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
    Random random(options.seed);
    cloud.coordinates = found->generator(options.size, random);
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
