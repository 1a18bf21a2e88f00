// A step at which the surface comes apart, or appears, is done in parts: no part has more than some units of work.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

#include "base/random.h"
#include "cloud/samples.h"
#include "dilated/dilated_complex.h"
#include "dilated/witness_search.h"
#include "homology/general_betti.h"
#include "session/session.h"
#include "surface/outer_region.h"

namespace plateau {
namespace {

PointCloud shape(const std::string& name, std::uint32_t size) {
    return sample_shape(name, {.size = size}).value();
}

Session open(const PointCloud& cloud, Step steps) {
    RunOptions options;
    options.max_steps = steps;
    return Session::open(cloud, options).value();
}

std::size_t rows_begun(const Timeline& timeline, Step step) {
    return timeline.first_row_of_step[step + 1] - timeline.first_row_of_step[step];
}

std::size_t rows_ended(const Timeline& timeline, Step step) {
    return timeline.first_ended_row_of_step[step + 1] - timeline.first_ended_row_of_step[step];
}

// This surface comes apart, comes back as a whole, and comes apart again.
TEST(LongStep, NoCallOfASessionChangesMoreThanSomeRows) {
    constexpr Step kSteps = 2200;
    const PointCloud cloud = shape("torus", 8000);
    Session whole = open(cloud, kSteps);
    whole.run({});
    std::size_t most_begun = 0;
    std::size_t most_ended = 0;
    for (Step step = 1; step <= kSteps; ++step) {
        most_begun = std::max(most_begun, rows_begun(whole.timeline(), step));
        most_ended = std::max(most_ended, rows_ended(whole.timeline(), step));
    }
    EXPECT_GT(most_begun, 4000u) << "else the cloud does not ask what it is here to ask";
    EXPECT_GT(most_ended, 4000u) << "else the cloud does not ask what it is here to ask";

    Session cut = open(cloud, kSteps);
    const auto rows_changed = [&] { return cut.timeline().surface.size() + cut.timeline().ended_rows.size(); };
    Progress progress = cut.progress();
    std::uint64_t hash = 0;
    while (progress.state == RunState::Preparing || progress.state == RunState::Running) {
        const std::size_t rows = rows_changed();
        const Step steps = progress.steps_done;
        progress = cut.run({.milliseconds = 0});
        ASSERT_LE(progress.steps_done, steps + 1);
        // A triangle has two sides.
        ASSERT_LE(rows_changed() - rows, 2 * Slice::kUnits) << "in step " << steps + 1;
        if (progress.steps_done == steps && steps > 0) {
            ASSERT_EQ(cut.hash(), hash) << "what is not complete shows, in step " << steps + 1;
        }
        hash = cut.hash();
    }
    EXPECT_EQ(progress.steps_done, kSteps);
    EXPECT_EQ(cut.hash(), whole.hash());
}

TEST(LongStep, AStepIsWhatIsCountedAlsoWhereItIsCut) {
    Session session = open(shape("sphere", 4000), 1200);
    session.run({.steps = 1});
    while (session.progress().steps_done < 1200) {
        const Step steps = session.progress().steps_done;
        // It may lie between two parts of the long step.
        session.run({.milliseconds = 0, .steps = 1});
        if (session.progress().steps_done == steps) session.run({.steps = 1});
        ASSERT_EQ(session.progress().steps_done, steps + 1);
    }
    EXPECT_EQ(session.progress().state, RunState::Finished);
}

/// So many searches for witnesses fit into one part of a step.
constexpr std::size_t kSearches = Slice::kUnits / WitnessSearch::kUnits;

// A landmark on a sphere of three dimensions has many simplices, and pumping asks each where it enters and leaves.
TEST(LongStep, PumpingAndTheDilatedComplexAreCut) {
    constexpr Step kSteps = 60;
    const PointCloud cloud = shape("s3", 3000);
    RunOptions options;
    options.max_steps = kSteps;
    options.dilated.pumps = true;
    Session whole = Session::open(cloud, options).value();
    whole.run({});
    ASSERT_EQ(whole.timeline().family, Family::Dilated);

    Session cut = Session::open(cloud, options).value();
    const auto births = [&] {
        std::size_t count = 0;
        for (const SimplexTable& table : cut.timeline().simplices) count += table.size();
        return count;
    };
    Progress progress = cut.progress();
    std::uint64_t hash = 0;
    std::uint32_t calls = 0;
    std::uint32_t most_calls = 0;
    std::size_t most_births = 0;
    std::size_t born = 0;
    while (progress.state == RunState::Preparing || progress.state == RunState::Running) {
        const std::size_t before = births();
        const Step steps = progress.steps_done;
        progress = cut.run({.milliseconds = 0});
        ++calls;
        ASSERT_LE(births() - before, kSearches) << "in step " << steps + 1;
        born += births() - before;
        if (progress.steps_done == steps) {
            if (steps > 0) {
                ASSERT_EQ(cut.hash(), hash) << "what is not complete shows, in step " << steps + 1;
            }
        } else {
            const std::uint32_t thresholds = cut.timeline().pumps.back().thresholds;
            // Where a simplex enters or leaves is found by 11 searches.
            ASSERT_GE(calls * kSearches, 11 * thresholds) << "step " << progress.steps_done;
            most_calls = std::max(most_calls, calls);
            most_births = std::max(most_births, born);
            calls = 0;
            born = 0;
        }
        hash = cut.hash();
    }
    EXPECT_EQ(progress.steps_done, kSteps);
    EXPECT_EQ(cut.hash(), whole.hash());
    EXPECT_GT(most_calls, 20u) << "else the cloud does not ask what it is here to ask";
    EXPECT_GT(most_births, 3 * kSearches) << "else the cloud does not ask what it is here to ask";
    ASSERT_EQ(cut.timeline().pumps.size(), whole.timeline().pumps.size());
    for (std::size_t i = 0; i < kSteps; ++i) {
        const Pump& a = cut.timeline().pumps[i];
        const Pump& b = whole.timeline().pumps[i];
        ASSERT_EQ(a.before, b.before);
        ASSERT_EQ(a.after, b.after);
        ASSERT_EQ(a.thresholds, b.thresholds);
        ASSERT_EQ(a.amplitude, b.amplitude);
    }
}

// In R^5 a landmark far from what bounds its cycles has thousands of simplices looked at, over two fields.
TEST(LongStep, CountingCyclesIsCut) {
    constexpr Step kSteps = 60;
    constexpr int kDimension = 5;
    Random random(17);
    PointCloud cloud{kDimension, {}};
    for (int i = 0; i < 2000 * kDimension; ++i) cloud.coordinates.push_back(random.next_unit());
    LandmarkLists lists(cloud, kDimension + 1);
    ASSERT_TRUE(lists.prepare(Deadline::never()));
    DilatedComplex complex(kDimension, {.dilation = 1, .pumps = false, .pump = {}});
    std::vector<SimplexTable> tables(kDimension);
    for (int k = 1; k <= kDimension; ++k) tables[static_cast<std::size_t>(k - 1)].dimension = k;
    constexpr std::array<std::uint32_t, 2> kPrimes = {2, 3};
    GeneralBetti whole(kDimension, kPrimes);
    GeneralBetti cut(kDimension, kPrimes);
    const Deadline passed(0);
    const Deadline never = Deadline::never();
    std::size_t most_parts = 0;
    for (Step step = 1; step <= kSteps; ++step) {
        const std::uint32_t next = step == 1 ? 0 : lists.farthest();
        lists.insert(next, step);
        const double epsilon = lists.distance(lists.farthest_comparable());
        Slice slice(never);
        ASSERT_TRUE(complex.insert(step, lists.witness(next), epsilon, lists, tables, slice));
        ASSERT_TRUE(whole.update(step, tables, complex.books(), complex.deaths(), complex.hidden(), slice));
        std::size_t parts = 0;
        for (bool done = false; !done; ++parts) {
            Slice part(passed);
            done = cut.update(step, tables, complex.books(), complex.deaths(), complex.hidden(), part);
        }
        for (std::size_t field = 0; field < kPrimes.size(); ++field) {
            ASSERT_EQ(cut.numbers(field), whole.numbers(field)) << "step " << step;
        }
        most_parts = std::max(most_parts, parts);
    }
    EXPECT_GT(most_parts, 1500u) << "columns are reduced by more than fits into a part";
}

// What does not show in the rows: a triangle that leaves K asks for each of its edges, one that comes back has its
// certificate checked, and a cell that opens is flooded.
TEST(LongStep, PeelingAndFloodingAreCut) {
    const PointCloud cloud = shape("torus", 8000);
    LandmarkLists lists(cloud, 6);
    ASSERT_TRUE(lists.prepare(Deadline::never()));
    Delaunay delaunay(3);
    NuComplex complex({{1, 6, 6, 4}}, 3, cloud.size());
    std::vector<SimplexTable> tables(3);
    for (int k = 1; k <= 3; ++k) tables[static_cast<std::size_t>(k - 1)].dimension = k;
    Peeling peeling(0);
    OuterRegion region;
    std::vector<std::uint32_t> landmarks;
    const LandmarkPoints points{&cloud, &landmarks};
    const Deadline passed(0);
    bool started = false;
    std::size_t most_left = 0;
    std::size_t most_entered = 0;
    std::size_t most_flipped = 0;
    for (Step step = 1; step <= 2200; ++step) {
        const std::uint32_t next = step == 1 ? 0 : lists.farthest();
        const std::uint32_t hint = lists.list(lists.witness(next))[0];
        const DelaunayChange& change = *delaunay.insert(step, cloud.point(next), hint).value();
        landmarks.push_back(next);
        complex.insert(step, lists, lists.insert(next, step), delaunay, change, tables);
        if (change.dimension < 3) continue;
        std::size_t parts = 0;
        const auto in_parts = [&](const auto& update) {
            for (parts = 1;; ++parts) {
                Slice slice(passed);
                if (update(slice)) return;
            }
        };
        in_parts([&](Slice& slice) {
            return peeling.update(step, tables, complex, complex.deaths(), points, !started, slice);
        });
        ASSERT_GE(parts * Slice::kUnits, 3 * peeling.left().size()) << "step " << step;
        const std::size_t born = tables[1].size() - tables[1].first_of_step[step];
        ASSERT_GE(parts * Slice::kUnits + born, peeling.entered().size()) << "step " << step;
        in_parts([&](Slice& slice) {
            return region.update(step, delaunay, change, complex.faces(), peeling, !started, slice);
        });
        const auto opened = std::count_if(region.flipped().begin(), region.flipped().end(),
                                          [&](CellId cell) { return region.outer(cell); });
        ASSERT_GE(parts * Slice::kUnits, static_cast<std::size_t>(opened)) << "step " << step;
        started = true;
        most_left = std::max(most_left, peeling.left().size());
        most_entered = std::max(most_entered, peeling.entered().size());
        most_flipped = std::max(most_flipped, static_cast<std::size_t>(opened));
    }
    EXPECT_GT(most_left, 5000u) << "else the cloud does not ask what it is here to ask";
    EXPECT_GT(most_entered, 5000u) << "else the cloud does not ask what it is here to ask";
    EXPECT_GT(most_flipped, 3000u) << "else the cloud does not ask what it is here to ask";
}

}  // namespace
}  // namespace plateau
