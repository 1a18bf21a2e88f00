#include "delta.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "marshal.h"

namespace plateau::marshal {

using emscripten::val;

namespace {

/// New simplices of one dimension over the steps after `done` up to `end`, as (tuples, deaths per track).
void add_simplices(val& delta, const Timeline& timeline, int dim, Step done, Step end, const char* tuples_name,
                   const char* death_name) {
    std::array<std::vector<Step>, kMaxTracks> death;
    const SimplexTable none;  // of a run that has no simplices of this dimension
    const bool has_table = dim <= static_cast<int>(timeline.dimension);
    const SimplexTable& table = has_table ? timeline.table(dim) : none;
    const SimplexIndex first = has_table ? table.first_of_step[done + 1] : 0;
    const SimplexIndex last = has_table ? table.first_of_step[end + 1] : 0;
    const auto width = static_cast<std::size_t>(dim + 1);
    const auto tuples = std::span(table.vertices).subspan(first * width, (last - first) * width);
    for (int track = 0; track < timeline.track_count; ++track) {
        const auto& known = table.death[static_cast<std::size_t>(track)];
        auto& out = death[static_cast<std::size_t>(track)];
        for (SimplexIndex i = first; i < last; ++i) out.push_back(known[i] <= end ? known[i] : kNever);
    }
    val deaths = val::array();
    for (std::size_t track = 0; track < kMaxTracks; ++track) {
        deaths.set(track, copied(std::span<const Step>(death[track])));
    }
    delta.set(tuples_name, copied(tuples));
    delta.set(death_name, deaths);
}

/// Deaths, up to step `end`, of edges and triangles that earlier deltas handed out: (dimension, track, index, step).
std::vector<std::uint32_t> older_deaths(const Timeline& timeline, Step done, Step end) {
    std::vector<std::uint32_t> out;
    for (Step step = done + 1; step <= end; ++step) {
        for (std::size_t i = timeline.first_death_of_step[step]; i < timeline.first_death_of_step[step + 1]; ++i) {
            const Death& death = timeline.deaths[i];
            if (death.dimension > 2) continue;
            if (death.simplex >= timeline.table(death.dimension).first_of_step[done + 1]) continue;
            out.insert(out.end(), {death.dimension, death.track, death.simplex, step});
        }
    }
    return out;
}

/// Of each landmark omega(p)^2, the smallest sliver measures before and after, the relative amplitude, and how many
/// thresholds were found.
std::vector<double> pumps(const Timeline& timeline, Step done, Step end) {
    std::vector<double> out;
    if (timeline.pumps.empty()) return out;
    for (Step step = done + 1; step <= end; ++step) {
        const Pump& pump = timeline.pumps[step - 1];
        out.insert(out.end(), {pump.weight_squared, pump.before, pump.after, pump.amplitude,
                               static_cast<double>(pump.thresholds)});
    }
    return out;
}

void add_rows(val& delta, const Timeline& timeline, Step done, Step end) {
    std::vector<std::uint32_t> vertices, from, to, ended;
    if (!timeline.surface.empty()) {
        const std::uint32_t first = timeline.first_row_of_step[done + 1];
        const std::uint32_t last = timeline.first_row_of_step[end + 1];
        for (std::uint32_t i = first; i < last; ++i) {
            const SurfaceRow& row = timeline.surface[i];
            const auto tuple = timeline.table(2).tuple(row.triangle);
            if (row.side == 0) {
                vertices.insert(vertices.end(), {tuple[0], tuple[1], tuple[2]});
            } else {
                vertices.insert(vertices.end(), {tuple[0], tuple[2], tuple[1]});
            }
            from.push_back(row.from);
            to.push_back(row.to <= end ? row.to : kNever);
        }
        const std::size_t ended_last = timeline.first_ended_row_of_step[end + 1];
        for (std::size_t i = timeline.first_ended_row_of_step[done + 1]; i < ended_last; ++i) {
            const std::uint32_t row = timeline.ended_rows[i];
            if (row < first) ended.insert(ended.end(), {row, timeline.surface[row].to});
        }
    }
    delta.set("rowVertices", copied(std::span<const std::uint32_t>(vertices)));
    delta.set("rowFrom", copied(std::span<const std::uint32_t>(from)));
    delta.set("rowTo", copied(std::span<const std::uint32_t>(to)));
    delta.set("endedRows", copied(std::span<const std::uint32_t>(ended)));
}

}  // namespace

Step delta_end(const Timeline& timeline, Step done, std::uint32_t max_simplices) {
    const auto born_by = [&](Step step) {
        std::uint64_t born = step;
        const int largest = std::min(2, static_cast<int>(timeline.dimension));
        for (int dim = 1; dim <= largest; ++dim) born += timeline.table(dim).first_of_step[step + 1];
        if (!timeline.surface.empty()) born += timeline.first_row_of_step[step + 1];
        return born;
    };
    const std::uint64_t limit = born_by(done) + max_simplices;
    Step low = std::min(done + 1, timeline.step_count);
    Step high = timeline.step_count;
    while (low < high) {
        const Step middle = low + (high - low + 1) / 2;
        if (born_by(middle) <= limit) {
            low = middle;
        } else {
            high = middle - 1;
        }
    }
    return low;
}

void add_record(val& delta, const Timeline& timeline, Step done, Step end) {
    const std::size_t count = end - done;
    std::vector<double> epsilon(count);
    std::vector<std::uint8_t> family(count);
    for (Step step = done + 1; step <= end; ++step) {
        epsilon[step - done - 1] = timeline.epsilon(step);
        family[step - done - 1] = static_cast<std::uint8_t>(timeline.shown_family[step - 1]);
    }
    const std::size_t d = timeline.dimension;
    delta.set("firstStep", done + 1);
    delta.set("stepCount", end);
    delta.set("landmark", copied(std::span(timeline.landmarks).subspan(done, count)));
    delta.set("epsilon", copied(std::span<const double>(epsilon)));
    delta.set("shownFamily", copied(std::span<const std::uint8_t>(family)));
    delta.set("betti", copied(std::span(timeline.betti).subspan(done * d, count * d)));
    const auto others = timeline.other_betti.empty() ? std::span<const std::uint32_t>()
                                                     : std::span(timeline.other_betti).subspan(done * d, count * d);
    delta.set("otherBetti", copied(others));
    delta.set("pumps", copied(std::span<const double>(pumps(timeline, done, end))));
    add_simplices(delta, timeline, 1, done, end, "edges", "edgeDeath");
    add_simplices(delta, timeline, 2, done, end, "triangles", "triangleDeath");
    delta.set("deaths", copied(std::span<const std::uint32_t>(older_deaths(timeline, done, end))));
    add_rows(delta, timeline, done, end);
}

}  // namespace plateau::marshal
