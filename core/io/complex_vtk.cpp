#include "io/complex_vtk.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "io/binary_text.h"
#include "io/step_mesh.h"
#include "projection/projection.h"

namespace plateau {
namespace {

/// VTK's largest int.
constexpr std::uint32_t kNoDeath = 0x7FFFFFFF;
/// VTK's numbers for vertex, line, triangle and tetrahedron.
constexpr std::array<std::uint32_t, 4> kCellTypes = {1, 3, 5, 10};

/// What the file says of its cells, column by column.
struct Cells {
    std::vector<std::uint32_t> lists;  ///< of each cell the number of its points, then their indices
    std::vector<std::uint32_t> types, dimension, birth, death;

    void add(std::span<const Step> tuple, Step death_step) {
        lists.push_back(static_cast<std::uint32_t>(tuple.size()));
        for (const Step vertex : tuple) lists.push_back(vertex - 1);
        types.push_back(kCellTypes[tuple.size() - 1]);
        dimension.push_back(static_cast<std::uint32_t>(tuple.size() - 1));
        birth.push_back(tuple.back());
        death.push_back(death_step == kNever ? kNoDeath : death_step);
    }
};

Cells cells_at(const Timeline& timeline, Step step) {
    Cells cells;
    if (step == 0) return cells;
    std::vector<Step> vertex_death(step, kNever);
    for (const HiddenLandmark& hidden : timeline.hidden) {
        if (hidden.landmark <= step) vertex_death[hidden.landmark - 1] = hidden.from;
    }
    for (Step landmark = 1; landmark <= step; ++landmark) {
        if (vertex_death[landmark - 1] > step) cells.add(std::span(&landmark, 1), vertex_death[landmark - 1]);
    }
    const int track = timeline.shown_track(step);
    const int largest = std::min(static_cast<int>(kCellTypes.size()) - 1, static_cast<int>(timeline.dimension));
    for (int dim = 1; dim <= largest; ++dim) {
        const SimplexTable& table = timeline.table(dim);
        for (const SimplexIndex index : timeline.living(dim, track, step)) {
            cells.add(table.tuple(index), table.death[static_cast<std::size_t>(track)][index]);
        }
    }
    return cells;
}

void append_ints(std::string& text, std::span<const std::uint32_t> numbers) {
    for (const std::uint32_t number : numbers) append_u32(text, number, ByteOrder::BigEndian);
    text += '\n';
}

void append_column(std::string& text, const char* name, std::span<const std::uint32_t> numbers) {
    text += std::string(name) + " 1 " + std::to_string(numbers.size()) + " int\n";
    append_ints(text, numbers);
}

/// Three coordinates of each landmark.
void append_positions(std::string& text, const Session& session, std::span<const std::uint32_t> landmarks) {
    const PointCloud& cloud = session.cloud();
    const auto append = [&](const auto& row) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            append_f64(text, axis < row.size() ? double{row[axis]} : 0, ByteOrder::BigEndian);
        }
    };
    if (cloud.dimension == 2 || cloud.dimension == 3) {
        for (const std::uint32_t landmark : landmarks) append(cloud.point(landmark));
    } else {
        const Projection drawn = projection_of(cloud);
        for (const std::uint32_t landmark : landmarks) {
            append(std::span(drawn.coordinates).subspan(std::size_t{landmark} * drawn.axes, drawn.axes));
        }
    }
    text += '\n';
}

}  // namespace

std::string complex_vtk(const Session& session, std::optional<Step> step) {
    const Timeline& timeline = session.timeline();
    const PointCloud& cloud = session.cloud();
    const Step at = step.value_or(default_mesh_step(session));
    const auto landmarks = std::span(timeline.landmarks).first(at);
    const Cells cells = cells_at(timeline, at);

    // The title is one line of at most 256 characters.
    std::string text = "# vtk DataFile Version 3.0\n" + (at > 0 ? step_remark(session, at) : "Plateau") + "\n";
    text += "BINARY\nDATASET UNSTRUCTURED_GRID\n";
    text += "POINTS " + std::to_string(at) + " double\n";
    append_positions(text, session, landmarks);
    const std::string count = std::to_string(cells.types.size());
    text += "CELLS " + count + " " + std::to_string(cells.lists.size()) + "\n";
    append_ints(text, cells.lists);
    text += "CELL_TYPES " + count + "\n";
    append_ints(text, cells.types);

    text += "CELL_DATA " + count + "\nFIELD FieldData 3\n";
    append_column(text, "dimension", cells.dimension);
    append_column(text, "birth", cells.birth);
    append_column(text, "death", cells.death);

    const bool has_more_axes = cloud.dimension > 3;
    text += "POINT_DATA " + std::to_string(at) + "\nFIELD FieldData " + (has_more_axes ? "3" : "2") + "\n";
    append_column(text, "input_index", landmarks);
    std::vector<std::uint32_t> steps(at);
    std::iota(steps.begin(), steps.end(), 1u);
    append_column(text, "step", steps);
    if (has_more_axes) {
        text += "coordinates " + std::to_string(cloud.dimension) + " " + std::to_string(at) + " double\n";
        for (const std::uint32_t landmark : landmarks) {
            for (const double value : cloud.point(landmark)) append_f64(text, value, ByteOrder::BigEndian);
        }
        text += '\n';
    }
    return text;
}

}  // namespace plateau
