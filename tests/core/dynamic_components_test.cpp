#include "base/dynamic_components.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "base/random.h"

namespace plateau {
namespace {

/// A graph as sets, with the number of its components by a walk over all of it.
struct PlainGraph {
    std::map<std::uint32_t, std::set<std::uint32_t>> neighbors;

    std::uint32_t components() const {
        std::set<std::uint32_t> seen;
        std::uint32_t count = 0;
        for (const auto& [start, unused] : neighbors) {
            if (!seen.insert(start).second) continue;
            ++count;
            std::vector<std::uint32_t> stack{start};
            while (!stack.empty()) {
                const std::uint32_t node = stack.back();
                stack.pop_back();
                for (const std::uint32_t neighbor : neighbors.at(node)) {
                    if (seen.insert(neighbor).second) stack.push_back(neighbor);
                }
            }
        }
        return count;
    }
};

struct Play {
    std::uint32_t node_count;
    bool has_endless;
    double edges_a_node;  // aimed at
    double churn;         // of nodes at a step
};

void play(const Play& rules, std::uint64_t seed) {
    Random random(seed);
    const auto pick = [&](std::uint32_t below) { return static_cast<std::uint32_t>(random.next_unit() * below); };
    PlainGraph graph;
    DynamicComponents components(rules.has_endless ? 0 : DynamicComponents::kNoNode);
    components.resize(rules.node_count);
    const auto disconnect = [&](std::uint32_t a, std::uint32_t b) {
        graph.neighbors[a].erase(b);
        graph.neighbors[b].erase(a);
        components.remove_edge(a, b);
    };
    if (rules.has_endless) {
        graph.neighbors[0];
        components.add_node(0);
    }
    for (int step = 0; step < 300; ++step) {
        std::set<std::uint32_t> touched;  // a node comes or goes once a step
        for (std::uint32_t i = 0; i < 1 + rules.churn * rules.node_count; ++i) {
            const std::uint32_t node = pick(rules.node_count);
            if ((rules.has_endless && node == 0) || !touched.insert(node).second) continue;
            if (graph.neighbors.count(node) == 0) {
                graph.neighbors[node];
                components.add_node(node);
            } else if (random.next_unit() < 0.5) {
                const auto around = graph.neighbors[node];
                for (const std::uint32_t neighbor : around) disconnect(node, neighbor);
                graph.neighbors.erase(node);
                components.remove_node(node);
            }
        }
        std::size_t ends = 0;
        for (const auto& [node, around] : graph.neighbors) ends += around.size();
        std::set<std::pair<std::uint32_t, std::uint32_t>> changed;  // so does an edge
        const auto wanted = static_cast<std::size_t>(rules.edges_a_node * static_cast<double>(graph.neighbors.size()));
        for (std::uint32_t i = 0; i < 1 + rules.churn * rules.node_count; ++i) {
            const std::uint32_t a = pick(rules.node_count);
            const std::uint32_t b = (a + 1 + pick(3)) % rules.node_count;  // long ways around
            if (a == b || graph.neighbors.count(a) == 0 || graph.neighbors.count(b) == 0) continue;
            if (!changed.insert(std::minmax(a, b)).second) continue;
            if (graph.neighbors[a].count(b) != 0) {
                disconnect(a, b);
            } else if (ends / 2 < wanted) {
                graph.neighbors[a].insert(b);
                graph.neighbors[b].insert(a);
                components.add_edge(a, b);
            }
        }
        components.settle([&](std::uint32_t node, const auto& use) {
            ASSERT_FALSE(rules.has_endless && node == 0) << "the endless node is not to be walked";
            for (const std::uint32_t neighbor : graph.neighbors.at(node)) use(neighbor);
        });
        ASSERT_EQ(components.count(), graph.components()) << "step " << step << ", seed " << seed;
    }
}

TEST(DynamicComponents, CountsAsAWalkDoes) {
    for (const double edges_a_node : {0.6, 1.0, 1.3, 2.0}) {
        for (const double churn : {0.0, 0.05, 0.4}) {
            for (std::uint64_t seed = 1; seed <= 6; ++seed) {
                play({40, false, edges_a_node, churn}, seed);
                play({40, true, edges_a_node, churn}, seed + 100);
            }
        }
    }
}

// A ring that is cut once stays whole; cut twice it is two pieces, found from the smaller.
TEST(DynamicComponents, ARingFallsApartAtTheSecondCut) {
    constexpr std::uint32_t kSize = 1000;
    std::vector<bool> whole(kSize, true);  // edge i joins i and i + 1
    DynamicComponents components;
    components.resize(kSize);
    for (std::uint32_t i = 0; i < kSize; ++i) components.add_node(i);
    for (std::uint32_t i = 0; i < kSize; ++i) components.add_edge(i, (i + 1) % kSize);
    std::uint32_t visited = 0;
    const auto visit_neighbors = [&](std::uint32_t node, const auto& use) {
        ++visited;
        if (whole[node]) use((node + 1) % kSize);
        if (whole[(node + kSize - 1) % kSize]) use((node + kSize - 1) % kSize);
    };
    components.settle(visit_neighbors);
    EXPECT_EQ(components.count(), 1u);
    for (const std::uint32_t cut : {10u, 14u}) {
        whole[cut] = false;
        components.remove_edge(cut, cut + 1);
        visited = 0;
        components.settle(visit_neighbors);
    }
    EXPECT_EQ(components.count(), 2u);
    EXPECT_LE(visited, 16u);
}

// What goes has a stand-in in what comes: nothing is searched.
TEST(DynamicComponents, AStandInSparesTheSearch) {
    DynamicComponents components;
    components.resize(4);
    for (std::uint32_t i = 0; i < 3; ++i) components.add_node(i);
    components.add_edge(0, 1);
    components.add_edge(1, 2);
    const auto none = [](std::uint32_t, const auto&) {};
    components.settle(none);
    components.remove_node(1);
    components.remove_edge(0, 1);
    components.remove_edge(1, 2);
    components.add_node(3);
    components.add_edge(0, 3);
    components.add_edge(3, 2);
    components.settle([](std::uint32_t node, const auto&) { FAIL() << "searched from " << node; });
    EXPECT_EQ(components.count(), 1u);
}

}  // namespace
}  // namespace plateau
