#pragma once

#include <optional>
#include <string>

#include "session/session.h"

namespace plateau {

/// Legacy VTK, version 3.0, binary: an unstructured grid of the shown complex at the step (of a surface: the complex
/// that it was extracted from). Points: the landmarks so far, by step; up to three coordinates as they are, of more the
/// first three principal axes, of a distance matrix those of classical scaling, as the page draws them. Cells: a vertex
/// for each landmark that is one, then edges, triangles and tetrahedra; simplices of more than four vertices have no
/// cell there.
///
/// Point data: `input_index` (0-based), `step`; with more than three coordinates all of them as `coordinates`.
/// Cell data: `dimension`, `birth`, `death`, so that a cell is in the complex at step i exactly for birth <= i < death;
/// 2147483647 is the death of what lives at the last computed step.
/// Without a step: that of default_mesh_step(). Precondition: 1 <= step <= step_count().
std::string complex_vtk(const Session& session, std::optional<Step> step);

}  // namespace plateau
