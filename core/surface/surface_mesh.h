#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/result.h"
#include "cloud/point_cloud.h"
#include "timeline/timeline.h"

namespace plateau {

/// The extracted surface of one step as a closed oriented triangle mesh; vertices and edges of the outer boundary that
/// are met twice are duplicated [GO 3.2.2 step 4]: each triangle side is glued to exactly one other. Two glued edges
/// can join the same two vertices (solids that touch along an edge); a reader that knows edges by their ends alone sees
/// four triangles there.
struct SurfaceMesh {
    std::vector<Step> vertex_landmark;                    ///< the landmark at which each mesh vertex lies
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< 0-based mesh vertices, counter-clockwise from outside
};

/// The surface of a complete step; empty where the surface is empty. Cost: O(rows so far).
SurfaceMesh surface_mesh(const PointCloud& cloud, const Timeline& timeline, Step step);

}  // namespace plateau
