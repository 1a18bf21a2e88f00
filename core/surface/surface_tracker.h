#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/slice.h"
#include "complex/delaunay_faces.h"
#include "complex/nu_complex.h"
#include "delaunay/delaunay.h"
#include "surface/gluing.h"
#include "surface/landmark_points.h"
#include "surface/outer_region.h"
#include "surface/peeling.h"
#include "timeline/timeline.h"

namespace plateau {

/// Two rows were glued along an edge, or came apart. Corners: places of the vertices off the edge.
struct GlueChange {
    std::uint32_t row_a = 0, row_b = 0;
    std::uint32_t corner_a = 0, corner_b = 0;
    bool begins = true;
};

/// The extracted surface S-hat(i) [GO 3.2.2] under insertion: peeling, outer region, and the triangles between them as
/// rows, glued around each edge through the outer cells. Vertices and edges that are met twice count twice, so the
/// surface is closed. While D(L) is flat the surface is empty.
class SurfaceTracker {
public:
    /// `rho`: largest radius-edge ratio of a triangle; 0 = any.
    explicit SurfaceTracker(double rho) : peeling_(rho) {}

    /// Follows one insertion, after the complex has followed it; appends to the timeline's surface rows. False if the
    /// slice was used up before the end: call it again, with the same arguments, before anything else is asked. A
    /// surface that comes apart at one step is a long one.
    bool update(Step step, const Delaunay& delaunay, const DelaunayChange& change, const NuComplex& complex,
                std::span<const Death> deaths, const LandmarkPoints& points, Timeline& timeline, Slice& slice);

    /// Asks for what is known of the cell.
    void expect(CellId cell) const { region_.expect(cell); }

    /// Rows that the last step appended are those from this index on.
    std::span<const std::uint32_t> ended_rows() const { return ended_; }
    std::span<const GlueChange> glue_changes() const { return glue_changes_; }
    /// The row that a living row is glued to along the edge that lacks the corner.
    std::uint32_t partner(std::uint32_t row, std::uint32_t corner) const { return partner_[row][corner].row; }
    /// Number of triangles and of vertices, those met twice counted twice.
    std::uint32_t triangle_count() const { return triangle_count_; }
    std::uint32_t vertex_count() const { return vertex_count_; }
    std::uint64_t memory() const;

private:
    static constexpr std::uint32_t kNoRow = 0xFFFFFFFFu;
    struct Partner {
        std::uint32_t row = kNoRow;
        std::uint32_t corner = 0;
    };
    struct Context {
        Step step;
        const Delaunay& delaunay;
        const NuComplex& complex;
        const DelaunayFaces& faces;
        const LandmarkPoints& points;
        Timeline& timeline;
    };
    enum class Stage : std::uint8_t { Begin, Peel, Region, Rows, Glue, Fans };

    std::vector<std::uint32_t> dirty_triangles(const Context& context, const DelaunayChange& change) const;
    std::vector<std::uint32_t> edges_of_changed(const Context& context) const;
    std::vector<std::uint32_t> vertices_of_changed(const Context& context) const;
    template <class Use>
    bool work_through(Slice& slice, const Use& use);
    void refresh_rows(SimplexIndex triangle, const Context& context);
    void open_row(SimplexIndex triangle, std::uint8_t side, const Context& context);
    void close_row(SimplexIndex triangle, std::uint8_t side, const Context& context);
    void glue_around(SimplexIndex edge, const Context& context);
    void unglue(std::uint32_t row, std::uint32_t corner);
    void refresh_fans(Step vertex, const Context& context);
    std::uint32_t count_fans(Step vertex, const Context& context);

    Peeling peeling_;
    OuterRegion region_;
    bool started_ = false;
    Stage stage_ = Stage::Begin;       // where the step goes on
    std::vector<std::uint32_t> work_;  // of the stage: triangles, edges or vertices, each once, ascending
    std::size_t worked_ = 0;           // how many of them are done
    std::vector<std::array<std::uint32_t, 2>> row_of_;     // by triangle and side
    std::vector<std::array<Partner, 3>> partner_;          // by row and corner
    std::vector<std::vector<std::uint32_t>> vertex_rows_;  // by step
    std::vector<std::uint32_t> fans_;                      // by step
    std::vector<std::uint32_t> ended_;
    std::vector<GlueChange> glue_changes_;
    std::vector<SimplexIndex> changed_;      // triangles whose rows changed at this step
    std::vector<std::uint32_t> visited_at_;  // by row, scratch of count_fans
    std::uint32_t visit_ = 0;
    std::uint32_t triangle_count_ = 0, vertex_count_ = 0;
};

}  // namespace plateau
