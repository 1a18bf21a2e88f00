// What it would take to have Betti numbers at every step without this program: rebuild the complex of the first i
// landmarks with GUDHI's public classes, for every i. Measured at sampled i and integrated over i by trapezoids,
// against our whole run of the same family in the same process. The Betti numbers at the sampled steps must be equal.
//
//   rebuild_bench CLOUD N FAMILY [INTERVALS]    FAMILY: witness or delaunay

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

// GUDHI 3.7 prints without including this.
#include <iostream>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <gudhi/Persistent_cohomology.h>
#include <gudhi/Simplex_tree.h>
#include <gudhi/Witness_complex.h>
#include <nanoflann.hpp>

#include "bench_support.h"

namespace plateau::bench {
namespace {

using Tree = Gudhi::Simplex_tree<>;
using Table = std::vector<std::vector<std::pair<std::size_t, double>>>;

// The first landmarks, as nanoflann wants to see them.
struct Landmarks {
    const PointCloud* cloud;
    std::span<const std::uint32_t> chosen;
    std::size_t kdtree_get_point_count() const { return chosen.size(); }
    double kdtree_get_pt(std::size_t i, std::size_t axis) const { return cloud->point(chosen[i])[axis]; }
    template <class Box>
    bool kdtree_get_bbox(Box&) const {
        return false;
    }
};

// For every witness its nearest landmarks with their squared distances, nearest first.
Table nearest_landmarks(const Landmarks& landmarks, std::size_t count) {
    using Search =
        nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Landmarks>, Landmarks, 3, std::size_t>;
    Search search(3, landmarks);
    count = std::min(count, landmarks.chosen.size());
    std::vector<std::size_t> index(count);
    std::vector<double> distance(count);
    Table table(landmarks.cloud->size());
    for (std::uint32_t w = 0; w < landmarks.cloud->size(); ++w) {
        search.knnSearch(landmarks.cloud->point(w).data(), count, index.data(), distance.data());
        for (std::size_t k = 0; k < count; ++k) table[w].emplace_back(index[k], distance[k]);
    }
    return table;
}

// C_(1,2,3,4): GUDHI's own witness complex without relaxation.
void build_witness(const Landmarks& landmarks, Tree& tree) {
    const Gudhi::witness_complex::Witness_complex<Table> complex(nearest_landmarks(landmarks, 4));
    complex.create_complex(tree, 0, 3);
}

// All simplices of `Size` vertices that are among the first `nu` of some witness's list, sorted.
template <std::size_t Size>
std::vector<std::array<int, Size>> witnessed(const Table& table, std::size_t nu) {
    std::vector<std::array<int, Size>> found;
    for (const auto& list : table) {
        std::vector<bool> taken(std::min(nu, list.size()));
        if (taken.size() < Size) continue;
        std::fill_n(taken.begin(), Size, true);
        do {
            std::array<int, Size> simplex;
            auto vertex = simplex.begin();
            for (std::size_t k = 0; k < taken.size(); ++k) {
                if (taken[k]) *vertex++ = static_cast<int>(list[k].first);
            }
            std::sort(simplex.begin(), simplex.end());
            found.push_back(simplex);
        } while (std::prev_permutation(taken.begin(), taken.end()));
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

// Inserts a simplex of D(L) if it is witnessed and all of its facets are in the tree.
template <std::size_t Size>
void insert_if_witnessed(std::array<int, Size> simplex, const std::vector<std::array<int, Size>>& candidates,
                         Tree& tree) {
    std::sort(simplex.begin(), simplex.end());
    if (!std::binary_search(candidates.begin(), candidates.end(), simplex)) return;
    for (std::size_t omitted = 0; omitted < Size; ++omitted) {
        std::array<int, Size - 1> face;
        std::remove_copy(simplex.begin(), simplex.end(), face.begin(), simplex[omitted]);
        if (tree.find(face) == tree.null_simplex()) return;
    }
    tree.insert_simplex(simplex);
}

// C_(1,6,6,4) within D(L), with CGAL's triangulation of the landmarks inserted at once.
void build_delaunay(const Landmarks& landmarks, Tree& tree) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Vertex = CGAL::Triangulation_vertex_base_with_info_3<int, Kernel>;
    using Triangulation = CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Vertex>>;
    std::vector<std::pair<Kernel::Point_3, int>> points;
    for (std::size_t i = 0; i < landmarks.chosen.size(); ++i) {
        const auto p = landmarks.cloud->point(landmarks.chosen[i]);
        points.emplace_back(Kernel::Point_3(p[0], p[1], p[2]), static_cast<int>(i));
        tree.insert_simplex({static_cast<int>(i)});
    }
    const Triangulation triangulation(points.begin(), points.end());

    const Table table = nearest_landmarks(landmarks, 6);
    const auto edges = witnessed<2>(table, 6);
    for (const auto& [cell, i, j] : triangulation.finite_edges()) {
        insert_if_witnessed<2>({cell->vertex(i)->info(), cell->vertex(j)->info()}, edges, tree);
    }
    const auto triangles = witnessed<3>(table, 6);
    for (const auto& [cell, opposite] : triangulation.finite_facets()) {
        std::array<int, 3> simplex;
        auto vertex = simplex.begin();
        for (int k = 0; k < 4; ++k) {
            if (k != opposite) *vertex++ = cell->vertex(k)->info();
        }
        insert_if_witnessed<3>(simplex, triangles, tree);
    }
    const auto tetrahedra = witnessed<4>(table, 4);
    for (const auto cell : triangulation.finite_cell_handles()) {
        std::array<int, 4> simplex;
        for (int k = 0; k < 4; ++k) simplex[static_cast<std::size_t>(k)] = cell->vertex(k)->info();
        insert_if_witnessed<4>(simplex, tetrahedra, tree);
    }
}

std::vector<std::uint32_t> betti_by_gudhi(Tree& tree) {
    using namespace Gudhi::persistent_cohomology;
    constexpr bool kTopDimensionToo = true;
    Persistent_cohomology<Tree, Field_Zp> cohomology(tree, kTopDimensionToo);
    cohomology.init_coefficients(2);
    cohomology.compute_persistent_cohomology();
    std::vector<std::uint32_t> betti(3, 0);
    const auto all = cohomology.betti_numbers();
    for (std::size_t k = 0; k < betti.size() && k < all.size(); ++k) betti[k] = static_cast<std::uint32_t>(all[k]);
    return betti;
}

struct Sample {
    Step step;
    double seconds;
};

// Seconds for all steps 1 .. last: the time between two sampled steps goes straight.
double integrated(const std::vector<Sample>& samples) {
    double sum = samples.front().seconds;
    for (std::size_t k = 1; k < samples.size(); ++k) {
        const auto [from, before] = samples[k - 1];
        const auto [to, after] = samples[k];
        sum += (to - from) * (before + after) / 2;
    }
    return sum;
}

int measure(const std::string& name, std::uint32_t size, Family family, std::uint32_t intervals) {
    const PointCloud cloud = make_cloud(name, size);
    std::optional<Session> session;
    const double ours = spent_on([&] { session.emplace(whole_run(cloud, family)); }).seconds;
    const Timeline& timeline = session->timeline();

    std::vector<Sample> samples;
    for (std::uint32_t k = 0; k <= intervals; ++k) {
        const auto last = static_cast<std::uint64_t>(timeline.step_count - 1);
        const auto step = static_cast<Step>(1 + last * k / intervals);
        const Landmarks landmarks{&cloud, {timeline.landmarks.data(), step}};
        std::vector<std::uint32_t> betti;
        const Spent spent = spent_on([&] {
            Tree tree;
            family == Family::Witness ? build_witness(landmarks, tree) : build_delaunay(landmarks, tree);
            betti = betti_by_gudhi(tree);
        });
        const auto expected = timeline.betti_at(step);
        if (!std::equal(betti.begin(), betti.end(), expected.begin(), expected.end())) {
            std::fprintf(stderr, "step %u: GUDHI has Betti numbers %u %u %u, this run %u %u %u\n", step, betti[0],
                         betti[1], betti[2], expected[0], expected[1], expected[2]);
            return 1;
        }
        samples.push_back({step, spent.seconds});
    }
    std::printf("{\"seconds\": %.6f, \"rebuildSeconds\": %.3f, \"equalBettiAt\": [", ours, integrated(samples));
    for (const Sample& sample : samples) std::printf("%s%u", &sample == samples.data() ? "" : ", ", sample.step);
    std::printf("], \"secondsAt\": [");
    for (const Sample& sample : samples) std::printf("%s%.4f", &sample == samples.data() ? "" : ", ", sample.seconds);
    std::printf("]}\n");
    return 0;
}

int main_with(const std::vector<std::string>& words) {
    const auto family = words.size() >= 3 ? family_named(words[2]) : std::nullopt;
    if (words.size() > 4 || (family != Family::Witness && family != Family::Delaunay)) {
        std::fprintf(stderr, "rebuild_bench CLOUD N witness|delaunay [INTERVALS]\n");
        return 2;
    }
    const auto number = [&](std::size_t word) { return static_cast<std::uint32_t>(std::stoul(words[word])); };
    return measure(words[0], number(1), *family, words.size() == 4 ? number(3) : 16);
}

}  // namespace
}  // namespace plateau::bench

int main(int count, char** arguments) {
    return plateau::bench::main_with(std::vector<std::string>(arguments + 1, arguments + count));
}
