// Betti numbers of complexes that are not embedded, against GUDHI's cohomology of each step's complex; and the rank of
// columns that come and go, against dense elimination.

#include <gtest/gtest.h>

#include <ostream>

#include "base/random.h"
#include "cloud/samples.h"
#include "homology/echelon.h"
#include "reference/cohomology.h"
#include "session/session.h"

namespace plateau {
namespace {

using Columns = std::vector<std::vector<std::uint32_t>>;  // dense

std::uint32_t dense_rank(Columns columns, std::uint64_t prime) {
    std::uint32_t rank = 0;
    const std::size_t rows = columns.empty() ? 0 : columns.front().size();
    for (std::size_t row = 0; row < rows; ++row) {
        std::size_t pivot = rank;
        while (pivot < columns.size() && columns[pivot][row] == 0) ++pivot;
        if (pivot == columns.size()) continue;
        std::swap(columns[rank], columns[pivot]);
        for (std::size_t other = rank + 1; other < columns.size(); ++other) {
            const std::uint64_t a = columns[rank][row];
            const std::uint64_t b = columns[other][row];
            for (std::size_t i = 0; i < rows; ++i) {
                columns[other][i] = static_cast<std::uint32_t>(
                    (columns[other][i] * a + prime * prime - columns[rank][i] * b % prime) % prime);
            }
        }
        ++rank;
    }
    return rank;
}

TEST(Echelon, HasTheRankOfDenseElimination) {
    Random random(11);
    for (const std::uint32_t prime : {2u, 3u, 7u, 46337u}) {
        for (int round = 0; round < 40; ++round) {
            const std::uint32_t rows = 4 + static_cast<std::uint32_t>(random.next_unit() * 12);
            Echelon echelon(prime);
            echelon.reset(rows);
            Columns kept;
            std::vector<std::pair<std::uint32_t, std::size_t>> marks;  // rank and columns at that time
            for (int i = 0; i < 30; ++i) {
                if (!marks.empty() && random.next_unit() < 0.1) {
                    echelon.shrink_to(marks.back().first);
                    kept.resize(marks.back().second);
                    marks.pop_back();
                }
                if (random.next_unit() < 0.1) marks.emplace_back(echelon.rank(), kept.size());
                Echelon::Column column;
                std::vector<std::uint32_t> dense(rows, 0);
                for (std::uint32_t row = 0; row < rows; ++row) {
                    if (random.next_unit() < 0.7) continue;
                    dense[row] = 1 + static_cast<std::uint32_t>(random.next_unit() * (prime - 1));
                    column.push_back({row, dense[row]});
                }
                const std::uint32_t before = dense_rank(kept, prime);
                kept.push_back(dense);
                const std::uint32_t after = dense_rank(kept, prime);
                EXPECT_EQ(echelon.insert(column) != Echelon::kNoRow, after > before);
                ASSERT_EQ(echelon.rank(), after);
            }
        }
    }
}

struct Followed {
    const char* name;
    const char* shape;
    std::uint32_t size;
    Step steps;
    std::vector<std::uint32_t> nu;
    std::uint32_t field;
    Step every;
};

void PrintTo(const Followed& followed, std::ostream* out) {
    *out << followed.name;
}

class GeneralBettiReference : public testing::TestWithParam<Followed> {};

TEST_P(GeneralBettiReference, EqualsCohomologyOfEachStep) {
    const Followed& followed = GetParam();
    const PointCloud cloud = sample_shape(followed.shape, {.size = followed.size, .seed = 5}).value();
    RunOptions options;
    options.family = Family::Witness;
    options.nu = followed.nu;
    options.field = followed.field;
    options.max_steps = followed.steps;
    auto session = Session::open(cloud, options);
    session.value().run({});
    const Timeline& timeline = session.value().timeline();
    ASSERT_EQ(timeline.step_count, followed.steps);
    for (Step step = 1; step <= followed.steps; step += followed.every) {
        std::vector<std::vector<int>> simplices;
        for (const SimplexTable& table : timeline.simplices) {
            for (SimplexIndex simplex = 0; simplex < table.size(); ++simplex) {
                if (!table.lives(simplex, 0, step)) continue;
                auto& vertices = simplices.emplace_back();
                for (const Step vertex : table.tuple(simplex)) vertices.push_back(static_cast<int>(vertex) - 1);
            }
        }
        const auto by_cohomology = [&](std::uint32_t field) {
            return reference::betti_by_cohomology(static_cast<int>(step), simplices, timeline.dimension,
                                                  static_cast<int>(field));
        };
        const auto betti = timeline.betti_at(step);
        ASSERT_EQ(std::vector<std::uint32_t>(betti.begin(), betti.end()), by_cohomology(followed.field))
            << "step " << step;
        const auto others = std::span(timeline.other_betti).subspan((step - 1) * timeline.dimension, betti.size());
        ASSERT_EQ(std::vector<std::uint32_t>(others.begin(), others.end()), by_cohomology(timeline.other_field))
            << "step " << step;
    }
}

// With many witnesses a landmark the surfaces are closed but for a few holes: what decides lies far from the landmark.
INSTANTIATE_TEST_SUITE_P(, GeneralBettiReference,
                         testing::Values(Followed{"sphere_nearly_closed", "sphere", 20000, 300, {}, 2, 1},
                                         Followed{"torus_nearly_closed", "torus", 20000, 300, {}, 3, 1},
                                         Followed{"torus_to_its_end", "torus", 1500, 1500, {}, 2, 37},
                                         Followed{"torus_thick", "torus", 1200, 150, {1, 6, 6, 4}, 2, 1},
                                         Followed{"double_torus_thick", "double-torus", 1500, 200, {1, 4, 5, 4}, 5, 1},
                                         Followed{"swiss_roll_with_rims", "swiss-roll", 6000, 300, {1, 4, 5}, 2, 1},
                                         Followed{
                                             "circles_in_the_plane", "nested-circles", 900, 900, {1, 3, 4}, 2, 11}),
                         [](const auto& followed) { return followed.param.name; });

}  // namespace
}  // namespace plateau
