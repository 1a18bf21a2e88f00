#pragma once

#include <array>
#include <cstdint>

#include "base/random.h"
#include "cloud/spread_points.h"

namespace plateau {

using Vector3 = std::array<double, 3>;

/// A scalar field at a point, with its gradient. The surface is where the value is 0.
struct FieldSample {
    double value = 0;
    Vector3 gradient{};
};
using ScalarField = FieldSample (*)(const Vector3&);

/// x^4 - 5x^2 + y^4 - 5y^2 + z^4 - 5z^2 + 11.8: a cube of tubes, genus 5.
FieldSample tanglecube_field(const Vector3& point);

/// Two tori of unlike size in the plane z = 0, melted into one body of genus 2.
FieldSample double_torus_field(const Vector3& point);

/// An implicit surface and an axis-parallel box that holds it.
struct ImplicitSurface {
    ScalarField field = nullptr;
    Vector3 low{};
    Vector3 high{};
    double shell = 0;  ///< half thickness of the layer that is sampled, input units; small against the curvature radii
};

/// Fills `points` with points of the surface, uniform by area up to O(shell^2): uniform points of a thin layer, found
/// by rejection on |value| / |gradient|, carried onto the surface by Newton steps. Arithmetic: + - * / sqrt only.
void fill_from(const ImplicitSurface& surface, Random& random, SpreadPoints& points);

}  // namespace plateau
