#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/result.h"
#include "plane/plane_cells.h"
#include "plane/plane_complex.h"

namespace plateau {

/// The witnesses of simplices, one simplex after the other.
struct WitnessLists {
    std::vector<std::uint32_t> witnesses;  ///< rows of the scene, ascending for each simplex
    std::vector<std::uint32_t> first{0};   ///< of each simplex, and one more: the number of entries
};

/// All that is drawn of a scene; see PlaneComplex and plane_cells.h.
struct PlanePicture {
    std::vector<PlaneComplex::Edge> delaunay_edges;
    std::vector<PlaneComplex::Triangle> delaunay_triangles;
    std::uint32_t list_length = 0;
    std::vector<Step> lists;
    std::vector<Step> vertices;
    std::vector<PlaneComplex::Edge> edges;
    std::vector<PlaneComplex::Triangle> triangles;
    std::array<WitnessLists, 3> witnesses;  ///< of vertices, edges, triangles; each has at least one
    std::array<std::uint32_t, 2> betti{};
    PlanePolygons cells;
    PlanePolygons pair_cells;
};

/// Errors: those of PlaneComplex, InvalidOption for a box without area. Cost: a few ms for 200 witnesses and 40
/// landmarks, in the module too.
Result<PlanePicture> plane_picture(const PlaneScene& scene, const PlaneBox& box);

/// Why the simplex of these landmarks is in the complex of the scene, or why not. Step and lifespan are
/// left at 0.
Result<Inspection> plane_why(const PlaneScene& scene, std::vector<Step> vertices);

}  // namespace plateau
