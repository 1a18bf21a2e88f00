// Why a simplex is there, or why not, against the definition: random questions about every cloud, family and step.

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "base/hash.h"
#include "base/random.h"
#include "clouds.h"
#include "comparison.h"
#include "inspection_comparison.h"
#include "reference/metrics.h"
#include "session/session.h"

namespace plateau {
namespace {

using reference::Complex;
using reference::Reference;
using reference::Settings;
using reference::ShownFamily;
using reference::Simplex;
using reference::StepState;

constexpr int kQuestions = 14;

int below(Random& random, int bound) {
    return static_cast<int>(random.next_bits() % static_cast<std::uint64_t>(bound));
}

/// One to five different landmarks: near to each other in a list, so that they may span a simplex, or any ones.
Simplex question(Random& random, const std::vector<std::vector<int>>& lists, int last) {
    const int size = 1 + below(random, 5);
    const std::vector<int>& list = lists[static_cast<std::size_t>(below(random, static_cast<int>(lists.size())))];
    const bool is_near = below(random, 4) > 0;
    const int reach = std::min(static_cast<int>(list.size()), size + 1 + below(random, 4));
    std::set<int> chosen;
    for (int tries = 0; tries < 40 && static_cast<int>(chosen.size()) < size; ++tries) {
        chosen.insert(is_near ? list[static_cast<std::size_t>(below(random, reach))] : 1 + below(random, last));
    }
    return {chosen.begin(), chosen.end()};
}

std::vector<Step> as_steps(Simplex simplex, bool reversed) {
    if (reversed) std::reverse(simplex.begin(), simplex.end());
    return {simplex.begin(), simplex.end()};
}

std::vector<reference::LabeledPoint> labeled(const PointCloud& cloud, const std::vector<int>& landmarks, int step) {
    std::vector<reference::LabeledPoint> points;
    for (int s = 1; s <= step; ++s) {
        const auto place = cloud.point(static_cast<std::uint32_t>(landmarks[static_cast<std::size_t>(s - 1)]));
        points.push_back({{place[0], place[1], place.size() > 2 ? place[2] : 0}, s});
    }
    return points;
}

bool has(const Complex& complex, const Simplex& simplex) {
    return complex[simplex.size() - 1].count(simplex) > 0;
}

class InspectionReference : public testing::TestWithParam<FamilyCase> {};

SurfacePlace place_by_definition(const Complex& complex, const StepState& state, const Settings& settings,
                                 const reference::ExactPoints& points, const Simplex& simplex) {
    if (state.shown != ShownFamily::Surface) return SurfacePlace::NoSurface;
    if (simplex.size() > 3) return SurfacePlace::Solid;
    const auto is_of = [&](const Simplex& triangle) {
        return std::includes(triangle.begin(), triangle.end(), simplex.begin(), simplex.end());
    };
    for (const reference::Row& row : state.surface.rows) {
        if (is_of(row.triangle)) return SurfacePlace::On;
    }
    const auto kept = reference::without_sharp_edges(complex[2], points, settings.rho);
    if (std::any_of(kept.begin(), kept.end(), is_of)) return SurfacePlace::Inside;
    std::vector<Simplex> around;
    std::copy_if(complex[2].begin(), complex[2].end(), std::back_inserter(around), is_of);
    if (around.empty()) return SurfacePlace::Bare;
    const bool all_too_long = settings.rho > 0 && std::all_of(around.begin(), around.end(), [&](const Simplex& one) {
                                  return reference::radius_edge_ratio_exceeds(points, one, settings.rho);
                              });
    return all_too_long ? SurfacePlace::TooLong : SurfacePlace::Peeled;
}

std::string lifespan_difference(Reference& expected, const Settings& settings, std::size_t track,
                                const Inspection& found) {
    if (found.verdict == Verdict::NotInserted) return "";
    const Simplex simplex(found.simplex.begin(), found.simplex.end());
    const auto lives = [&](int step) { return has(expected.state(settings, step).tracks[track], simplex); };
    const int youngest = simplex.back();
    if (found.birth == 0) {
        if (found.verdict == Verdict::Present) return "it is present and was never born";
        return simplex.size() <= 4 && lives(youngest) ? "it was born" : "";
    }
    if (static_cast<int>(found.birth) != youngest || !lives(youngest)) return "wrong birth";
    if (found.death == kNever) return lives(expected.step_count()) ? "" : "it dies";
    if (!lives(static_cast<int>(found.death) - 1) || lives(static_cast<int>(found.death))) return "wrong death";
    return "";
}

TEST_P(InspectionReference, AnswersByTheDefinition) {
    const auto& [cloud, family] = GetParam();
    const int dimension = static_cast<int>(cloud.cloud.dimension);
    Reference expected(cloud.cloud, 0, cloud.max_steps);
    // Each cloud and family has its own questions.
    Fnv1a64 seed;
    for (const char letter : cloud.name) seed.add_byte(static_cast<std::uint8_t>(letter));
    seed.add_u32(static_cast<std::uint32_t>(family));
    Random random(seed.value());
    Settings settings{family, reference::default_nu(family, dimension)};
    if (below(random, 2) == 0) {
        settings.nu = {1, 2 + below(random, 4), 3 + below(random, 4)};
        if (dimension == 3) settings.nu.push_back(4);
    }
    if (family == ShownFamily::Surface && below(random, 2) == 0) settings.rho = 0.7;
    RunOptions options;
    options.family = family_of(family);
    options.nu.assign(settings.nu.begin(), settings.nu.end());
    options.rho = settings.rho;
    options.max_steps = static_cast<std::uint32_t>(cloud.max_steps);
    Session session = Session::open(cloud.cloud, options).value();
    session.run({});
    const std::uint64_t hash = session.hash();
    const int last = expected.step_count();
    for (int i = 0; i < kQuestions; ++i) {
        const int step = i % 4 == 0 ? last : 1 + below(random, last);
        const bool asks_ahead = below(random, 12) == 0;
        const Simplex asked = question(random, expected.lists(asks_ahead ? last : step), asks_ahead ? last : step);
        const auto found = session.inspect(static_cast<Step>(step), as_steps(asked, i % 2 == 0));
        ASSERT_TRUE(found) << found.error().message;
        const StepState state = expected.state(settings, step);
        const std::size_t track = family == ShownFamily::Auto && state.shown == ShownFamily::Delaunay ? 1 : 0;
        DefinedComplex defined{expected.lists(step), state.tracks[track], settings.nu, dimension, step, {}, {}};
        if (track == 1) defined.nu = {1, 2, 3, 4};
        if (family != ShownFamily::Witness) {
            defined.triangulation = expected.triangulation(step);
            defined.points = labeled(cloud.cloud, expected.order().landmarks, step);
        }
        SCOPED_TRACE("step " + std::to_string(step) + ", nu " + joined(defined.nu));
        ASSERT_EQ(inspection_difference(defined, asked, found.value()), "");
        ASSERT_EQ(lifespan_difference(expected, settings, track, found.value()), "") << joined(asked);
        const SurfacePlace place =
            found.value().verdict == Verdict::Present
                ? place_by_definition(state.tracks[track], state, settings, expected.points(), asked)
                : SurfacePlace::NoSurface;
        ASSERT_EQ(static_cast<int>(found.value().surface), static_cast<int>(place)) << joined(asked);
    }
    EXPECT_EQ(session.hash(), hash);
}

INSTANTIATE_TEST_SUITE_P(Clouds, InspectionReference, testing::ValuesIn(family_cases()),
                         [](const auto& instance) { return name_of(instance.param); });

TEST(InspectionReferenceSize, AsksAThousandQuestions) {
    EXPECT_GE(family_cases().size() * kQuestions, 1000u);
}

// Every place with respect to the surface is met: of all simplices at some steps of clouds that have them.
TEST(InspectionSurface, TellsEveryPlaceAsTheDefinition) {
    std::set<SurfacePlace> met;
    for (const char* name :
         {"torus", "nested_octahedra", "shells_large", "grid", "two_spheres", "torus_with_disk_dense"}) {
        const TestCloud cloud = test_cloud(name);
        for (const double rho : {0.0, 0.65}) {
            const Settings settings{ShownFamily::Surface, {1, 6, 6, 4}, rho};
            Reference expected(cloud.cloud, 0, std::min(cloud.max_steps, 60));
            RunOptions options;
            options.family = Family::Surface;
            options.rho = rho;
            options.max_steps = static_cast<std::uint32_t>(expected.step_count());
            Session session = Session::open(cloud.cloud, options).value();
            session.run({});
            const int step = expected.step_count();
            const StepState state = expected.state(settings, step);
            for (const auto& simplices : state.tracks[0]) {
                const std::size_t stride = simplices.size() / 24 + 1;
                std::size_t place_in_set = 0;
                for (const Simplex& simplex : simplices) {
                    if (place_in_set++ % stride != 0) continue;
                    const auto found = session.inspect(static_cast<Step>(step), as_steps(simplex, false)).value();
                    const auto place =
                        place_by_definition(state.tracks[0], state, settings, expected.points(), simplex);
                    ASSERT_EQ(static_cast<int>(found.surface), static_cast<int>(place)) << name << joined(simplex);
                    met.insert(place);
                }
            }
        }
    }
    EXPECT_EQ(met, (std::set{SurfacePlace::On, SurfacePlace::Inside, SurfacePlace::Peeled, SurfacePlace::TooLong,
                             SurfacePlace::Bare, SurfacePlace::Solid}));
}

}  // namespace
}  // namespace plateau
