#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "session/session.h"

namespace plateau {

/// All files below hold what step_mesh() gives and have its preconditions; without a complete step they are empty but
/// well-formed.
enum class MeshFormat : std::uint8_t { Ply, Off, Glb };

/// By the ending of a file's name: .ply, .off, .glb; a name without an ending, "-" for one, is PLY. Nothing for any
/// other ending.
std::optional<MeshFormat> mesh_format_of(std::string_view file_name);

std::string mesh_file(const Session& session, MeshFormat format, std::optional<Step> step);

/// Ascii PLY: vertices with 17 digits, edges, triangles.
std::string mesh_ply(const Session& session, std::optional<Step> step);

/// Object file format: vertices with 17 digits, then edges as faces of two corners, then triangles.
std::string mesh_off(const Session& session, std::optional<Step> step);

/// Binary glTF 2.0. Positions are single precision around the middle of the mesh, at most 1 in magnitude; translation
/// and scale of the node, a power of two, bring them back into input units. A surface has one primitive of triangles
/// with normals, a complex one each of points, lines and triangles. The extras of the node tell step, epsilon, family
/// and Betti numbers.
std::string mesh_glb(const Session& session, std::optional<Step> step);

}  // namespace plateau
