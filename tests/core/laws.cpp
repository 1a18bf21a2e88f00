#include "laws.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

namespace plateau {
namespace {

using Tuple = std::vector<Step>;

std::string print(std::span<const Step> tuple) {
    std::string text = "[";
    for (const Step vertex : tuple) text += (text.size() > 1 ? " " : "") + std::to_string(vertex);
    return text + "]";
}

std::string at_step(Step step) {
    return " at step " + std::to_string(step);
}

/// [s] = first element whose step is at least s, for s = 0 .. step_count + 1.
template <class Index, class StepOf>
std::string index_complaint(const std::vector<Index>& first, std::size_t size, Step step_count, const StepOf& step_of) {
    if (first.size() < std::size_t{step_count} + 2) return "index by step too short";
    for (std::size_t s = 0; s < first.size(); ++s) {
        const std::size_t place = first[s];
        if (place > size) return "index by step beyond the end" + at_step(static_cast<Step>(s));
        if (place < size && step_of(place) < s) return "index by step too early" + at_step(static_cast<Step>(s));
        if (place > 0 && step_of(place - 1) >= s) return "index by step too late" + at_step(static_cast<Step>(s));
    }
    return "";
}

std::string steps_complaint(const Timeline& timeline) {
    const std::size_t steps = timeline.step_count;
    if (timeline.landmarks.size() < steps || timeline.epsilons.size() < steps ||
        timeline.delaunay_dimension.size() < steps || timeline.shown_family.size() < steps ||
        timeline.betti.size() < steps * timeline.dimension) {
        return "a complete step lacks an entry";
    }
    if (timeline.simplices.size() != timeline.dimension) return "not one table a dimension";
    std::set<std::uint32_t> used;
    for (std::size_t i = 0; i < steps; ++i) {
        const Step step = static_cast<Step>(i + 1);
        if (!used.insert(timeline.landmarks[i]).second) return "a landmark twice" + at_step(step);
        if (!(timeline.epsilons[i] >= 0)) return "epsilon is not a distance" + at_step(step);
        if (timeline.epsilons[i] == 0 && step < steps) return "went on after epsilon = 0" + at_step(step);
        if (timeline.shown_family[i] == Family::Auto) return "shown family auto" + at_step(step);
        if (i == 0) continue;
        if (timeline.epsilons[i] > timeline.epsilons[i - 1]) return "epsilon rose" + at_step(step);
        if (timeline.delaunay_dimension[i] < timeline.delaunay_dimension[i - 1]) {
            return "the dimension of D(L) fell" + at_step(step);
        }
    }
    return "";
}

std::string table_complaint(const SimplexTable& table, int dimension, int track_count, Step step_count) {
    if (table.dimension != dimension) return "wrong dimension";
    const auto by_birth = [&](SimplexIndex s) {
        return std::make_pair(table.birth(s), Tuple(table.tuple(s).begin(), table.tuple(s).end()));
    };
    for (SimplexIndex s = 0; s < table.size(); ++s) {
        const auto tuple = table.tuple(s);
        if (tuple[0] == 0) return "vertex 0 in " + print(tuple);
        for (std::size_t v = 1; v < tuple.size(); ++v) {
            if (tuple[v - 1] >= tuple[v]) return "not ascending: " + print(tuple);
        }
        if (s > 0 && !(by_birth(s - 1) < by_birth(s))) return "not sorted: " + print(tuple);
        if (table.find(tuple) != s) return "not found: " + print(tuple);
        bool ever = false;
        for (std::size_t track = 0; track < static_cast<std::size_t>(track_count); ++track) {
            if (table.death[track].size() != table.size()) return "not one death a simplex";
            if (table.death[track][s] < table.birth(s)) return "death before birth: " + print(tuple);
            ever = ever || table.death[track][s] > table.birth(s);
        }
        if (!ever) return "never in any track: " + print(tuple);
    }
    return index_complaint(table.first_of_step, table.size(), step_count,
                           [&](std::size_t s) { return table.birth(static_cast<SimplexIndex>(s)); });
}

std::string faces_complaint(const Timeline& timeline, int dimension) {
    const SimplexTable& table = timeline.table(dimension);
    const SimplexTable& below = timeline.table(dimension - 1);
    for (SimplexIndex s = 0; s < table.size(); ++s) {
        for (std::size_t left_out = 0; left_out < table.tuple(s).size(); ++left_out) {
            Tuple facet(table.tuple(s).begin(), table.tuple(s).end());
            facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(left_out));
            const SimplexIndex f = below.find(facet);
            if (f == kNoSimplex) return "face " + print(facet) + " of " + print(table.tuple(s)) + " is missing";
            for (std::size_t track = 0; track < static_cast<std::size_t>(timeline.track_count); ++track) {
                const bool lived = table.death[track][s] > table.birth(s);
                if (lived && below.death[track][f] < table.death[track][s]) {
                    return "face " + print(facet) + " of " + print(table.tuple(s)) + " dies first";
                }
            }
        }
    }
    return "";
}

std::string deaths_complaint(const Timeline& timeline) {
    const auto step_of = [&](std::size_t i) {
        const Death& death = timeline.deaths[i];
        return timeline.table(death.dimension).death[death.track][death.simplex];
    };
    using Key = std::tuple<Step, int, int, Tuple>;
    std::set<Key> logged;
    Key last{};
    for (std::size_t i = 0; i < timeline.deaths.size(); ++i) {
        const Death& death = timeline.deaths[i];
        const auto tuple = timeline.table(death.dimension).tuple(death.simplex);
        Key key{step_of(i), death.track, death.dimension, Tuple(tuple.begin(), tuple.end())};
        if (i > 0 && !(last < key)) return "deaths not sorted at " + print(tuple) + at_step(step_of(i));
        last = key;
        logged.insert(std::move(key));
    }
    std::size_t expected = 0;
    for (const SimplexTable& table : timeline.simplices) {
        for (int track = 0; track < timeline.track_count; ++track) {
            for (SimplexIndex s = 0; s < table.size(); ++s) {
                const Step death = table.death[static_cast<std::size_t>(track)][s];
                if (death == table.birth(s) || death == kNever) continue;
                ++expected;
                const Tuple tuple(table.tuple(s).begin(), table.tuple(s).end());
                if (logged.count({death, track, table.dimension, tuple}) == 0)
                    return "death not logged: " + print(tuple);
            }
        }
    }
    if (expected != timeline.deaths.size()) return "a logged death that the tables do not know";
    return index_complaint(timeline.first_death_of_step, timeline.deaths.size(), timeline.step_count, step_of);
}

std::string rows_complaint(const Timeline& timeline) {
    if (timeline.surface.empty()) return "";
    const SimplexTable& triangles = timeline.table(2);
    std::map<std::pair<SimplexIndex, int>, Step> free_from;
    std::size_t ended = 0;
    for (const SurfaceRow& row : timeline.surface) {
        if (row.triangle >= triangles.size() || row.side > 1) return "a row without a triangle or side";
        const std::string name = print(triangles.tuple(row.triangle)) + at_step(row.from);
        if (row.from >= row.to) return "empty row: " + name;
        if (row.from < triangles.birth(row.triangle)) return "row before its triangle: " + name;
        if (row.from > timeline.step_count) continue;
        if (std::min(row.to, timeline.step_count + 1) > triangles.death[0][row.triangle]) {
            return "row after its triangle: " + name;
        }
        Step& free = free_from[{row.triangle, row.side}];
        if (free > row.from) return "rows overlap: " + name;
        if (free == row.from && free > 0) return "a row cut in two: " + name;
        free = row.to;
        ended += row.to != kNever;
    }
    std::set<std::uint32_t> in_log(timeline.ended_rows.begin(), timeline.ended_rows.end());
    if (in_log.size() != timeline.ended_rows.size() || ended != in_log.size()) return "log of ended rows incomplete";
    const auto end_of = [&](std::size_t i) { return timeline.surface[timeline.ended_rows[i]].to; };
    std::string complaint =
        index_complaint(timeline.first_ended_row_of_step, timeline.ended_rows.size(), timeline.step_count, end_of);
    if (!complaint.empty()) return "ended rows: " + complaint;
    return index_complaint(timeline.first_row_of_step, timeline.surface.size(), timeline.step_count,
                           [&](std::size_t i) { return timeline.surface[i].from; });
}

/// Each directed edge of the rows is matched by as many of the opposite direction.
std::string closedness_complaint(const Timeline& timeline, Step step) {
    std::map<std::pair<Step, Step>, int> balance;
    for (const std::uint32_t row : timeline.surface_rows(step)) {
        const auto tuple = timeline.table(2).tuple(timeline.surface[row].triangle);
        std::array<Step, 3> turn = {tuple[0], tuple[1], tuple[2]};
        if (timeline.surface[row].side == 1) std::swap(turn[1], turn[2]);
        for (std::size_t i = 0; i < 3; ++i) {
            ++balance[{turn[i], turn[(i + 1) % 3]}];
            --balance[{turn[(i + 1) % 3], turn[i]}];
        }
    }
    for (const auto& [edge, count] : balance) {
        if (count != 0)
            return "surface not closed at edge " + print(std::array{edge.first, edge.second}) + at_step(step);
    }
    return "";
}

/// Euler-Poincare where the shown complex is not the surface, by counting births and deaths.
std::string euler_complaint(const Timeline& timeline) {
    std::vector<std::vector<long>> change(static_cast<std::size_t>(timeline.track_count),
                                          std::vector<long>(std::size_t{timeline.step_count} + 2));
    for (const SimplexTable& table : timeline.simplices) {
        const long sign = table.dimension % 2 == 0 ? 1 : -1;
        for (SimplexIndex s = 0; s < table.size(); ++s) {
            for (std::size_t track = 0; track < change.size(); ++track) {
                if (table.birth(s) > timeline.step_count) continue;
                change[track][table.birth(s)] += sign;
                change[track][std::min(table.death[track][s], timeline.step_count + 1)] -= sign;
            }
        }
    }
    for (const HiddenLandmark& hidden : timeline.hidden) --change[0][hidden.from];
    std::vector<long> euler(change.size());
    for (Step step = 1; step <= timeline.step_count; ++step) {
        for (std::size_t track = 0; track < euler.size(); ++track) euler[track] += 1 + change[track][step];
        const Family shown = timeline.shown_family[step - 1];
        if (shown == Family::Surface) continue;
        long rest = euler[static_cast<std::size_t>(timeline.shown_track(step))];
        const auto betti = timeline.betti_at(step);
        for (std::size_t k = 0; k < betti.size(); ++k) {
            rest -= (k % 2 == 0 ? 1 : -1) * static_cast<long>(betti[k]);
        }
        // What is left is the Betti number of the highest dimension, 0 for a complex embedded in space.
        if (timeline.dimension % 2 == 1) rest = -rest;
        if (rest < 0 || (rest > 0 && shown != Family::Witness)) return "Euler-Poincare fails" + at_step(step);
    }
    return "";
}

}  // namespace

std::string timeline_is_valid(const Timeline& timeline) {
    std::string complaint = steps_complaint(timeline);
    if (!complaint.empty()) return complaint;
    for (int k = 1; k <= static_cast<int>(timeline.dimension); ++k) {
        complaint = table_complaint(timeline.table(k), k, timeline.track_count, timeline.step_count);
        if (complaint.empty() && k > 1) complaint = faces_complaint(timeline, k);
        if (!complaint.empty()) return "dimension " + std::to_string(k) + ": " + complaint;
    }
    complaint = deaths_complaint(timeline);
    if (complaint.empty()) complaint = rows_complaint(timeline);
    if (complaint.empty()) complaint = euler_complaint(timeline);
    const Step stride = timeline.step_count <= 250 ? 1 : timeline.step_count / 50;
    for (Step step = 1; step <= timeline.step_count && complaint.empty(); step += stride) {
        complaint = closedness_complaint(timeline, step);
    }
    return complaint;
}

std::string mesh_is_valid(const SurfaceMesh& mesh, std::span<const std::uint32_t> betti) {
    std::vector<std::uint32_t> component(mesh.vertex_landmark.size());
    std::iota(component.begin(), component.end(), 0);
    const auto root = [&](std::uint32_t v) {
        while (component[v] != v) v = component[v] = component[component[v]];
        return v;
    };
    std::vector<bool> used(mesh.vertex_landmark.size());
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
    for (const auto& triangle : mesh.triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t from = triangle[i], to = triangle[(i + 1) % 3];
            if (from >= used.size() || to >= used.size()) return "a triangle with a vertex beyond the end";
            if (from == to) return "a triangle with a vertex twice";
            used[from] = true;
            ++balance[{from, to}];
            --balance[{to, from}];
            component[root(from)] = root(to);
        }
    }
    for (const auto& [edge, count] : balance) {
        if (count != 0)
            return "mesh not closed at edge " + std::to_string(edge.first) + " " + std::to_string(edge.second);
    }
    long components = 0;
    for (std::uint32_t v = 0; v < used.size(); ++v) {
        if (!used[v]) return "unused vertex " + std::to_string(v);
        components += root(v) == v;
    }
    const long euler = static_cast<long>(used.size()) - static_cast<long>(mesh.triangles.size()) / 2;
    const std::array<long, 3> expected = {components, 2 * components - euler, components};
    if (!std::equal(expected.begin(), expected.end(), betti.begin(), betti.end()))
        return "mesh with other Betti numbers";
    return "";
}

}  // namespace plateau
