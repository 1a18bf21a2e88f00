#pragma once

#include <cstdint>
#include <vector>

#include "cloud/point_cloud.h"
#include "timeline/timeline.h"

namespace plateau {

/// One component of the extracted surface, a closed surface of its own.
struct SurfacePart {
    std::uint32_t vertices = 0, edges = 0, triangles = 0;
    std::int64_t euler_characteristic = 0;  ///< vertices - edges + triangles = 2 - 2 genus
    std::uint32_t genus = 0;
    double area = 0;    ///< input units squared
    double volume = 0;  ///< input units cubed, positive where it is enclosed
};

/// A landmark at which the surface meets itself.
struct DoubledVertex {
    Step landmark = 0;
    std::uint32_t copies = 0;  ///< vertices of the surface there, at least 2
};

/// An edge along which the surface meets itself.
struct DoubledEdge {
    Step u = 0, v = 0;         ///< u < v
    std::uint32_t copies = 0;  ///< edges of the surface there, at least 2
};

/// The extracted surface of one step in numbers.
struct SurfaceReport {
    std::vector<SurfacePart> parts;               ///< by falling area
    std::vector<DoubledVertex> doubled_vertices;  ///< in order
    std::vector<DoubledEdge> doubled_edges;       ///< in order
    double area = 0, volume = 0;                  ///< of all parts
};

/// Of a complete step; without parts where the surface is empty. Duplicates are those of surface_mesh(). Numbers that
/// double cannot hold are not finite. Cost: O(rows so far).
SurfaceReport surface_report(const PointCloud& cloud, const Timeline& timeline, Step step);

}  // namespace plateau
