#include "plane/plane_picture.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace plateau {

namespace {

std::array<Step, 1> tuple_of(Step vertex) {
    return {vertex};
}
template <std::size_t Width>
const std::array<Step, Width>& tuple_of(const std::array<Step, Width>& simplex) {
    return simplex;
}

/// For each of the simplices the witnesses with all vertices among the first `allowed` of their lists.
template <class Simplex>
WitnessLists witnesses_of(const PlaneComplex& complex, const std::vector<Simplex>& simplices, std::uint32_t allowed) {
    const std::uint32_t length = complex.list_length();
    // By landmark: the witnesses that have it among the first `allowed`, ascending.
    std::vector<std::vector<std::uint32_t>> seen_by(complex.landmark_count() + std::size_t{1});
    for (std::size_t first = 0; first < complex.lists().size(); first += length) {
        for (std::uint32_t rank = 0; rank < std::min(allowed, length); ++rank) {
            seen_by[complex.lists()[first + rank]].push_back(static_cast<std::uint32_t>(first / length));
        }
    }
    WitnessLists found;
    std::vector<std::uint32_t> common, rest;
    for (const Simplex& simplex : simplices) {
        const auto& tuple = tuple_of(simplex);
        common = seen_by[tuple[0]];
        for (std::size_t i = 1; i < tuple.size(); ++i) {
            rest.clear();
            const auto& others = seen_by[tuple[i]];
            std::set_intersection(common.begin(), common.end(), others.begin(), others.end(), std::back_inserter(rest));
            common.swap(rest);
        }
        found.witnesses.insert(found.witnesses.end(), common.begin(), common.end());
        found.first.push_back(static_cast<std::uint32_t>(found.witnesses.size()));
    }
    return found;
}

}  // namespace

Result<PlanePicture> plane_picture(const PlaneScene& scene, const PlaneBox& box) {
    const bool is_box = box.left < box.right && box.bottom < box.top && std::abs(box.left) <= kMaxCoordinate &&
                        std::abs(box.right) <= kMaxCoordinate && std::abs(box.bottom) <= kMaxCoordinate &&
                        std::abs(box.top) <= kMaxCoordinate;
    if (!is_box) {
        return Error{ErrorCode::InvalidOption,
                     "The box must have a left side before its right one, and a bottom "
                     "below its top."};
    }
    const auto made = PlaneComplex::of(scene);
    if (!made) return made.error();
    const PlaneComplex& complex = made.value();
    PlanePicture picture;
    picture.delaunay_edges = complex.delaunay_edges();
    picture.delaunay_triangles = complex.delaunay_triangles();
    picture.list_length = complex.list_length();
    picture.lists = complex.lists();
    picture.vertices = complex.vertices();
    picture.edges = complex.edges();
    picture.triangles = complex.triangles();
    picture.witnesses = {witnesses_of(complex, complex.vertices(), complex.nu(0)),
                         witnesses_of(complex, complex.edges(), complex.nu(1)),
                         witnesses_of(complex, complex.triangles(), complex.nu(2))};
    picture.betti = complex.betti();
    picture.cells = voronoi_cells(scene, complex, box);
    picture.pair_cells = order_two_cells(scene, complex, box);
    return picture;
}

Result<Inspection> plane_why(const PlaneScene& scene, std::vector<Step> vertices) {
    const auto complex = PlaneComplex::of(scene);
    if (!complex) return complex.error();
    return inspected(complex.value(), std::move(vertices));
}

}  // namespace plateau
