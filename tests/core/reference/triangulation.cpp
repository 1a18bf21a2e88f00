#include "reference/triangulation.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>

namespace plateau::reference {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Space = CGAL::Delaunay_triangulation_3<
    Kernel, CGAL::Triangulation_data_structure_3<CGAL::Triangulation_vertex_base_with_info_3<int, Kernel>,
                                                 CGAL::Delaunay_triangulation_cell_base_3<Kernel>>>;
using Plane = CGAL::Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>>>;

template <class Vertices>
void add_cell(Triangulation& result, const Vertices& vertices) {
    Simplex cell;
    for (const auto& vertex : vertices) cell.push_back(vertex->info());
    std::sort(cell.begin(), cell.end());
    result.cells.insert(cell);
}

}  // namespace

Triangulation triangulate_space(const std::vector<LabeledPoint>& points) {
    Space space;
    for (const LabeledPoint& point : points) {
        const auto& [x, y, z] = point.position;
        space.insert(Kernel::Point_3(x, y, z))->info() = point.label;
    }
    Triangulation result;
    result.dimension = space.dimension();
    if (result.dimension == 0) result.cells = {{points[0].label}};
    if (result.dimension == 1) {
        for (auto edge = space.finite_edges_begin(); edge != space.finite_edges_end(); ++edge) {
            add_cell(result, std::array{edge->first->vertex(edge->second), edge->first->vertex(edge->third)});
        }
    }
    if (result.dimension == 2) {
        for (auto facet = space.finite_facets_begin(); facet != space.finite_facets_end(); ++facet) {
            const auto cell = facet->first;  // in dimension 2 the facet is opposite to vertex 3
            add_cell(result, std::array{cell->vertex(0), cell->vertex(1), cell->vertex(2)});
        }
    }
    if (result.dimension == 3) {
        for (const auto cell : space.finite_cell_handles()) {
            add_cell(result, std::array{cell->vertex(0), cell->vertex(1), cell->vertex(2), cell->vertex(3)});
        }
    }
    return result;
}

Triangulation triangulate_plane(const std::vector<LabeledPoint>& points) {
    Plane plane;
    for (const LabeledPoint& point : points) {
        plane.insert(Kernel::Point_2(point.position[0], point.position[1]))->info() = point.label;
    }
    Triangulation result;
    result.dimension = plane.dimension();
    if (result.dimension == 0) result.cells = {{points[0].label}};
    if (result.dimension == 1) {
        for (auto edge = plane.finite_edges_begin(); edge != plane.finite_edges_end(); ++edge) {
            const auto face = edge->first;
            add_cell(result, std::array{face->vertex(Plane::cw(edge->second)), face->vertex(Plane::ccw(edge->second))});
        }
    }
    if (result.dimension == 2) {
        for (const auto face : plane.finite_face_handles()) {
            add_cell(result, std::array{face->vertex(0), face->vertex(1), face->vertex(2)});
        }
    }
    return result;
}

}  // namespace plateau::reference
