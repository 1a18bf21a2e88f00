#include "io/writers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "io/family_name.h"
#include "surface/surface_mesh.h"

namespace plateau {
namespace {

/// Enough digits that reading gives the same bits. Shortest forms need to_chars, which one library lacks for double.
std::string exact(double number) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.17g", number);
    return text.data();
}

std::string three_digits(double number) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.3g", number);
    return text.data();
}

std::string joined(std::span<const std::uint32_t> numbers, std::string_view separator) {
    std::string text;
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        if (k > 0) text += separator;
        text += std::to_string(numbers[k]);
    }
    return text;
}

/// The parts of a PLY file.
struct Mesh {
    std::vector<Step> vertex_landmark;
    std::vector<std::array<std::uint32_t, 2>> edges;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Landmarks so far, edges and triangles of the complex that the step shows.
Mesh complex_at(const Timeline& timeline, Step step) {
    Mesh mesh;
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

Mesh surface_at(const Session& session, Step step) {
    SurfaceMesh surface = surface_mesh(session.cloud(), session.timeline(), step);
    Mesh mesh;
    mesh.vertex_landmark = std::move(surface.vertex_landmark);
    mesh.triangles = std::move(surface.triangles);
    return mesh;
}

std::string ply_header(const Session& session, Step step, const Mesh& mesh) {
    std::string text = "ply\nformat ascii 1.0\n";
    if (step > 0) {
        const Timeline& timeline = session.timeline();
        text += "comment Plateau, step " + std::to_string(step) + ", epsilon " + exact(timeline.epsilon(step)) +
                ", family " + std::string(family_name(timeline.shown_family[step - 1])) + ", Betti numbers " +
                joined(timeline.betti_at(step), " ") + "\n";
    }
    text += "element vertex " + std::to_string(mesh.vertex_landmark.size()) + "\n";
    text += "property double x\nproperty double y\nproperty double z\n";
    if (!mesh.edges.empty()) {
        text += "element edge " + std::to_string(mesh.edges.size()) + "\nproperty int vertex1\nproperty int vertex2\n";
    }
    text += "element face " + std::to_string(mesh.triangles.size()) + "\n";
    return text + "property list uchar int vertex_indices\nend_header\n";
}

}  // namespace

std::string betti_csv(const Session& session) {
    const Timeline& timeline = session.timeline();
    std::string text = "step,landmark,epsilon,family";
    for (std::uint32_t k = 0; k < timeline.dimension; ++k) text += ",beta" + std::to_string(k);
    text += '\n';
    for (Step step = 1; step <= timeline.step_count; ++step) {
        text += std::to_string(step) + ',' + std::to_string(timeline.landmarks[step - 1]) + ',' +
                exact(timeline.epsilon(step)) + ',';
        text += family_name(timeline.shown_family[step - 1]);
        text += ',' + joined(timeline.betti_at(step), ",") + '\n';
    }
    return text;
}

std::string pumps_csv(const Session& session) {
    const Timeline& timeline = session.timeline();
    std::string text = "step,landmark,omega,sliver_before,sliver_after,events,amplitude,hidden\n";
    std::size_t hidden = 0;
    for (Step step = 1; step <= timeline.pumps.size(); ++step) {
        const Pump& pump = timeline.pumps[step - 1];
        while (hidden < timeline.hidden.size() && timeline.hidden[hidden].from <= step) ++hidden;
        text += std::to_string(step) + ',' + std::to_string(timeline.landmarks[step - 1]) + ',' +
                exact(std::sqrt(pump.weight_squared)) + ',' + exact(pump.before) + ',' + exact(pump.after) + ',' +
                std::to_string(pump.events) + ',' + exact(pump.amplitude) + ',' + std::to_string(hidden) + '\n';
    }
    return text;
}

std::string plateaus_json(const Session& session) {
    std::string text = "{\"plateaus\":[";
    const char* separator = "\n";
    for (const Plateau& plateau : session.plateaus()) {
        text += separator;
        text += "{\"first_step\":" + std::to_string(plateau.first_step) +
                ",\"last_step\":" + std::to_string(plateau.last_step) +
                ",\"epsilon_first\":" + exact(plateau.epsilon_first) +
                ",\"epsilon_last\":" + exact(plateau.epsilon_last) + ",\"betti\":[" + joined(plateau.betti, ",") +
                "],\"family\":\"";
        text += family_name(plateau.family);
        text += "\",\"length\":" + exact(plateau.length()) + "}";
        separator = ",\n";
    }
    return text + "\n]}\n";
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

std::string mesh_ply(const Session& session, std::optional<Step> step) {
    const Timeline& timeline = session.timeline();
    const PointCloud& cloud = session.cloud();
    const Step at = step.value_or(default_mesh_step(session));
    Mesh mesh;
    if (at > 0) {
        const bool is_surface = timeline.shown_family[at - 1] == Family::Surface;
        mesh = is_surface ? surface_at(session, at) : complex_at(timeline, at);
    }
    std::string text = ply_header(session, at, mesh);
    for (const Step landmark : mesh.vertex_landmark) {
        const auto point = cloud.point(timeline.landmarks[landmark - 1]);
        text += exact(point[0]) + ' ' + exact(point[1]) + ' ' + (point.size() > 2 ? exact(point[2]) : "0") + '\n';
    }
    for (const auto& edge : mesh.edges) text += joined(edge, " ") + '\n';
    for (const auto& triangle : mesh.triangles) text += "3 " + joined(triangle, " ") + '\n';
    return text;
}

std::string cloud_xyz(const PointCloud& cloud, std::uint32_t first, std::uint32_t count) {
    std::string text;
    for (std::uint32_t k = first; k < first + count; ++k) {
        const auto point = cloud.point(k);
        for (std::size_t axis = 0; axis < point.size(); ++axis) {
            text += exact(point[axis]);
            text += axis + 1 < point.size() ? ' ' : '\n';
        }
    }
    return text;
}

std::string plateau_table(const Session& session) {
    constexpr std::size_t kMostRows = 20;
    const std::vector<Plateau> plateaus = session.plateaus();
    const std::vector<std::uint32_t> order = ranked(plateaus);
    const std::size_t shown = std::min(order.size(), kMostRows);
    if (shown == 0) return "No plateau: no step has a complex.\n";
    constexpr std::size_t kColumns = 6;
    using Row = std::array<std::string, kColumns>;
    std::vector<Row> rows = {{"length", "epsilon", "1/epsilon", "steps", "family", "Betti numbers"}};
    for (std::size_t k = 0; k < shown; ++k) {
        const Plateau& plateau = plateaus[order[k]];
        const auto range = [](const std::string& from, const std::string& to) { return from + " to " + to; };
        const auto inverse = [](double epsilon) { return epsilon > 0 ? three_digits(1 / epsilon) : "beyond"; };
        rows.push_back({three_digits(plateau.length()),
                        range(three_digits(plateau.epsilon_first), three_digits(plateau.epsilon_last)),
                        range(inverse(plateau.epsilon_first), inverse(plateau.epsilon_last)),
                        range(std::to_string(plateau.first_step), std::to_string(plateau.last_step)),
                        std::string(family_name(plateau.family)), "(" + joined(plateau.betti, ", ") + ")"});
    }
    std::array<std::size_t, kColumns> widths{};
    for (const Row& row : rows) {
        for (std::size_t column = 0; column < kColumns; ++column) {
            widths[column] = std::max(widths[column], row[column].size());
        }
    }
    std::string text;
    for (const Row& row : rows) {
        for (std::size_t column = 0; column + 1 < kColumns; ++column) {
            text += row[column] + std::string(widths[column] - row[column].size() + 2, ' ');
        }
        text += row.back() + '\n';
    }
    if (shown < order.size()) text += "and " + std::to_string(order.size() - shown) + " shorter ones\n";
    return text;
}

}  // namespace plateau
