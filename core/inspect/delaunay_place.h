#pragma once

#include <span>
#include <vector>

#include "base/result.h"
#include "cloud/point_cloud.h"
#include "complex/simplex_table.h"

namespace plateau {

/// Whether a simplex is in D(L), and what shows it if not.
struct DelaunayPlace {
    bool is_in = false;
    bool is_flat = false;  ///< its vertices lie on a line, or in a plane, that is too small for them: no ball has them
    /// Landmarks that keep it out, nearest first: no ball has the vertices on its boundary and none of these inside,
    /// and each of them is needed for that. One for a simplex of full dimension: it lies in the only ball; one more for
    /// each missing dimension at most. "Inside" counts ties on the boundary as the perturbation of D(L) does.
    std::vector<Step> blockers;
};

/// Exact for the landmarks given as rows (by step - 1), plane or space. Removing landmarks can only bring a simplex in,
/// so a few of them near the simplex settle it: either it is out of their triangulation, or it has a cell there whose
/// ball holds none of the others, seen with a wide margin. Only what rounding leaves in doubt, at the hull mostly,
/// takes all of them. Cost: O(i log i) to sort them by distance, and a triangulation of some dozens; of all at the
/// worst. Errors: those of Delaunay::insert().
Result<DelaunayPlace> delaunay_place(const PointCloud& landmarks, std::span<const Step> simplex);

}  // namespace plateau
