#include "plane/plane_complex.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <string>
#include <utility>

#include "complex/nu_complex.h"
#include "delaunay/delaunay.h"
#include "homology/echelon.h"
#include "inspect/landmark_ranks.h"
#include "landmarks/landmark_lists.h"
#include "metrics/distance_rows.h"

namespace plateau {

namespace {

constexpr std::uint32_t kLargestNu = 32;
constexpr std::uint32_t kShortestList = 3;

/// From a landmark, by its row, to all witnesses.
class PlaneRows : public DistanceRows {
public:
    explicit PlaneRows(const PlaneScene& scene) : scene_(&scene) {}
    void fill(std::uint32_t landmark, const Limits&, std::span<double> row) override {
        const auto place = scene_->landmarks.point(landmark);
        for (std::uint32_t witness = 0; witness < row.size(); ++witness) {
            row[witness] = distance_squared(place, scene_->witnesses.point(witness));
        }
    }
    double distance(double comparable) const override { return std::sqrt(comparable); }

private:
    const PlaneScene* scene_;
};

Error invalid(std::string message) {
    return {ErrorCode::InvalidOption, std::move(message)};
}

std::optional<Error> objection_to_points(const PointCloud& cloud, const std::string& what) {
    if (cloud.coordinates.size() % 2 != 0) return invalid("A " + what + " lacks its second coordinate.");
    for (std::size_t i = 0; i < cloud.coordinates.size(); ++i) {
        if (std::abs(cloud.coordinates[i]) <= kMaxCoordinate) continue;
        return Error{ErrorCode::NotANumber, "A coordinate of " + what + " " + std::to_string(i / 2 + 1) +
                                                " is no number that can be computed with."};
    }
    return std::nullopt;
}

std::optional<Error> objection_to_duplicates(const PointCloud& landmarks) {
    std::vector<std::uint32_t> order(landmarks.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto before = [&](std::uint32_t a, std::uint32_t b) {
        const auto x = landmarks.point(a);
        const auto y = landmarks.point(b);
        if (x[0] != y[0]) return x[0] < y[0];
        return x[1] != y[1] ? x[1] < y[1] : a < b;
    };
    std::sort(order.begin(), order.end(), before);
    for (std::size_t i = 1; i < order.size(); ++i) {
        if (distance_squared(landmarks.point(order[i - 1]), landmarks.point(order[i])) > 0) continue;
        return invalid("Landmarks " + std::to_string(order[i - 1] + 1) + " and " + std::to_string(order[i] + 1) +
                       " are in one place: move one of them, or leave it out.");
    }
    return std::nullopt;
}

}  // namespace

std::optional<Error> objection_to(const PlaneScene& scene) {
    if (auto error = objection_to_points(scene.witnesses, "witness")) return error;
    if (auto error = objection_to_points(scene.landmarks, "landmark")) return error;
    if (scene.nu.empty() || scene.nu.front() == 0) {
        return invalid("The first entry of nu must be at least 1: it is about the landmarks.");
    }
    for (const std::uint32_t entry : scene.nu) {
        if (entry > kLargestNu) return invalid("Every entry of nu must be at most " + std::to_string(kLargestNu) + ".");
    }
    return objection_to_duplicates(scene.landmarks);
}

Result<PlaneComplex> PlaneComplex::of(const PlaneScene& scene) {
    if (auto error = objection_to(scene)) return std::move(*error);
    PlaneComplex complex(scene);
    if (scene.landmarks.size() == 0) return complex;
    if (auto error = complex.insert_landmarks()) return std::move(*error);
    return complex;
}

std::optional<Error> PlaneComplex::insert_landmarks() {
    const std::uint32_t witnesses = scene_->witnesses.size();
    const std::uint32_t landmarks = scene_->landmarks.size();
    const std::uint32_t largest_nu = *std::max_element(scene_->nu.begin(), scene_->nu.end());
    const std::uint32_t kappa = std::max(largest_nu, kShortestList);
    list_length_ = std::min(landmarks, kappa);
    LandmarkLists lists(std::make_unique<PlaneRows>(*scene_), witnesses, kappa);
    lists.prepare(Deadline::never());
    Delaunay delaunay(2);
    NuComplex complex({scene_->nu}, 2, witnesses);
    std::vector<SimplexTable> tables(2);
    tables[1].dimension = 2;
    for (Step step = 1; step <= landmarks; ++step) {
        // The landmark before it: in pictures one is seldom far from the next.
        const auto change = delaunay.insert(step, scene_->landmarks.point(step - 1), step > 1 ? step - 1 : 1);
        if (!change) return change.error();
        const auto entries = lists.insert(step - 1, step);
        if (scene_->within_delaunay) {
            complex.insert(step, lists, entries, delaunay, *change.value(), tables);
        } else {
            complex.insert(step, lists, entries, tables);
        }
    }
    for (WitnessId witness = 0; witness < witnesses; ++witness) {
        const auto list = lists.list(witness).first(list_length_);
        lists_.insert(lists_.end(), list.begin(), list.end());
    }
    for (CellId id = 0; id < delaunay.cell_capacity(); ++id) {
        const DelaunayCell& cell = delaunay.cell(id);
        if (!cell.alive || !cell.finite(delaunay.dimension())) continue;
        std::vector<Step> corners(cell.vertex.begin(), cell.vertex.begin() + delaunay.dimension() + 1);
        std::sort(corners.begin(), corners.end());
        if (corners.size() == 3) delaunay_triangles_.push_back({corners[0], corners[1], corners[2]});
        for (std::size_t b = 1; b < corners.size(); ++b) {
            for (std::size_t a = 0; a < b; ++a) delaunay_edges_.push_back({corners[a], corners[b]});
        }
    }
    std::sort(delaunay_triangles_.begin(), delaunay_triangles_.end());
    std::sort(delaunay_edges_.begin(), delaunay_edges_.end());
    delaunay_edges_.erase(std::unique(delaunay_edges_.begin(), delaunay_edges_.end()), delaunay_edges_.end());
    keep_witnessed(tables);
    return std::nullopt;
}

// What lives with all its vertices. A landmark is a vertex iff some witness has it among its first nu_0.
void PlaneComplex::keep_witnessed(const std::vector<SimplexTable>& tables) {
    std::vector<bool> is_vertex(landmark_count() + std::size_t{1}, false);
    for (std::size_t first = 0; first < lists_.size(); first += list_length_) {
        for (std::uint32_t rank = 0; rank < std::min(nu(0), list_length_); ++rank)
            is_vertex[lists_[first + rank]] = true;
    }
    for (Step landmark = 1; landmark <= landmark_count(); ++landmark) {
        if (is_vertex[landmark]) vertices_.push_back(landmark);
    }
    for (const SimplexTable& table : tables) {
        for (SimplexIndex index = 0; index < table.size(); ++index) {
            const auto tuple = table.tuple(index);
            const bool has_vertices =
                std::all_of(tuple.begin(), tuple.end(), [&](Step vertex) { return bool{is_vertex[vertex]}; });
            if (!has_vertices || table.death[0][index] != kNever) continue;
            if (table.dimension == 1) edges_.push_back({tuple[0], tuple[1]});
            if (table.dimension == 2) triangles_.push_back({tuple[0], tuple[1], tuple[2]});
        }
    }
    std::sort(edges_.begin(), edges_.end());
    std::sort(triangles_.begin(), triangles_.end());
}

std::array<std::uint32_t, 2> PlaneComplex::betti() const {
    const auto place_of = [](const auto& sorted, const auto& one) {
        return static_cast<std::uint32_t>(std::lower_bound(sorted.begin(), sorted.end(), one) - sorted.begin());
    };
    Echelon boundaries(2);
    boundaries.reset(static_cast<std::uint32_t>(vertices_.size()));
    for (const auto& [a, b] : edges_) {
        boundaries.insert({{place_of(vertices_, a), 1}, {place_of(vertices_, b), 1}});
    }
    const std::uint32_t rank_of_edges = boundaries.rank();
    boundaries.reset(static_cast<std::uint32_t>(edges_.size()));
    for (const auto& [a, b, c] : triangles_) {
        // In lexicographic order, as the edges are.
        boundaries.insert(
            {{place_of(edges_, Edge{a, b}), 1}, {place_of(edges_, Edge{a, c}), 1}, {place_of(edges_, Edge{b, c}), 1}});
    }
    const auto vertices = static_cast<std::uint32_t>(vertices_.size());
    const auto edges = static_cast<std::uint32_t>(edges_.size());
    return {vertices - rank_of_edges, edges - rank_of_edges - boundaries.rank()};
}

bool PlaneComplex::has(std::span<const Step> simplex) const {
    switch (simplex.size()) {
        case 1:
            return std::binary_search(vertices_.begin(), vertices_.end(), simplex[0]);
        case 2:
            return std::binary_search(edges_.begin(), edges_.end(), Edge{simplex[0], simplex[1]});
        case 3:
            return std::binary_search(triangles_.begin(), triangles_.end(),
                                      Triangle{simplex[0], simplex[1], simplex[2]});
        default:
            return false;
    }
}

Result<std::optional<DelaunayPlace>> PlaneComplex::delaunay(std::span<const Step> simplex) const {
    if (!scene_->within_delaunay) return std::optional<DelaunayPlace>();
    auto place = delaunay_place(scene_->landmarks, simplex);
    if (!place) return place.error();
    return std::optional(std::move(place).value());
}

std::optional<Error> PlaneComplex::look_at_witnesses(Inspection& inspection) const {
    const TreeRanks ranks(scene_->witnesses, scene_->landmarks);
    inspection.allowed = nu(inspection.about.size() - 1);
    inspection.horizon = ranks.horizon();
    inspection.sightings = sightings(ranks, inspection.about, inspection.allowed);
    return std::nullopt;
}

}  // namespace plateau
