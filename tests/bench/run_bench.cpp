// One measurement a process, so that its peak memory is its own: seconds of a whole run, of a part of it, or of T_D,
// CGAL alone inserting the same landmarks in the same order with the same hints. Nothing asserts a time.
//
//   run_bench CLOUD N WHAT       one line: {"seconds": ..., "megabytes": ..., "share": of a processor}
//   run_bench --write CLOUD N    the cloud as text on standard output, for the module
//
// CLOUD: a sample shape or `cube`. WHAT: a family (its whole run), `T_D`, or a part: `lists`, `lists+D`,
// `lists+D+complex`.

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <string>
#include <vector>

#include "bench_support.h"
#include "complex/nu_complex.h"
#include "delaunay/delaunay.h"
#include "landmarks/landmark_lists.h"

namespace plateau::bench {
namespace {

struct Order {
    std::vector<std::uint32_t> landmarks;  // input indices
    std::vector<std::uint32_t> hints;      // step of the nearest earlier landmark
};

enum class Depth { Lists = 1, Delaunay = 2, Complex = 3 };

// Farthest-first order, with the rooms up to `depth`.
Order run_rooms(const PointCloud& cloud, Depth depth) {
    Order order;
    LandmarkLists lists(cloud, 6);
    lists.prepare(Deadline::never());
    Delaunay delaunay(cloud.dimension);
    NuComplex complex({{1, 6, 6, 4}}, 3, cloud.size());
    std::vector<SimplexTable> tables(3);
    for (int k = 1; k <= 3; ++k) tables[static_cast<std::size_t>(k - 1)].dimension = k;
    for (Step step = 1; step <= cloud.size(); ++step) {
        const std::uint32_t next = step == 1 ? 0 : lists.farthest();
        order.landmarks.push_back(next);
        order.hints.push_back(lists.list(lists.witness(next))[0]);
        const DelaunayChange* change = nullptr;
        if (depth >= Depth::Delaunay) change = delaunay.insert(step, cloud.point(next), order.hints.back()).value();
        const auto entries = lists.insert(next, step);
        if (depth >= Depth::Complex) complex.insert(step, lists, entries, delaunay, *change, tables);
        if (lists.farthest_comparable() == 0) break;
    }
    return order;
}

void insert_with_cgal_alone(const PointCloud& cloud, const Order& order) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    CGAL::Delaunay_triangulation_3<Kernel> triangulation;
    std::vector<CGAL::Delaunay_triangulation_3<Kernel>::Vertex_handle> vertex(order.landmarks.size() + 1);
    for (std::size_t i = 0; i < order.landmarks.size(); ++i) {
        const auto p = cloud.point(order.landmarks[i]);
        const Kernel::Point_3 point(p[0], p[1], p[2]);
        vertex[i + 1] =
            i == 0 ? triangulation.insert(point) : triangulation.insert(point, vertex[order.hints[i]]->cell());
    }
}

// The work that is timed; undefined for an unknown word.
std::function<void()> work_named(const std::string& what, const PointCloud& cloud) {
    if (const auto family = family_named(what)) return [&cloud, family] { whole_run(cloud, *family); };
    if (what == "lists") return [&cloud] { run_rooms(cloud, Depth::Lists); };
    if (what == "lists+D") return [&cloud] { run_rooms(cloud, Depth::Delaunay); };
    if (what == "lists+D+complex") return [&cloud] { run_rooms(cloud, Depth::Complex); };
    // The lists that give the order are freed before CGAL begins; they are smaller than its triangulation.
    if (what == "T_D") {
        return [&cloud, order = run_rooms(cloud, Depth::Lists)] { insert_with_cgal_alone(cloud, order); };
    }
    return {};
}

int main_with(const std::vector<std::string>& words) {
    if (words.size() != 3) {
        std::fprintf(stderr, "run_bench CLOUD N WHAT | --write CLOUD N\n");
        return 2;
    }
    if (words[0] == "--write") {
        const PointCloud cloud = make_cloud(words[1], static_cast<std::uint32_t>(std::stoul(words[2])));
        for (std::uint32_t i = 0; i < cloud.size(); ++i) {
            const auto p = cloud.point(i);
            std::printf("%.17g %.17g %.17g\n", p[0], p[1], p[2]);
        }
        return 0;
    }
    const PointCloud cloud = make_cloud(words[0], static_cast<std::uint32_t>(std::stoul(words[1])));
    const auto work = work_named(words[2], cloud);
    if (!work) {
        std::fprintf(stderr, "There is nothing named %s to measure.\n", words[2].c_str());
        return 2;
    }
    const auto [seconds, share] = spent_on(work);
    std::printf("{\"seconds\": %.6f, \"megabytes\": %.1f, \"share\": %.2f}\n", seconds, peak_megabytes(), share);
    return 0;
}

}  // namespace
}  // namespace plateau::bench

int main(int count, char** arguments) {
    return plateau::bench::main_with(std::vector<std::string>(arguments + 1, arguments + count));
}
