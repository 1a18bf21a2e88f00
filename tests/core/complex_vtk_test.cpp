// The complex as VTK against the record of the run: every cell with its lifespan, tetrahedra included. The module's
// tests read the same bytes with a reader of their own and hold them against what the page is told.

#include "io/complex_vtk.h"

#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "cloud/samples.h"
#include "clouds.h"

namespace plateau {
namespace {

using Numbers = std::vector<double>;

/// The numbers of a file, by the word before them.
std::map<std::string, Numbers> read_vtk(const std::string& bytes) {
    std::map<std::string, Numbers> found;
    std::size_t at = 0;
    const auto read = [&](const std::string& name, std::size_t count, const std::string& type) {
        const std::size_t size = type == "double" ? 8 : 4;
        EXPECT_LE(at + count * size, bytes.size()) << name;
        for (std::size_t k = 0; k < count && at + size <= bytes.size(); ++k, at += size) {
            const std::string number(bytes.rbegin() + static_cast<std::ptrdiff_t>(bytes.size() - at - size),
                                     bytes.rbegin() + static_cast<std::ptrdiff_t>(bytes.size() - at));
            double value = 0;
            std::int32_t integer = 0;
            if (size == 8) std::memcpy(&value, number.data(), size);
            if (size == 4) std::memcpy(&integer, number.data(), size);
            found[name].push_back(size == 8 ? value : integer);
        }
        EXPECT_EQ(bytes[at++], '\n') << name;
    };
    while (at < bytes.size()) {
        const std::size_t end = bytes.find('\n', at);
        std::istringstream line(bytes.substr(at, end - at));
        at = end + 1;
        std::string word;
        std::string type;
        std::size_t count = 0;
        std::size_t more = 0;
        line >> word;
        if (word == "POINTS" && line >> count >> type) {
            read(word, 3 * count, type);
        } else if (word == "CELLS" && line >> count >> more) {
            read(word, more, "int");
        } else if (word == "CELL_TYPES" && line >> count) {
            read(word, count, "int");
        } else if (line >> count >> more >> type && (type == "int" || type == "double")) {
            read(word, count * more, type);
        }
    }
    return found;
}

void expect_complex(const Session& session, Step step) {
    auto file = read_vtk(complex_vtk(session, step));
    const Timeline& timeline = session.timeline();
    Numbers points, cells, types, dimension, birth, death, input_index;
    for (Step landmark = 1; landmark <= step; ++landmark) {
        const auto point = session.cloud().point(timeline.landmarks[landmark - 1]);
        for (std::size_t axis = 0; axis < 3; ++axis) points.push_back(axis < point.size() ? point[axis] : 0);
        cells.insert(cells.end(), {1.0, landmark - 1.0});
        types.push_back(1);
        dimension.push_back(0);
        birth.push_back(landmark);
        death.push_back(2147483647.0);
        input_index.push_back(timeline.landmarks[landmark - 1]);
    }
    const int track = timeline.shown_track(step);
    const std::vector<double> names = {1, 3, 5, 10};
    for (int dim = 1; dim <= std::min(3, static_cast<int>(timeline.dimension)); ++dim) {
        const SimplexTable& table = timeline.table(dim);
        for (SimplexIndex simplex = 0; simplex < table.size(); ++simplex) {
            const Step end = table.death[static_cast<std::size_t>(track)][simplex];
            if (table.birth(simplex) > step || end <= step) continue;
            cells.push_back(dim + 1);
            for (const Step vertex : table.tuple(simplex)) cells.push_back(vertex - 1.0);
            types.push_back(names[static_cast<std::size_t>(dim)]);
            dimension.push_back(dim);
            birth.push_back(table.birth(simplex));
            death.push_back(end == kNever ? 2147483647.0 : end);
        }
    }
    EXPECT_EQ(file["POINTS"], points);
    EXPECT_EQ(file["CELLS"], cells);
    EXPECT_EQ(file["CELL_TYPES"], types);
    EXPECT_EQ(file["dimension"], dimension);
    EXPECT_EQ(file["birth"], birth);
    EXPECT_EQ(file["death"], death);
    EXPECT_EQ(file["input_index"], input_index);
    EXPECT_EQ(file["step"], Numbers(birth.begin(), birth.begin() + step));
}

TEST(ComplexVtk, HoldsTheComplexOfTheStep) {
    std::size_t tetrahedra = 0;
    for (const char* name :
         {"torus_large", "plane_circle_large", "helix_large", "one_point", "collinear_skew", "grid"}) {
        Session session = Session::open(test_cloud(name).cloud, {}).value();
        session.run({});
        const Step steps = session.timeline().step_count;
        for (Step step = 1; step <= steps; step += steps / 7 + 1) expect_complex(session, step);
        expect_complex(session, steps);
        if (session.timeline().dimension > 2) tetrahedra += session.timeline().living(3, 0, steps).size();
    }
    EXPECT_GT(tetrahedra, 100u);
}

TEST(ComplexVtk, SimplicesOfMoreThanFourVerticesHaveNoCell) {
    RunOptions options;
    options.family = Family::Witness;
    options.max_dimension = 3;
    options.nu = {1, 6, 7, 8, 9};
    Session session = Session::open(sample_shape("sphere", {.size = 60}).value(), options).value();
    session.run({});
    ASSERT_GT(session.timeline().living(4, 0, 30).size(), 0u);
    expect_complex(session, 30);
}

TEST(ComplexVtk, BeforeTheFirstStepItIsEmpty) {
    const Session session = Session::open(sample_shape("torus", {.size = 60}).value(), {}).value();
    auto file = read_vtk(complex_vtk(session, std::nullopt));
    EXPECT_TRUE(file["POINTS"].empty());
    EXPECT_TRUE(file["CELLS"].empty());
}

}  // namespace
}  // namespace plateau
