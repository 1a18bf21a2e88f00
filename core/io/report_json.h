#pragma once

#include <optional>
#include <string>

#include "session/session.h"

namespace plateau {

/// Why a run has no report of its surface: its family follows none. InvalidOption.
std::optional<Error> report_objection(const Session& session);

/// The extracted surface of one step as JSON, ending with a line end: step, epsilon, components (0: it is empty),
/// genus (of all together), euler_characteristic, vertices, edges, triangles, area, volume; `parts`, the largest first,
/// with the same numbers each; doubled_vertices [{landmark, step, copies}] and doubled_edges [{landmarks, steps,
/// copies}], where the surface meets itself (landmark: 0-based input index). null where a number is too large for
/// double. Without a step: that of default_mesh_step(); before the first step the surface is empty.
/// Preconditions: no report_objection(); 1 <= step <= step_count().
std::string surface_report_json(const Session& session, std::optional<Step> step);

}  // namespace plateau
