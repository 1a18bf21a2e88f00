#include "io/step_mesh.h"

#include <algorithm>

#include "io/exact_text.h"
#include "io/family_name.h"
#include "surface/surface_mesh.h"

namespace plateau {
namespace {

StepMesh complex_at(const Timeline& timeline, Step step) {
    StepMesh mesh;
    for (Step landmark = 1; landmark <= step; ++landmark) mesh.vertex_landmark.push_back(landmark);
    const int track = timeline.shown_track(step);
    for (const SimplexIndex index : timeline.living(1, track, step)) {
        const auto edge = timeline.table(1).tuple(index);
        mesh.edges.push_back({edge[0] - 1, edge[1] - 1});
    }
    for (const SimplexIndex index : timeline.living(2, track, step)) {
        const auto triangle = timeline.table(2).tuple(index);
        mesh.triangles.push_back({triangle[0] - 1, triangle[1] - 1, triangle[2] - 1});
    }
    return mesh;
}

StepMesh surface_at(const Session& session, Step step) {
    SurfaceMesh surface = surface_mesh(session.cloud(), session.timeline(), step);
    StepMesh mesh;
    mesh.is_surface = true;
    mesh.vertex_landmark = std::move(surface.vertex_landmark);
    mesh.triangles = std::move(surface.triangles);
    return mesh;
}

}  // namespace

StepMesh step_mesh(const Session& session, std::optional<Step> step) {
    const Timeline& timeline = session.timeline();
    const Step at = step.value_or(default_mesh_step(session));
    if (at == 0) return {};
    const bool is_surface = timeline.shown_family[at - 1] == Family::Surface;
    StepMesh mesh = is_surface ? surface_at(session, at) : complex_at(timeline, at);
    mesh.step = at;
    return mesh;
}

std::optional<Error> mesh_objection(const Session& session) {
    const Metric metric = session.options().metric.metric;
    const std::uint32_t dimension = session.cloud().dimension;
    std::string why;
    if (metric == Metric::Matrix) why = "distances have no place in space.";
    if (metric == Metric::Periodic)
        why = "edges that leave the box on one side and come back on the other cannot be drawn.";
    if (metric == Metric::Projective) why = "edges between lines are no straight lines between points.";
    if (dimension > 3) why = "points with " + std::to_string(dimension) + " coordinates have no place in space.";
    if (why.empty()) return std::nullopt;
    return Error{ErrorCode::InvalidOption, "There is no mesh of this run: " + why};
}

Step default_mesh_step(const Session& session) {
    const std::vector<Plateau> plateaus = session.plateaus();
    if (plateaus.empty()) return session.timeline().step_count;
    return middle_step(session.timeline(), plateaus[ranked(plateaus).front()]);
}

std::array<double, 3> vertex_position(const Session& session, const StepMesh& mesh, std::size_t vertex) {
    const Step landmark = mesh.vertex_landmark[vertex];
    const auto point = session.cloud().point(session.timeline().landmarks[landmark - 1]);
    std::array<double, 3> position{};
    std::copy(point.begin(), point.end(), position.begin());
    return position;
}

std::string step_remark(const Session& session, Step step) {
    const Timeline& timeline = session.timeline();
    return "Plateau, step " + std::to_string(step) + ", epsilon " + exact(timeline.epsilon(step)) + ", family " +
           std::string(family_name(timeline.shown_family[step - 1])) + ", Betti numbers " +
           joined(timeline.betti_at(step), " ");
}

}  // namespace plateau
