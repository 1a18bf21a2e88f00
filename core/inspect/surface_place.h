#pragma once

#include <cstdint>
#include <span>

#include "surface/landmark_points.h"
#include "timeline/timeline.h"

namespace plateau {

/// Where a simplex of the complex is with respect to the surface that is extracted from it [GO 3.2.2].
enum class SurfacePlace : std::uint8_t {
    NoSurface = 0,  ///< none is shown at that step
    On = 1,         ///< it is a triangle of the surface, or an edge or vertex of one
    Inside = 2,     ///< of kept triangles, that is without sharp edges, but shut off from infinity on both sides
    Peeled = 3,     ///< of triangles that hang on sharp edges only
    TooLong = 4,    ///< of triangles whose radius-edge ratio exceeds rho
    Bare = 5,       ///< an edge or vertex without a triangle
    Solid = 6,      ///< a tetrahedron; the surface has triangles only
};

/// The place of a simplex of the complex of track 0, vertices ascending, at a step. The kept triangles are found anew.
/// Cost: O(triangles and rows so far), and O(degree^2) exact signs an edge.
SurfacePlace surface_place(const Timeline& timeline, const LandmarkPoints& points, double rho, Step step,
                           std::span<const Step> simplex);

}  // namespace plateau
