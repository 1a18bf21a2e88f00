#include "comparison.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <ostream>
#include <set>
#include <utility>

#include "laws.h"
#include "session/session.h"

namespace plateau {

using reference::Reference;
using reference::Settings;
using reference::ShownFamily;
using reference::Simplex;
using reference::StepState;

namespace {

bool same_bits(double a, double b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

/// The first difference between two sets, as seen from the engine.
template <class Item, class Print>
std::string difference(const std::set<Item>& engine, const std::set<Item>& expected, const Print& print) {
    for (const Item& item : expected) {
        if (engine.count(item) == 0) return "the engine lacks " + print(item);
    }
    for (const Item& item : engine) {
        if (expected.count(item) == 0) return "the engine has too many: " + print(item);
    }
    return "";
}

std::string complex_difference(const Timeline& timeline, const StepState& expected, Step step) {
    if (static_cast<std::size_t>(timeline.track_count) != expected.tracks.size()) return "other number of tracks";
    for (int track = 0; track < timeline.track_count; ++track) {
        for (int k = 1; k <= static_cast<int>(timeline.dimension); ++k) {
            std::set<Simplex> living;
            for (const SimplexIndex s : timeline.living(k, track, step)) {
                const auto tuple = timeline.table(k).tuple(s);
                living.insert(Simplex(tuple.begin(), tuple.end()));
            }
            const auto& simplices = expected.tracks[static_cast<std::size_t>(track)][static_cast<std::size_t>(k)];
            const std::string text = difference(living, simplices, reference::print);
            if (!text.empty()) return "track " + std::to_string(track) + ": " + text;
        }
    }
    return "";
}

/// The outer boundary as the engine's rows name it and as its mesh glues it.
std::string surface_difference(const PointCloud& cloud, const Timeline& timeline, const StepState& expected,
                               Step step) {
    std::set<reference::Row> rows;
    for (const std::uint32_t r : timeline.surface_rows(step)) {
        const SurfaceRow& row = timeline.surface[r];
        const auto tuple = timeline.table(2).tuple(row.triangle);
        rows.insert({Simplex(tuple.begin(), tuple.end()), row.side});
    }
    const reference::Surface& surface = expected.surface;
    const auto print_row = [](const reference::Row& row) {
        return "surface triangle " + reference::print(row.triangle) + " side " + std::to_string(row.side);
    };
    const std::string text = difference(rows, {surface.rows.begin(), surface.rows.end()}, print_row);
    if (!text.empty()) return text;
    if (rows.size() != timeline.surface_rows(step).size()) return "a surface triangle twice";

    const SurfaceMesh mesh = surface_mesh(cloud, timeline, step);
    const std::vector<int> betti = surface.betti();
    const std::string complaint = mesh_is_valid(mesh, std::vector<std::uint32_t>(betti.begin(), betti.end()));
    if (!complaint.empty() && !surface.rows.empty()) return complaint;
    if (mesh.triangles.size() != surface.rows.size()) return "the mesh has another number of triangles";
    // Both give each corner of each row a vertex; they must agree up to a renaming.
    std::map<std::uint32_t, int> to_reference;
    std::map<int, std::uint32_t> from_reference;
    for (const auto& triangle : mesh.triangles) {
        std::map<int, std::uint32_t> vertex_at;  // by landmark
        for (const std::uint32_t v : triangle) vertex_at[static_cast<int>(mesh.vertex_landmark[v])] = v;
        reference::Row row;
        std::vector<std::uint32_t> ascending;
        for (const auto& [landmark, v] : vertex_at) {
            row.triangle.push_back(landmark);
            ascending.push_back(v);
        }
        if (ascending.size() != 3) return "a mesh triangle without three landmarks";
        const auto place = std::find(triangle.begin(), triangle.end(), ascending[0]) - triangle.begin();
        row.side = triangle[static_cast<std::size_t>((place + 1) % 3)] == ascending[1] ? 0 : 1;
        const auto found = std::lower_bound(surface.rows.begin(), surface.rows.end(), row);
        if (found == surface.rows.end() || !(*found == row)) return "the mesh has no " + print_row(row);
        const auto& corners = surface.corners[static_cast<std::size_t>(found - surface.rows.begin())];
        for (std::size_t v = 0; v < 3; ++v) {
            if (to_reference.emplace(ascending[v], corners[v]).first->second != corners[v] ||
                from_reference.emplace(corners[v], ascending[v]).first->second != ascending[v]) {
                return "the mesh glues vertices differently at " + print_row(row);
            }
        }
    }
    return "";
}

std::string step_difference(const PointCloud& cloud, const Timeline& timeline, const StepState& expected, Step step) {
    const std::size_t i = step - 1;
    if (timeline.landmarks[i] != static_cast<std::uint32_t>(expected.landmark)) {
        return "landmark " + std::to_string(timeline.landmarks[i]) + " instead of " + std::to_string(expected.landmark);
    }
    if (!same_bits(timeline.epsilon(step), std::sqrt(expected.epsilon_squared))) return "other epsilon";
    if (timeline.delaunay_dimension[i] != expected.delaunay_dimension) return "other dimension of D(L)";
    std::string text = complex_difference(timeline, expected, step);
    const bool has_surface = timeline.family == Family::Surface || timeline.family == Family::Auto;
    if (text.empty() && has_surface) text = surface_difference(cloud, timeline, expected, step);
    if (!text.empty()) return text;
    if (timeline.shown_family[i] != family_of(expected.shown)) return "shows another family";
    const auto betti = timeline.betti_at(step);
    if (!std::equal(betti.begin(), betti.end(), expected.betti.begin(), expected.betti.end())) {
        return "Betti numbers " + joined(betti) + " instead of " + joined(expected.betti);
    }
    return "";
}

std::string plateau_difference(const std::vector<Plateau>& engine, const std::vector<reference::PlateauRun>& expected) {
    if (engine.size() != expected.size()) return "other number of plateaus";
    for (std::size_t i = 0; i < engine.size(); ++i) {
        const Plateau& a = engine[i];
        const reference::PlateauRun& b = expected[i];
        const bool same_steps =
            a.first_step == static_cast<Step>(b.first_step) && a.last_step == static_cast<Step>(b.last_step);
        const bool same_betti = std::equal(a.betti.begin(), a.betti.end(), b.betti.begin(), b.betti.end());
        const bool same_ratio = std::abs(a.ratio - b.ratio) <= 1e-12 * b.ratio;
        if (!same_steps || !same_betti || a.family != family_of(b.family)) return "plateau " + std::to_string(i);
        if (!same_ratio) return "ratio of plateau " + std::to_string(i) + ": " + joined(std::array{a.ratio, b.ratio});
    }
    return "";
}

RunOptions options_of(const Settings& settings, int first, int max_steps) {
    RunOptions options;
    options.max_steps = static_cast<std::uint32_t>(max_steps);
    options.family = family_of(settings.family);
    options.nu.assign(settings.nu.begin(), settings.nu.end());
    options.first = static_cast<std::uint32_t>(first);
    options.rho = settings.rho;
    options.field = static_cast<std::uint32_t>(settings.prime);
    return options;
}

bool compared(int step, int steps, int stride) {
    return steps <= 60 || step <= 12 || step % stride == 0 || step == steps;
}

}  // namespace

Family family_of(ShownFamily family) {
    switch (family) {
        case ShownFamily::Witness:
            return Family::Witness;
        case ShownFamily::Delaunay:
            return Family::Delaunay;
        case ShownFamily::Surface:
            return Family::Surface;
        case ShownFamily::Auto:
            return Family::Auto;
    }
    return Family::Auto;
}

std::string name_of(ShownFamily family) {
    const char* const names[] = {"witness", "delaunay", "surface", "auto"};
    return names[static_cast<std::size_t>(family)];
}

std::ostream& operator<<(std::ostream& out, const FamilyCase& value) {
    return out << value.cloud.name << ", " << name_of(value.family);
}

std::string name_of(const FamilyCase& value) {
    return value.cloud.name + "_" + name_of(value.family);
}

std::vector<FamilyCase> family_cases() {
    std::vector<FamilyCase> cases;
    for (const TestCloud& cloud : test_clouds()) {
        cases.push_back({cloud, ShownFamily::Witness});
        cases.push_back({cloud, ShownFamily::Delaunay});
        if (cloud.cloud.dimension == 2) continue;
        cases.push_back({cloud, ShownFamily::Surface});
        cases.push_back({cloud, ShownFamily::Auto});
    }
    return cases;
}

std::string run_difference(const PointCloud& cloud, Reference& expected, const Settings& settings, int first,
                           int max_steps, int stride) {
    auto opened = Session::open(cloud, options_of(settings, first, max_steps));
    if (!opened) return "refused: " + opened.error().message;
    Session session = std::move(opened).value();
    const Progress progress = session.run({});
    const Timeline& timeline = session.timeline();
    if (progress.state != RunState::Finished) return "not finished";
    if (timeline.step_count != static_cast<Step>(expected.step_count())) {
        return std::to_string(timeline.step_count) + " steps instead of " + std::to_string(expected.step_count());
    }
    const std::string complaint = timeline_is_valid(timeline);
    std::vector<StepState> states;
    const int steps = expected.step_count();
    for (int step = 1; step <= steps; ++step) {
        if (!compared(step, steps, stride)) continue;
        states.push_back(expected.state(settings, step));
        const std::string text = step_difference(cloud, timeline, states.back(), static_cast<Step>(step));
        if (!text.empty()) return "step " + std::to_string(step) + ": " + text;
    }
    if (!complaint.empty()) return "law: " + complaint;
    if (states.size() < static_cast<std::size_t>(steps)) return "";
    return plateau_difference(session.plateaus(), reference::plateaus(states));
}

}  // namespace plateau
