#include "io/report_json.h"

#include <array>
#include <string_view>

#include "io/exact_text.h"
#include "io/family_name.h"
#include "io/step_mesh.h"
#include "surface/surface_report.h"

namespace plateau {
namespace {

/// The numbers that a part and the whole have in common.
std::string numbers_of(const SurfacePart& part) {
    return "\"genus\":" + std::to_string(part.genus) +
           ",\"euler_characteristic\":" + std::to_string(part.euler_characteristic) +
           ",\"vertices\":" + std::to_string(part.vertices) + ",\"edges\":" + std::to_string(part.edges) +
           ",\"triangles\":" + std::to_string(part.triangles) + ",\"area\":" + exact_or_null(part.area) +
           ",\"volume\":" + exact_or_null(part.volume);
}

/// An array, an item a line.
template <class Items, class Print>
std::string listed(std::string_view name, const Items& items, Print print) {
    std::string text = ",\n\"" + std::string(name) + "\":[";
    const char* separator = "\n";
    for (const auto& item : items) {
        text += separator + print(item);
        separator = ",\n";
    }
    return text + (items.empty() ? "]" : "\n]");
}

}  // namespace

std::optional<Error> report_objection(const Session& session) {
    const Family family = session.timeline().family;
    if (family == Family::Auto || family == Family::Surface) return std::nullopt;
    return Error{ErrorCode::InvalidOption, "There is no surface to report of: family " +
                                               std::string(family_name(family)) +
                                               " follows none; take auto or surface, for points in space."};
}

std::string surface_report_json(const Session& session, std::optional<Step> step) {
    const Timeline& timeline = session.timeline();
    const Step at = step.value_or(default_mesh_step(session));
    const SurfaceReport report = at > 0 ? surface_report(session.cloud(), timeline, at) : SurfaceReport{};
    SurfacePart all;
    for (const SurfacePart& part : report.parts) {
        all.genus += part.genus;
        all.euler_characteristic += part.euler_characteristic;
        all.vertices += part.vertices;
        all.edges += part.edges;
        all.triangles += part.triangles;
    }
    all.area = report.area;
    all.volume = report.volume;

    const auto input_index = [&](Step landmark) { return timeline.landmarks[landmark - 1]; };
    std::string text = "{\"step\":" + std::to_string(at) +
                       ",\"epsilon\":" + (at > 0 ? exact(timeline.epsilon(at)) : "null") +
                       ",\"components\":" + std::to_string(report.parts.size()) + "," + numbers_of(all);
    text += listed("parts", report.parts, [](const SurfacePart& part) { return "{" + numbers_of(part) + "}"; });
    text += listed("doubled_vertices", report.doubled_vertices, [&](const DoubledVertex& vertex) {
        return "{\"landmark\":" + std::to_string(input_index(vertex.landmark)) +
               ",\"step\":" + std::to_string(vertex.landmark) + ",\"copies\":" + std::to_string(vertex.copies) + "}";
    });
    text += listed("doubled_edges", report.doubled_edges, [&](const DoubledEdge& edge) {
        const std::array<std::uint32_t, 2> landmarks = {input_index(edge.u), input_index(edge.v)};
        const std::array<std::uint32_t, 2> steps = {edge.u, edge.v};
        return "{\"landmarks\":[" + joined(landmarks, ",") + "],\"steps\":[" + joined(steps, ",") +
               "],\"copies\":" + std::to_string(edge.copies) + "}";
    });
    return text + "}\n";
}

}  // namespace plateau
