#include "delaunay/delaunay.h"

#if defined(__EMSCRIPTEN__) && !defined(CGAL_ALWAYS_ROUND_TO_NEAREST)
#error "WebAssembly has no directed rounding: without CGAL_ALWAYS_ROUND_TO_NEAREST predicates have wrong signs"
#endif

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <exception>
#include <new>
#include <string>

#include "base/prefetch.h"

namespace plateau {

namespace {

struct VertexInfo {
    std::uint32_t step = kInfiniteVertex;
};
struct CellInfo {
    CellId id = kNoCell;
};

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<VertexInfo, Kernel>;
using CellBase =
    CGAL::Triangulation_cell_base_with_info_3<CellInfo, Kernel, CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
using CgalDelaunay = CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<VertexBase, CellBase>>;

/// Listens to the one conflict search of an insertion: the cells it is told of are those that die.
struct ConflictListener {
    std::vector<CellId>* died;
    const PagedTable<DelaunayCell>* mirror;

    template <class Iterator>
    void process_cells_in_conflict(Iterator begin, Iterator end) {
        for (; begin != end; ++begin) {
            died->push_back((*begin)->info().id);
            prefetch(&(*mirror)[died->back()]);
            for (int i = 0; i < 4; ++i) {
                const CgalDelaunay::Cell_handle neighbor = (*begin)->neighbor(i);
                if (neighbor != CgalDelaunay::Cell_handle()) prefetch(&(*mirror)[neighbor->info().id]);
            }
        }
    }
    void reinsert_vertices(CgalDelaunay::Vertex_handle) {}
    void hide_point(CgalDelaunay::Cell_handle, const CgalDelaunay::Point&) {}
    CgalDelaunay::Vertex_handle replace_vertex(CgalDelaunay::Cell_handle cell, int index, const CgalDelaunay::Point&) {
        return cell->vertex(index);
    }
};

}  // namespace

struct Delaunay::Triangulation : CgalDelaunay {
    std::vector<Vertex_handle> vertex_of_step{Vertex_handle()};
    std::vector<Cell_handle> born;

    /// Inserts p and collects the ids of the dying cells and the handles of the new ones; true if the dimension rose.
    bool insert_point(const Point& p, Cell_handle start, std::vector<CellId>& died,
                      const PagedTable<DelaunayCell>& mirror) {
        Locate_type type = OUTSIDE_AFFINE_HULL;
        int li = 0;
        int lj = 0;
        Cell_handle located;
        if (dimension() >= 1) located = locate(p, type, li, lj, start);
        born.clear();
        if (type == OUTSIDE_AFFINE_HULL) {
            for (auto c = tds().cells().begin(); c != tds().cells().end(); ++c) {
                if (c->info().id != kNoCell) died.push_back(c->info().id);
            }
            remember(number_of_vertices() == 0 ? CgalDelaunay::insert(p) : insert_outside_affine_hull(p));
            for (auto c = tds().cells().begin(); c != tds().cells().end(); ++c) born.push_back(c);
            return true;
        }
        if (dimension() == 1) {
            died.push_back(located->info().id);
            located->info().id = kNoCell;  // this cell object becomes one of the two new cells
            remember(CgalDelaunay::insert(p, type, located, li, lj));
        } else {
            ConflictListener listener{&died, &mirror};
            if (dimension() == 2) {
                remember(insert_in_conflict(p, type, located, li, lj, Conflict_tester_2(p, this), listener));
            } else {
                remember(insert_in_conflict(p, type, located, li, lj, Conflict_tester_3(p, this), listener));
            }
        }
        collect_star();
        return false;
    }

private:
    void remember(Vertex_handle vertex) {
        vertex->info().step = static_cast<std::uint32_t>(vertex_of_step.size());
        vertex_of_step.push_back(vertex);
    }

    // All cells around the newest vertex are new; walk them through their shared facets.
    void collect_star() {
        const Vertex_handle v = vertex_of_step.back();
        born.push_back(v->cell());
        v->cell()->info().id = kNoCell - 1;  // seen
        for (std::size_t next = 0; next < born.size(); ++next) {
            for (int i = 0; i <= dimension(); ++i) {
                const Cell_handle neighbor = born[next]->neighbor(i);
                if (born[next]->vertex(i) == v || neighbor->info().id == kNoCell - 1) continue;
                neighbor->info().id = kNoCell - 1;
                born.push_back(neighbor);
            }
        }
    }
};

Delaunay::Delaunay(std::uint32_t ambient_dimension)
    : triangulation_(std::make_unique<Triangulation>()), ambient_dimension_(ambient_dimension) {}
Delaunay::Delaunay(Delaunay&&) noexcept = default;
Delaunay& Delaunay::operator=(Delaunay&&) noexcept = default;
Delaunay::~Delaunay() = default;

Result<const DelaunayChange*> Delaunay::insert(std::uint32_t step, std::span<const double> point, std::uint32_t hint) {
    for (const CellId id : change_.died) free_.push_back(id);
    change_.died.clear();
    change_.born.clear();
    try {
        Triangulation& t = *triangulation_;
        const Triangulation::Point p(point[0], point[1], ambient_dimension_ > 2 ? point[2] : 0.0);
        const auto start = step > 1 ? t.vertex_of_step[hint]->cell() : Triangulation::Cell_handle();
        change_.dimension_rose = t.insert_point(p, start, change_.died, cells_);
        change_.dimension = t.dimension();
        mirror_born();
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::OutOfMemory, "The memory ran out while the Delaunay triangulation grew."};
    } catch (const std::exception& failure) {
        return Error{ErrorCode::Internal, std::string("The Delaunay triangulation failed: ") + failure.what()};
    }
    return static_cast<const DelaunayChange*>(&change_);
}

CellId Delaunay::take_slot() {
    if (free_.empty()) {
        cells_.push_back({});
        return static_cast<CellId>(cells_.size() - 1);
    }
    const CellId id = free_.back();
    free_.pop_back();
    return id;
}

// Copies the new cells out of CGAL: nobody else sees its handles.
void Delaunay::mirror_born() {
    const auto newest = static_cast<std::uint32_t>(triangulation_->vertex_of_step.size() - 1);
    for (const CellId id : change_.died) cells_[id].alive = false;
    for (const auto& handle : triangulation_->born) {
        handle->info().id = take_slot();
        change_.born.push_back(handle->info().id);
    }
    for (const auto& handle : triangulation_->born) {
        const CellId id = handle->info().id;
        DelaunayCell& cell = cells_[id];
        cell = {};
        cell.alive = true;
        for (int i = 0; i <= change_.dimension; ++i) {
            const auto at = static_cast<std::size_t>(i);
            cell.vertex[at] = handle->vertex(i)->info().step;
            const auto neighbor = handle->neighbor(i);
            const CellId other = neighbor->info().id;
            cell.neighbor[at] = other;
            if (cell.vertex[at] != newest) continue;  // the neighbor is new as well
            cells_[other].neighbor[static_cast<std::size_t>(neighbor->index(handle))] = id;
        }
    }
    cell_count_ += static_cast<std::uint32_t>(change_.born.size());
    cell_count_ -= static_cast<std::uint32_t>(change_.died.size());
}

}  // namespace plateau
