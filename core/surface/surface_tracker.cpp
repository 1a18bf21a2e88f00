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

bool SurfaceTracker::update(Step step, const Delaunay& delaunay, const DelaunayChange& change, const NuComplex& complex,
                            std::span<const Death> deaths, const LandmarkPoints& points, Timeline& timeline,
                            Slice& slice) {
    const DelaunayFaces& faces = complex.faces();
    const Context context{step, delaunay, complex, faces, points, timeline};
    switch (stage_) {
        case Stage::Begin:
            ended_.clear();
            glue_changes_.clear();
            changed_.clear();
            vertex_rows_.resize(step + 1);
            fans_.resize(step + 1, 0);
            if (change.dimension < 3) return true;
            stage_ = Stage::Peel;
            [[fallthrough]];
        case Stage::Peel:
            if (!peeling_.update(step, timeline.simplices, complex, deaths, points, !started_, slice)) return false;
            stage_ = Stage::Region;
            [[fallthrough]];
        case Stage::Region:
            if (!region_.update(step, delaunay, change, faces, peeling_, !started_, slice)) return false;
            started_ = true;
            row_of_.resize(timeline.table(2).size(), {kNoRow, kNoRow});
            work_ = dirty_triangles(context, change);
            stage_ = Stage::Rows;
            [[fallthrough]];
        case Stage::Rows:
            if (!work_through(slice, [&](SimplexIndex triangle) { refresh_rows(triangle, context); })) return false;
            work_ = edges_of_changed(context);
            stage_ = Stage::Glue;
            [[fallthrough]];
        case Stage::Glue:
            if (!work_through(slice, [&](SimplexIndex edge) { glue_around(edge, context); })) return false;
            work_ = vertices_of_changed(context);
            stage_ = Stage::Fans;
            [[fallthrough]];
        case Stage::Fans:
            if (!work_through(slice, [&](Step vertex) { refresh_fans(vertex, context); })) return false;
            stage_ = Stage::Begin;
    }
    return true;
}

// Goes on with the work of a stage; true at its end.
template <class Use>
bool SurfaceTracker::work_through(Slice& slice, const Use& use) {
    for (; worked_ < work_.size(); ++worked_) {
        if (slice.used_up()) return false;
        use(work_[worked_]);
    }
    worked_ = 0;
    return true;
}

// Triangles of K, or just out of it, at least one side of which may have another cell, or a cell that changed sides.
std::vector<std::uint32_t> SurfaceTracker::dirty_triangles(const Context& context, const DelaunayChange& change) const {
    std::vector<std::uint32_t> dirty(peeling_.entered().begin(), peeling_.entered().end());
    for (const SimplexIndex triangle : peeling_.left()) {
        const auto& rows = row_of_[triangle];
        if (rows[0] != kNoRow || rows[1] != kNoRow) dirty.push_back(triangle);
    }
    const auto add_facets = [&](CellId cell) {
        for (int i = 0; i < 4; ++i) {
            if (region_.closed(cell, i)) dirty.push_back(context.faces.triangle(cell, i));
        }
    };
    for (const CellId cell : change.born) add_facets(cell);
    for (const CellId cell : region_.flipped()) add_facets(cell);
    sort_unique(dirty);
    return dirty;
}

std::vector<std::uint32_t> SurfaceTracker::edges_of_changed(const Context& context) const {
    std::vector<std::uint32_t> edges;
    for (const SimplexIndex triangle : changed_) {
        for (const SimplexIndex edge : context.complex.facets(2, triangle)) edges.push_back(edge);
    }
    sort_unique(edges);
    return edges;
}

std::vector<std::uint32_t> SurfaceTracker::vertices_of_changed(const Context& context) const {
    std::vector<std::uint32_t> vertices;
    for (const SimplexIndex triangle : changed_) {
        for (const Step vertex : context.timeline.table(2).tuple(triangle)) vertices.push_back(vertex);
    }
    sort_unique(vertices);
    return vertices;
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

void SurfaceTracker::refresh_fans(Step vertex, const Context& context) {
    vertex_count_ -= fans_[vertex];
    fans_[vertex] = count_fans(vertex, context);
    vertex_count_ += fans_[vertex];
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
