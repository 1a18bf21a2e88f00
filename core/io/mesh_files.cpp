#include "io/mesh_files.h"

#include "io/exact_text.h"
#include "io/step_mesh.h"
#include "io/text.h"

namespace plateau {
namespace {

std::string ply_header(const Session& session, const StepMesh& mesh) {
    std::string text = "ply\nformat ascii 1.0\n";
    if (mesh.step > 0) text += "comment " + step_remark(session, mesh.step) + "\n";
    text += "element vertex " + std::to_string(mesh.vertex_landmark.size()) + "\n";
    text += "property double x\nproperty double y\nproperty double z\n";
    if (!mesh.edges.empty()) {
        text += "element edge " + std::to_string(mesh.edges.size()) + "\nproperty int vertex1\nproperty int vertex2\n";
    }
    text += "element face " + std::to_string(mesh.triangles.size()) + "\n";
    return text + "property list uchar int vertex_indices\nend_header\n";
}

void append_vertices(std::string& text, const Session& session, const StepMesh& mesh) {
    for (std::size_t vertex = 0; vertex < mesh.vertex_landmark.size(); ++vertex) {
        const auto [x, y, z] = vertex_position(session, mesh, vertex);
        text += exact(x) + ' ' + exact(y) + ' ' + exact(z) + '\n';
    }
}

}  // namespace

std::optional<MeshFormat> mesh_format_of(std::string_view file_name) {
    const std::size_t slash = file_name.rfind('/');
    const std::size_t point = file_name.rfind('.');
    if (point == std::string_view::npos || (slash != std::string_view::npos && point < slash)) return MeshFormat::Ply;
    const std::string ending = lower_case(file_name.substr(point + 1));
    if (ending == "ply") return MeshFormat::Ply;
    if (ending == "off") return MeshFormat::Off;
    if (ending == "glb") return MeshFormat::Glb;
    return std::nullopt;
}

std::string mesh_file(const Session& session, MeshFormat format, std::optional<Step> step) {
    switch (format) {
        case MeshFormat::Off:
            return mesh_off(session, step);
        case MeshFormat::Glb:
            return mesh_glb(session, step);
        case MeshFormat::Ply:
            break;
    }
    return mesh_ply(session, step);
}

std::string mesh_ply(const Session& session, std::optional<Step> step) {
    const StepMesh mesh = step_mesh(session, step);
    std::string text = ply_header(session, mesh);
    append_vertices(text, session, mesh);
    for (const auto& edge : mesh.edges) text += joined(edge, " ") + '\n';
    for (const auto& triangle : mesh.triangles) text += "3 " + joined(triangle, " ") + '\n';
    return text;
}

std::string mesh_off(const Session& session, std::optional<Step> step) {
    const StepMesh mesh = step_mesh(session, step);
    std::string text = "OFF\n";
    if (mesh.step > 0) text += "# " + step_remark(session, mesh.step) + "\n";
    text += std::to_string(mesh.vertex_landmark.size()) + ' ' +
            std::to_string(mesh.edges.size() + mesh.triangles.size()) + " 0\n";
    append_vertices(text, session, mesh);
    for (const auto& edge : mesh.edges) text += "2 " + joined(edge, " ") + '\n';
    for (const auto& triangle : mesh.triangles) text += "3 " + joined(triangle, " ") + '\n';
    return text;
}

}  // namespace plateau
