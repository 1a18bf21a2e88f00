#pragma once

#include <optional>
#include <string>

#include "session/session.h"

namespace plateau {

/// Comma-separated values, a line a complete step under a line of names:
/// step (1-based), landmark (0-based input index), epsilon (17 digits), family as shown, beta0, beta1, ...
std::string betti_csv(const Session& session);

/// `{"plateaus":[{"first_step","last_step","epsilon_first","epsilon_last","betti","family","length"}]}` in step order;
/// length = ln(ratio). Ends with a line end.
std::string plateaus_json(const Session& session);

/// Comma-separated values of family dilated with pumping, a line a complete step under a line of names: step, landmark
/// (0-based input index), omega (the weight, input units), the smallest sliver measure in its star before and after,
/// events, the relative amplitude of all weights so far, and how many landmarks are hidden.
std::string pumps_csv(const Session& session);

/// Why a run has no mesh: its witnesses have no place in the plane or in space, or straight lines between them are not
/// what its metric has as edges. InvalidOption.
std::optional<Error> mesh_objection(const Session& session);

/// The step at which a mesh is written when none is named: the middle of the longest plateau, else the last step; 0
/// before the first.
Step default_mesh_step(const Session& session);

/// Ascii PLY of the step: where a surface is shown, its closed mesh; else all landmarks so far with the edges and
/// triangles of the shown complex. Points of the plane get z = 0. Without a complete step the mesh is empty.
/// Preconditions: no mesh_objection(); 1 <= step <= step_count().
std::string mesh_ply(const Session& session, std::optional<Step> step);

/// The plateaus for a person, longest first, three significant digits; at most 20 lines of them.
std::string plateau_table(const Session& session);

/// `count` points from the 0-based index `first` as text, a line a point, 17 digits: reading it gives the same bits.
/// Precondition: first + count <= size.
std::string cloud_xyz(const PointCloud& cloud, std::uint32_t first, std::uint32_t count);

}  // namespace plateau
