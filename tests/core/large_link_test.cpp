// A landmark in the middle of a sphere of landmarks: its link has more vertices than a machine word has bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>
#include <vector>

#include "base/random.h"
#include "delaunay/delaunay.h"
#include "session/engine.h"

namespace plateau {
namespace {

constexpr std::uint32_t kShell = 110;
constexpr std::uint32_t kInside = 120;

/// First the shell, then the middle, then witnesses between them.
PointCloud shell_and_middle(std::uint64_t seed) {
    Random random(seed);
    PointCloud cloud{3, {}};
    const auto add = [&](double low, double high) {
        for (;;) {
            std::array<double, 3> p{};
            for (double& x : p) x = random.next_between(-1, 1);
            const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
            if (length < 0.1 || length > 1) continue;
            const double radius = random.next_between(low, high);
            for (const double x : p) cloud.coordinates.push_back(x / length * radius);
            return;
        }
    };
    for (std::uint32_t i = 0; i < kShell; ++i) add(0.999, 1.001);
    add(0, 0.001);
    for (std::uint32_t i = 0; i < kInside; ++i) add(0.2, 0.9);
    return cloud;
}

/// The first six landmarks (points 0 .. count-1, by step = index + 1) of every point.
std::vector<std::set<Step>> nearest_six(const PointCloud& cloud, std::uint32_t count) {
    std::vector<std::set<Step>> lists;
    for (std::uint32_t w = 0; w < cloud.size(); ++w) {
        std::vector<std::pair<double, Step>> all;
        for (std::uint32_t p = 0; p < count; ++p) {
            double squared = 0;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double gap = cloud.point(w)[axis] - cloud.point(p)[axis];
                squared += gap * gap;
            }
            all.emplace_back(squared, p + 1);
        }
        std::sort(all.begin(), all.end());
        std::set<Step> list;
        for (std::size_t k = 0; k < 6; ++k) list.insert(all[k].second);
        lists.push_back(std::move(list));
    }
    return lists;
}

class LargeLink : public testing::TestWithParam<std::uint64_t> {};

TEST_P(LargeLink, BearsExactlyWhatHasWitnesses) {
    const PointCloud cloud = shell_and_middle(GetParam());
    Engine engine(cloud, {.family = Family::Delaunay, .metric = {}, .dimension = 3, .nu = {{1, 6, 6, 4}}});
    Delaunay delaunay(3);
    engine.prepare(Deadline::never());
    const DelaunayChange* change = nullptr;
    for (std::uint32_t i = 0; i <= kShell; ++i) {
        ASSERT_FALSE(engine.begin_step(i));
        ASSERT_TRUE(engine.finish_step(Deadline::never()));
        change = delaunay.insert(i + 1, cloud.point(i), std::max(1u, i)).value();
    }
    const Step middle = kShell + 1;
    const auto lists = nearest_six(cloud, middle);
    const auto witnessed = [&](const std::vector<Step>& tuple) {
        return std::any_of(lists.begin(), lists.end(), [&](const std::set<Step>& list) {
            return std::all_of(tuple.begin(), tuple.end(), [&](Step vertex) { return list.count(vertex) != 0; });
        });
    };
    std::set<std::vector<Step>> expected;
    std::set<Step> link;
    for (const CellId id : change->born) {
        const DelaunayCell& cell = delaunay.cell(id);
        if (!cell.finite(3)) continue;
        for (const Step a : cell.vertex) {
            if (a != middle) link.insert(a);
            for (const Step b : cell.vertex) {
                if (a >= b || b == middle) continue;
                // In general position nothing hinders a triangle but the want of a witness of itself or of its edges.
                const bool lives =
                    witnessed({a, b, middle}) && witnessed({a, b}) && witnessed({a, middle}) && witnessed({b, middle});
                if (lives) expected.insert({a, b, middle});
            }
        }
    }
    ASSERT_GT(link.size(), 100u);
    ASSERT_GT(expected.size(), 50u);

    std::set<std::vector<Step>> born;
    const SimplexTable& triangles = engine.timeline().table(2);
    for (SimplexIndex i = triangles.first_of_step[middle]; i < triangles.size(); ++i) {
        const auto tuple = triangles.tuple(i);
        born.emplace(tuple.begin(), tuple.end());
    }
    EXPECT_EQ(born, expected);
}

INSTANTIATE_TEST_SUITE_P(Shells, LargeLink, testing::Range(std::uint64_t{1}, std::uint64_t{9}));

}  // namespace
}  // namespace plateau
