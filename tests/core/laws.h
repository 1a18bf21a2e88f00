#pragma once

#include <string>

#include "surface/surface_mesh.h"
#include "timeline/timeline.h"

namespace plateau {

/// Laws that every run obeys, whatever its size. Each function returns an empty string or the first complaint.

/// The record as a whole: tuples ascending and sorted, indices by step right, no death before its birth, faces outlive
/// their simplices, the log of deaths equal to the deaths in the tables, rows disjoint in time and inside the life of
/// their triangles, epsilon falling; and at every step Euler-Poincare, at every step of a short run and at some fifty
/// of a long one a surface that is closed and oriented. Cost: O(record log record).
std::string timeline_is_valid(const Timeline& timeline);

/// A surface mesh that is closed and oriented, has no unused vertex, and whose components and Euler characteristic
/// give the Betti vector (beta_0, beta_1, beta_2).
std::string mesh_is_valid(const SurfaceMesh& mesh, std::span<const std::uint32_t> betti);

}  // namespace plateau
