#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "session/session.h"

namespace plateau {

/// What one step shows, for files of meshes.
struct StepMesh {
    Step step = 0;                                        ///< 0: no step is complete, the mesh is empty
    bool is_surface = false;                              ///< closed and oriented, without edges of its own
    std::vector<Step> vertex_landmark;                    ///< the landmark at which each vertex lies
    std::vector<std::array<std::uint32_t, 2>> edges;      ///< 0-based vertices
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< 0-based vertices; of a surface counter-clockwise
};

/// Where a surface is shown, its closed mesh; else all landmarks so far with the edges and triangles of the shown
/// complex. Without a step: that of default_mesh_step(). Preconditions: no mesh_objection(); 1 <= step <= step_count().
StepMesh step_mesh(const Session& session, std::optional<Step> step);

/// Why a run has no mesh: its witnesses have no place in the plane or in space, or straight lines between them are not
/// what its metric has as edges. InvalidOption.
std::optional<Error> mesh_objection(const Session& session);

/// The step at which a mesh is written when none is named: the middle of the longest plateau, else the last step; 0
/// before the first.
Step default_mesh_step(const Session& session);

/// Where the vertex lies, in input units; points of the plane get z = 0.
std::array<double, 3> vertex_position(const Session& session, const StepMesh& mesh, std::size_t vertex);

/// "Plateau, step 12, epsilon 0.5, family surface, Betti numbers 1 2 1", for remarks in files.
std::string step_remark(const Session& session, Step step);

}  // namespace plateau
