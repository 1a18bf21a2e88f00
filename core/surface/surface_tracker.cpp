#include "surface/surface_tracker.h"

#include <algorithm>

namespace plateau {

namespace {

// On which side of the ascending triangle the cell lies that has it opposite vertex `index`; 0: where it turns
// counter-clockwise. Cells are positively oriented, so this is the parity of a permutation.
std::uint8_t side_of_cell(const DelaunayCell& cell, int index) {
    std::array<Step, 3> vertices{};
    std::size_t count = 0;
    for (int i = 0; i < 4; ++i) {
        if (i != index) vertices[count++] = cell.vertex[static_cast<std::size_t>(i)];
    }
    int inversions = 3 - index;
    inversions += vertices[0] > vertices[1] ? 1 : 0;
    inversions += vertices[0] > vertices[2] ? 1 : 0;
    inversions += vertices[1] > vertices[2] ? 1 : 0;
    return static_cast<std::uint8_t>(inversions % 2);
}

void sort_unique(std::vector<std::uint32_t>& values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

}  // namespace

void SurfaceTracker::update(Step step, const Delaunay& delaunay, const DelaunayChange& change, const NuComplex& complex,
                            std::span<const Death> deaths, const LandmarkPoints& points, Timeline& timeline) {
    ended_.clear();
    glue_changes_.clear();
    changed_.clear();
    vertex_rows_.resize(step + 1);
    fans_.resize(step + 1, 0);
    if (change.dimension < 3) return;
    const bool all = !started_;
    started_ = true;
    const DelaunayFaces& faces = complex.faces();
    const Context context{step, delaunay, complex, faces, points, timeline};

    peeling_.update(step, timeline.simplices, complex, deaths, points, all);
    region_.update(step, delaunay, change, faces, peeling_, all);
    row_of_.resize(timeline.table(2).size(), {kNoRow, kNoRow});
    for (const SimplexIndex triangle : dirty_triangles(context, change)) refresh_rows(triangle, context);

    std::vector<SimplexIndex> edges;
    for (const SimplexIndex triangle : changed_) {
        for (const SimplexIndex edge : complex.facets(2, triangle)) edges.push_back(edge);
    }
    sort_unique(edges);
    std::vector<Step> vertices;
    for (const SimplexIndex edge : edges) {
        glue_around(edge, context);
        for (const Step vertex : timeline.table(1).tuple(edge)) vertices.push_back(vertex);
    }
    sort_unique(vertices);
    for (const Step vertex : vertices) {
        vertex_count_ -= fans_[vertex];
        fans_[vertex] = count_fans(vertex, context);
        vertex_count_ += fans_[vertex];
    }
}

// Triangles of K, or just out of it, at least one side of which may have another cell, or a cell that changed sides.
std::vector<SimplexIndex> SurfaceTracker::dirty_triangles(const Context& context, const DelaunayChange& change) {
    std::vector<SimplexIndex> dirty(peeling_.left().begin(), peeling_.left().end());
    dirty.insert(dirty.end(), peeling_.entered().begin(), peeling_.entered().end());
    const auto add_facets = [&](CellId cell) {
        for (int i = 0; i < 4; ++i) {
            const SimplexIndex triangle = context.faces.triangle(cell, i);
            if (triangle != kNoSimplex && peeling_.kept(triangle)) dirty.push_back(triangle);
        }
    };
    for (const CellId cell : change.born) add_facets(cell);
    for (const CellId cell : region_.flipped()) add_facets(cell);
    sort_unique(dirty);
    return dirty;
}

void SurfaceTracker::refresh_rows(SimplexIndex triangle, const Context& context) {
    std::array<bool, 2> wanted{false, false};
    if (peeling_.kept(triangle)) {
        const auto facet = context.faces.facet(triangle);
        const DelaunayCell& cell = context.delaunay.cell(facet.cell);
        const std::uint8_t side = side_of_cell(cell, facet.index);
        wanted[side] = region_.outer(facet.cell);
        wanted[1u - side] = region_.outer(cell.neighbor[static_cast<std::size_t>(facet.index)]);
    }
    bool changed = false;
    for (std::uint8_t side = 0; side < 2; ++side) {
        const bool present = row_of_[triangle][side] != kNoRow;
        if (present == wanted[side]) continue;
        changed = true;
        if (present) {
            close_row(triangle, side, context);
        } else {
            open_row(triangle, side, context);
        }
    }
    if (changed) changed_.push_back(triangle);
}

void SurfaceTracker::open_row(SimplexIndex triangle, std::uint8_t side, const Context& context) {
    const auto row = static_cast<std::uint32_t>(context.timeline.surface.size());
    context.timeline.surface.push_back({triangle, side, context.step, kNever});
    row_of_[triangle][side] = row;
    partner_.emplace_back();
    visited_at_.push_back(0);
    for (const Step vertex : context.timeline.table(2).tuple(triangle)) vertex_rows_[vertex].push_back(row);
    ++triangle_count_;
}

void SurfaceTracker::close_row(SimplexIndex triangle, std::uint8_t side, const Context& context) {
    const std::uint32_t row = row_of_[triangle][side];
    context.timeline.surface[row].to = context.step;
    context.timeline.ended_rows.push_back(row);
    ended_.push_back(row);
    row_of_[triangle][side] = kNoRow;
    for (std::uint32_t corner = 0; corner < 3; ++corner) unglue(row, corner);
    for (const Step vertex : context.timeline.table(2).tuple(triangle)) {
        auto& rows = vertex_rows_[vertex];
        *std::find(rows.begin(), rows.end(), row) = rows.back();
        rows.pop_back();
    }
    --triangle_count_;
}

void SurfaceTracker::unglue(std::uint32_t row, std::uint32_t corner) {
    const Partner partner = partner_[row][corner];
    if (partner.row == kNoRow) return;
    glue_changes_.push_back({row, partner.row, corner, partner.corner, false});
    partner_[partner.row][partner.corner] = {};
    partner_[row][corner] = {};
}

void SurfaceTracker::glue_around(SimplexIndex edge, const Context& context) {
    const auto ends = context.timeline.table(1).tuple(edge);
    std::vector<EdgeSide> sides;
    peeling_.for_each_kept_at(edge, [&](SimplexIndex triangle, std::uint32_t corner) {
        for (std::uint8_t side = 0; side < 2; ++side) {
            const std::uint32_t row = row_of_[triangle][side];
            if (row == kNoRow) continue;
            sides.push_back(
                {row, corner, context.timeline.table(2).tuple(triangle)[corner], runs_forward(side, corner)});
        }
    });
    for (const auto& [i, j] : pair_sides(sides, ends[0], ends[1], context.points)) {
        const EdgeSide& a = sides[i];
        const EdgeSide& b = sides[j];
        const Partner now = partner_[a.row][a.corner];
        if (now.row == b.row && now.corner == b.corner) continue;
        unglue(a.row, a.corner);
        unglue(b.row, b.corner);
        partner_[a.row][a.corner] = {b.row, b.corner};
        partner_[b.row][b.corner] = {a.row, a.corner};
        glue_changes_.push_back({a.row, b.row, a.corner, b.corner, true});
    }
}

// The rows around a vertex, glued along edges, form cycles; each is one vertex of the surface.
std::uint32_t SurfaceTracker::count_fans(Step vertex, const Context& context) {
    ++visit_;
    std::uint32_t fans = 0;
    const auto corner_at = [&](std::uint32_t row) {
        const auto tuple = context.timeline.table(2).tuple(context.timeline.surface[row].triangle);
        return static_cast<std::uint32_t>(std::find(tuple.begin(), tuple.end(), vertex) - tuple.begin());
    };
    for (const std::uint32_t start : vertex_rows_[vertex]) {
        if (visited_at_[start] == visit_) continue;
        ++fans;
        std::uint32_t row = start;
        std::uint32_t leave = (corner_at(row) + 1) % 3;
        while (visited_at_[row] != visit_) {
            visited_at_[row] = visit_;
            const Partner partner = partner_[row][leave];
            // Leave through the other edge at the vertex; the corners of a triangle sum to 3.
            leave = 3 - partner.corner - corner_at(partner.row);
            row = partner.row;
        }
    }
    return fans;
}

std::uint64_t SurfaceTracker::memory() const {
    return peeling_.memory() + region_.memory() + row_of_.capacity() * sizeof(row_of_[0]) +
           partner_.capacity() * sizeof(partner_[0]) + visited_at_.capacity() * sizeof(std::uint32_t) +
           vertex_rows_.capacity() * (sizeof(vertex_rows_[0]) + 12 * sizeof(std::uint32_t));
}

}  // namespace plateau
