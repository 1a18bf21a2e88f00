// Times a whole run and its parts against T_D, CGAL alone inserting the same landmarks in the same order with the same
// hints, in one process: all in turn, several rounds, medians and ratios. Times are for reading, nothing asserts them.
//
//   run_bench [N]                      the table for the torus and the uniform cube (default 10,000 points)
//   run_bench --write CLOUD N          the cloud as text on standard output, for other timers
//   run_bench --session CLOUD N FAMILY milliseconds of one whole run, alone on the line

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/random.h"
#include "cloud/samples.h"
#include "complex/nu_complex.h"
#include "delaunay/delaunay.h"
#include "landmarks/landmark_lists.h"
#include "session/session.h"

namespace plateau {
namespace {

PointCloud make_cloud(std::string_view name, std::uint32_t size) {
    if (name != "cube") {
        auto sampled = sample_shape(name, {.size = size});
        if (!sampled) {
            std::fprintf(stderr, "%s\n", sampled.error().message.c_str());
            std::exit(2);
        }
        return std::move(sampled).value();
    }
    Random random(1);
    PointCloud cloud{3, {}};
    for (std::uint32_t i = 0; i < 3 * size; ++i) cloud.coordinates.push_back(random.next_unit());
    return cloud;
}

double milliseconds_of(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

struct Order {
    std::vector<std::uint32_t> landmarks;  // input indices
    std::vector<std::uint32_t> hints;      // step of the nearest earlier landmark
};

// Farthest-first order with the rooms up to `depth`: 1 lists, 2 and D(L), 3 and the complex.
Order run_rooms(const PointCloud& cloud, int depth) {
    Order order;
    LandmarkLists lists(cloud, 6);
    lists.prepare(Deadline(1e300));
    Delaunay delaunay(cloud.dimension);
    NuComplex complex({{1, 6, 6, 4}}, 3, cloud.size());
    std::vector<SimplexTable> tables(3);
    for (int k = 1; k <= 3; ++k) tables[static_cast<std::size_t>(k - 1)].dimension = k;
    for (Step step = 1; step <= cloud.size(); ++step) {
        const std::uint32_t next = step == 1 ? 0 : lists.farthest();
        order.landmarks.push_back(next);
        order.hints.push_back(lists.list(lists.witness(next))[0]);
        const DelaunayChange* change = nullptr;
        if (depth >= 2) change = delaunay.insert(step, cloud.point(next), order.hints.back()).value();
        const auto entries = lists.insert(next, step);
        if (depth >= 3) complex.insert(step, lists, entries, delaunay, *change, tables);
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

void run_session(const PointCloud& cloud, Family family) {
    auto session = [&] {
        RunOptions options;
        options.family = family;
        return Session::open(cloud, options);
    }();
    session.value().run({});
}

void print_table(const std::string& name, std::uint32_t size) {
    const PointCloud cloud = make_cloud(name, size);
    const Order order = run_rooms(cloud, 1);
    struct Row {
        const char* what;
        std::function<void()> work;
        std::vector<double> times;
    };
    std::vector<Row> rows{
        {"T_D: CGAL alone", [&] { insert_with_cgal_alone(cloud, order); }, {}},
        {"lists", [&] { run_rooms(cloud, 1); }, {}},
        {"lists, D(L)", [&] { run_rooms(cloud, 2); }, {}},
        {"lists, D(L), complex", [&] { run_rooms(cloud, 3); }, {}},
        {"whole run, delaunay", [&] { run_session(cloud, Family::Delaunay); }, {}},
        {"whole run, surface", [&] { run_session(cloud, Family::Surface); }, {}},
        {"whole run, auto", [&] { run_session(cloud, Family::Auto); }, {}},
    };
    for (int round = 0; round < 3; ++round) {
        for (Row& row : rows) row.times.push_back(milliseconds_of(row.work));
    }
    const double base = median(rows.front().times);
    std::printf("%s, n = %u (medians of 3, Betti numbers at every step in whole runs)\n", name.c_str(), size);
    for (const Row& row : rows) {
        const double time = median(row.times);
        std::printf("  %-24s %10.1f ms %8.2f T_D\n", row.what, time, time / base);
    }
}

std::optional<Family> family_named(std::string_view name) {
    if (name == "delaunay") return Family::Delaunay;
    if (name == "surface") return Family::Surface;
    if (name == "auto") return Family::Auto;
    if (name == "witness") return Family::Witness;
    return std::nullopt;
}

int main_with(const std::vector<std::string>& words) {
    if (words.size() == 3 && words[0] == "--write") {
        const PointCloud cloud = make_cloud(words[1], static_cast<std::uint32_t>(std::stoul(words[2])));
        for (std::uint32_t i = 0; i < cloud.size(); ++i) {
            const auto p = cloud.point(i);
            std::printf("%.17g %.17g %.17g\n", p[0], p[1], p[2]);
        }
        return 0;
    }
    if (words.size() == 4 && words[0] == "--session" && family_named(words[3])) {
        const PointCloud cloud = make_cloud(words[1], static_cast<std::uint32_t>(std::stoul(words[2])));
        std::printf("%.3f\n", milliseconds_of([&] { run_session(cloud, *family_named(words[3])); }));
        return 0;
    }
    if (words.size() > 1) {
        std::fprintf(stderr, "run_bench [N] | --write CLOUD N | --session CLOUD N FAMILY\n");
        return 2;
    }
    const std::uint32_t size = words.empty() ? 10000 : static_cast<std::uint32_t>(std::stoul(words[0]));
    print_table("torus", size);
    print_table("cube", size);
    return 0;
}

}  // namespace
}  // namespace plateau

int main(int count, char** arguments) {
    return plateau::main_with(std::vector<std::string>(arguments + 1, arguments + count));
}
