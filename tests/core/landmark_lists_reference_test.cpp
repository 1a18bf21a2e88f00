// The witness tree against sorting: every list and the farthest witness after every insertion.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "clouds.h"
#include "landmarks/landmark_lists.h"
#include "reference/witness.h"

namespace plateau {
namespace {

class LandmarkListsReference : public testing::TestWithParam<TestCloud> {};

/// Inserts the landmark of the step and compares all lists with the expected ones; empty or the first difference.
std::string insertion_difference(LandmarkLists& lists, int landmark, int step,
                                 const std::vector<std::vector<int>>& expected) {
    std::vector<bool> entered(lists.size());
    for (const ListEntry& entry :
         lists.insert(static_cast<std::uint32_t>(landmark), static_cast<std::uint32_t>(step))) {
        if (entered[entry.witness]) return "a witness entered twice";
        entered[entry.witness] = true;
        if (lists.list(entry.witness)[entry.rank] != static_cast<std::uint32_t>(step))
            return "an entry with another rank";
    }
    for (std::uint32_t w = 0; w < lists.size(); ++w) {
        const std::string name = "witness " + std::to_string(lists.input_index(w));
        std::vector<int> nearest = expected[lists.input_index(w)];
        nearest.resize(lists.kappa());  // 0 beyond the landmarks so far
        const auto list = lists.list(w);
        for (std::size_t rank = 0; rank < nearest.size(); ++rank) {
            if (static_cast<int>(list[rank]) != nearest[rank]) return name + " differs at rank " + std::to_string(rank);
        }
        const bool is_in = std::find(nearest.begin(), nearest.end(), step) != nearest.end();
        if (entered[w] != is_in) return name + (is_in ? " is not reported" : " is reported");
        if (lists.witness(lists.input_index(w)) != w) return name + " is not found by its index";
    }
    return "";
}

TEST_P(LandmarkListsReference, HoldsTheNearestLandmarksAtEveryStep) {
    const PointCloud& cloud = GetParam().cloud;
    for (const int first : {0, static_cast<int>(cloud.size()) - 1}) {
        const reference::FarthestOrder order = reference::farthest_point_order(cloud, first, GetParam().max_steps);
        std::vector<LandmarkLists> all;
        for (const std::uint32_t kappa : {1u, 2u, 6u, 9u}) {
            all.emplace_back(cloud, kappa);
            ASSERT_TRUE(all.back().prepare(Deadline::never()));
            ASSERT_EQ(all.back().size(), cloud.size());
        }
        for (std::size_t i = 0; i < order.landmarks.size(); ++i) {
            const auto step = static_cast<int>(i + 1);
            const auto expected = reference::landmark_lists(cloud, order, step);
            for (LandmarkLists& lists : all) {
                SCOPED_TRACE("kappa " + std::to_string(lists.kappa()) + ", step " + std::to_string(step));
                ASSERT_EQ(insertion_difference(lists, order.landmarks[i], step, expected), "");
                ASSERT_EQ(lists.farthest_comparable(), order.epsilon_squared[i]);
                if (i + 1 < order.landmarks.size()) {
                    ASSERT_EQ(lists.farthest(), static_cast<std::uint32_t>(order.landmarks[i + 1]));
                }
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Clouds, LandmarkListsReference, testing::ValuesIn(test_clouds()),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace plateau
