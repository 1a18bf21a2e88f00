#pragma once

#include <cstdint>
#include <vector>

#include "base/random.h"

namespace plateau {

/// Rows of coordinates: points of manifolds in more than three dimensions, and of surfaces with a border in space.
/// All uniform by area or volume but for rp2, which is uniform on the sphere that covers it.
using SampleGenerator = std::vector<double> (*)(std::uint32_t size, Random& random);

/// In R^4: the flat torus (cos a, sin a, cos b, sin b).
std::vector<double> sample_clifford(std::uint32_t size, Random& random);
/// In R^4: a Klein bottle, a circle of radius 1/2 that makes half a turn while it goes around one of radius 1.
std::vector<double> sample_klein(std::uint32_t size, Random& random);
/// In R^4: the unit sphere.
std::vector<double> sample_s3(std::uint32_t size, Random& random);
/// In R^4: the projective plane, (xy, xz, y^2 - z^2, 2yz) of the unit sphere.
std::vector<double> sample_rp2(std::uint32_t size, Random& random);
/// In R^4: the product of a circle of radius 1 and one of radius 1/4. From afar a circle, closer by a torus.
std::vector<double> sample_two_scales(std::uint32_t size, Random& random);
/// In R^5: the product of the unit sphere and the unit circle.
std::vector<double> sample_s2xs1(std::uint32_t size, Random& random);
/// In R^9: all rotations of space, as matrices row by row.
std::vector<double> sample_so3(std::uint32_t size, Random& random);
/// In R^3: the unit disk; the upper half of the unit sphere; a band of width 0.8 with half a turn around the unit
/// circle; the ring between the circles of radius 0.5 and 1.
std::vector<double> sample_disk(std::uint32_t size, Random& random);
std::vector<double> sample_hemisphere(std::uint32_t size, Random& random);
std::vector<double> sample_mobius(std::uint32_t size, Random& random);
std::vector<double> sample_annulus(std::uint32_t size, Random& random);

}  // namespace plateau
