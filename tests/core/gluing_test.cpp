// Sides around an edge, glued through the outer wedges between them: pictures on the compass.

#include "surface/gluing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace plateau {
namespace {

/// Eight directions around the z axis, 45 degrees apart, counter-clockwise; the edge runs up the axis.
constexpr Step kBottom = 1;
constexpr Step kTop = 2;
constexpr Step kEast = 3;

Step at_degrees(int degrees) {
    return kEast + static_cast<Step>(degrees / 45);
}

/// An outer wedge, from the triangle at `from` counter-clockwise to the one at `to`, in degrees.
struct Wedge {
    int from, to;
};

/// Which triangle each wedge's first triangle is glued to, for every order of the sides.
void expect_glued_across(const std::vector<Wedge>& wedges) {
    const PointCloud cloud{
        3, {0, 0, 0, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 0, -1, 1, 0, -1, 0, 0, -1, -1, 0, 0, -1, 0, 1, -1, 0}};
    const std::vector<std::uint32_t> landmarks{0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
    const LandmarkPoints points{&cloud, &landmarks};
    std::vector<EdgeSide> sides;
    for (const Wedge& wedge : wedges) {
        // Counter-clockwise from outside: the side that opens the wedge runs up, the one that closes it down.
        for (const bool up : {true, false}) {
            const auto row = static_cast<std::uint32_t>(sides.size());
            sides.push_back({row, 2, at_degrees(up ? wedge.from : wedge.to), up});
        }
    }
    const auto by_row = [](const EdgeSide& a, const EdgeSide& b) { return a.row < b.row; };
    do {
        std::map<std::uint32_t, std::uint32_t> partner;
        for (const auto& [i, j] : pair_sides(sides, kBottom, kTop, points)) partner[sides[i].row] = sides[j].row;
        ASSERT_EQ(partner.size(), wedges.size());
        for (std::uint32_t k = 0; k < wedges.size(); ++k) {
            ASSERT_EQ(partner[2 * k], 2 * k + 1) << "wedge from " << wedges[k].from << " to " << wedges[k].to;
        }
    } while (std::next_permutation(sides.begin(), sides.end(), by_row));
}

TEST(Gluing, OneBodyIsGluedToItself) {
    expect_glued_across({{0, 225}});
    expect_glued_across({{225, 90}});
}

TEST(Gluing, BodiesThatTouchAtTheEdgeAreGluedToEachOther) {
    expect_glued_across({{0, 45}, {180, 225}});
    expect_glued_across({{45, 135}, {270, 0}});
}

TEST(Gluing, BothOthersInTheSameHalfTurn) {
    expect_glued_across({{0, 45}, {90, 135}});
    expect_glued_across({{180, 315}, {0, 45}});
    expect_glued_across({{90, 135}, {180, 225}, {270, 315}});
}

TEST(Gluing, StraightAcrossComesBeforeWhatLiesBeyond) {
    expect_glued_across({{0, 180}, {225, 270}});
    expect_glued_across({{0, 90}, {135, 180}});
    expect_glued_across({{45, 225}, {270, 0}});
}

TEST(Gluing, ASheetMeetsItsOwnOtherSideLast) {
    expect_glued_across({{0, 0}});
    expect_glued_across({{0, 90}, {180, 0}});
    expect_glued_across({{0, 225}, {270, 0}});
    expect_glued_across({{0, 135}, {135, 225}, {225, 0}});
    expect_glued_across({{0, 180}, {180, 0}});
}

}  // namespace
}  // namespace plateau
