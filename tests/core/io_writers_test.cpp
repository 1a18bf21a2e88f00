#include "io/writers.h"

#include <gtest/gtest.h>

#include <boost/property_tree/json_parser.hpp>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "cloud/samples.h"
#include "io/cloud_reader.h"
#include "io/family_name.h"
#include "io/mesh_files.h"
#include "io/step_mesh.h"

namespace plateau {
namespace {

Session finished(PointCloud cloud, const RunOptions& options = {}) {
    auto opened = Session::open(std::move(cloud), options);
    EXPECT_TRUE(opened) << opened.error().message;
    Session session = std::move(opened).value();
    while (session.run({}).state == RunState::Running) {
    }
    return session;
}

Session finished_sample(const char* shape, std::uint32_t size, const RunOptions& options = {}) {
    return finished(sample_shape(shape, {.size = size}).value(), options);
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

/// A PLY file as an independent reader sees it: numbers by the header's counts.
struct PlyFile {
    std::map<std::string, std::size_t> counts;
    std::vector<std::array<double, 3>> vertices;
    std::vector<std::array<std::size_t, 2>> edges;
    std::vector<std::array<std::size_t, 3>> faces;
};

PlyFile read_ply(const std::string& text) {
    PlyFile file;
    std::istringstream stream(text);
    std::string word;
    stream >> word;
    EXPECT_EQ(word, "ply");
    while (stream >> word && word != "end_header") {
        std::string name;
        if (word == "element") stream >> name >> file.counts[name];
    }
    file.vertices.resize(file.counts["vertex"]);
    for (auto& vertex : file.vertices) stream >> vertex[0] >> vertex[1] >> vertex[2];
    file.edges.resize(file.counts["edge"]);
    for (auto& edge : file.edges) stream >> edge[0] >> edge[1];
    file.faces.resize(file.counts["face"]);
    for (auto& face : file.faces) {
        std::size_t corners = 0;
        stream >> corners >> face[0] >> face[1] >> face[2];
        EXPECT_EQ(corners, 3u);
    }
    EXPECT_FALSE(stream.fail());
    EXPECT_FALSE(stream >> word) << "left over: " << word;
    for (const auto& face : file.faces) {
        for (const std::size_t vertex : face) EXPECT_LT(vertex, file.vertices.size());
    }
    for (const auto& edge : file.edges) {
        for (const std::size_t vertex : edge) EXPECT_LT(vertex, file.vertices.size());
    }
    return file;
}

TEST(Writers, CsvHasALineAStep) {
    const Session session = finished_sample("torus", 300);
    const std::vector<std::string> lines = lines_of(betti_csv(session));
    ASSERT_EQ(lines.size(), 301u);
    EXPECT_EQ(lines[0], "step,landmark,epsilon,family,beta0,beta1,beta2");
    const Timeline& timeline = session.timeline();
    for (Step step = 1; step <= 300; ++step) {
        std::istringstream line(lines[step]);
        std::vector<std::string> fields;
        for (std::string field; std::getline(line, field, ',');) fields.push_back(field);
        ASSERT_EQ(fields.size(), 7u);
        EXPECT_EQ(fields[0], std::to_string(step));
        EXPECT_EQ(fields[1], std::to_string(timeline.landmarks[step - 1]));
        EXPECT_EQ(std::strtod(fields[2].c_str(), nullptr), timeline.epsilon(step));  // the same bits
        EXPECT_EQ(fields[3], family_name(timeline.shown_family[step - 1]));
        for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(fields[4 + k], std::to_string(timeline.betti_at(step)[k]));
    }
}

TEST(Writers, CsvOfThePlaneHasTwoBettiNumbers) {
    EXPECT_EQ(lines_of(betti_csv(finished_sample("circle-noise", 50)))[0], "step,landmark,epsilon,family,beta0,beta1");
}

TEST(Writers, JsonIsReadByAnIndependentReader) {
    const Session session = finished_sample("torus", 400);
    std::istringstream text(plateaus_json(session));
    boost::property_tree::ptree root;
    boost::property_tree::read_json(text, root);
    const std::vector<Plateau> plateaus = session.plateaus();
    ASSERT_EQ(root.get_child("plateaus").size(), plateaus.size());
    ASSERT_GT(plateaus.size(), 2u);
    auto plateau = plateaus.begin();
    for (const auto& [key, entry] : root.get_child("plateaus")) {
        EXPECT_EQ(entry.get<Step>("first_step"), plateau->first_step);
        EXPECT_EQ(entry.get<Step>("last_step"), plateau->last_step);
        EXPECT_EQ(entry.get<double>("epsilon_first"), plateau->epsilon_first);
        EXPECT_EQ(entry.get<double>("epsilon_last"), plateau->epsilon_last);
        EXPECT_EQ(entry.get<double>("length"), plateau->length());
        EXPECT_EQ(entry.get<std::string>("family"), family_name(plateau->family));
        std::vector<std::uint32_t> betti;
        for (const auto& number : entry.get_child("betti")) betti.push_back(number.second.get_value<std::uint32_t>());
        EXPECT_EQ(betti, plateau->betti);
        EXPECT_EQ(entry.size(), 7u);
        ++plateau;
    }
}

TEST(Writers, NoInfinityAndNoNanInAnyOutput) {
    // Duplicates end with epsilon = 0; a single point has no positive epsilon at all.
    for (const PointCloud& cloud : {PointCloud{2, {0, 0, 1, 0, 0, 1, 0, 0, 1, 0}}, PointCloud{3, {1, 2, 3}},
                                    PointCloud{2, {5, 5, 5, 5}}, PointCloud{3, {0, 0, 0, 1, 1, 1}}}) {
        const Session session = finished(cloud);
        for (const std::string& text :
             {betti_csv(session), plateaus_json(session), plateau_table(session), mesh_ply(session, std::nullopt)}) {
            EXPECT_FALSE(text.empty());
            EXPECT_EQ(text.find("inf"), std::string::npos) << text;
            EXPECT_EQ(text.find("nan"), std::string::npos) << text;
        }
        std::istringstream json(plateaus_json(session));
        boost::property_tree::ptree root;
        EXPECT_NO_THROW(boost::property_tree::read_json(json, root));
    }
}

TEST(Writers, SurfaceMeshIsClosedOrientedAndOfTheRightGenus) {
    const Session session = finished_sample("torus", 2000);
    const std::vector<Plateau> plateaus = session.plateaus();
    const Plateau& longest = plateaus[ranked(plateaus).front()];
    ASSERT_EQ(longest.betti, (std::vector<std::uint32_t>{1, 2, 1}));
    EXPECT_EQ(default_mesh_step(session), middle_step(session.timeline(), longest));
    const std::string text = mesh_ply(session, std::nullopt);
    EXPECT_EQ(text, mesh_ply(session, middle_step(session.timeline(), longest)));
    const PlyFile file = read_ply(text);
    std::set<std::pair<std::size_t, std::size_t>> directed;
    double volume = 0;
    for (const auto& face : file.faces) {
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_TRUE(directed.emplace(face[k], face[(k + 1) % 3]).second) << "an edge twice in one direction";
        }
        const auto& a = file.vertices[face[0]];
        const auto& b = file.vertices[face[1]];
        const auto& c = file.vertices[face[2]];
        volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                   a[2] * (b[0] * c[1] - b[1] * c[0])) /
                  6;
    }
    for (const auto& [from, to] : directed) EXPECT_TRUE(directed.count({to, from})) << "an open edge";
    const auto euler =
        static_cast<long>(file.vertices.size() + file.faces.size()) - static_cast<long>(directed.size() / 2);
    EXPECT_EQ(euler, 0);
    // Counter-clockwise from outside: the volume 2 pi^2 R r^2 = 3.16 comes out positive.
    EXPECT_GT(volume, 2);
    EXPECT_LT(volume, 3.5);
}

TEST(Writers, MeshOfAComplexHasItsEdgesAndTriangles) {
    const Session session = finished_sample("circle-noise", 200);
    const Timeline& timeline = session.timeline();
    for (const Step step : {1u, 5u, 20u, 200u}) {
        const PlyFile file = read_ply(mesh_ply(session, step));
        ASSERT_EQ(file.vertices.size(), step);
        EXPECT_EQ(file.edges.size(), timeline.living(1, 0, step).size());
        EXPECT_EQ(file.faces.size(), timeline.living(2, 0, step).size());
        for (Step landmark = 1; landmark <= step; ++landmark) {
            const auto point = session.cloud().point(timeline.landmarks[landmark - 1]);
            EXPECT_EQ(file.vertices[landmark - 1][0], point[0]);
            EXPECT_EQ(file.vertices[landmark - 1][1], point[1]);
            EXPECT_EQ(file.vertices[landmark - 1][2], 0);
        }
    }
    EXPECT_GT(read_ply(mesh_ply(session, 20u)).edges.size(), 10u);
}

TEST(Writers, MeshFollowsTheTrackThatIsShown) {
    // Family auto shows C_(1,2,3,4) where there is no surface; C_(1,6,6,4) has more edges at some of those steps.
    const Session session = finished_sample("torus", 500);
    const Timeline& timeline = session.timeline();
    int compared = 0;
    for (Step step = 1; step <= timeline.step_count && compared < 3; ++step) {
        const std::size_t edges = timeline.living(1, 1, step).size();
        if (timeline.shown_family[step - 1] != Family::Delaunay || timeline.living(1, 0, step).size() == edges)
            continue;
        const PlyFile file = read_ply(mesh_ply(session, step));
        EXPECT_EQ(file.vertices.size(), step);
        EXPECT_EQ(file.edges.size(), edges);
        EXPECT_EQ(file.faces.size(), timeline.living(2, 1, step).size());
        ++compared;
    }
    EXPECT_EQ(compared, 3);
}

TEST(Writers, WithoutAStepOutputsAreEmptyButWellFormed) {
    auto opened = Session::open(sample_shape("torus", {.size = 100}).value(), {});
    ASSERT_TRUE(opened);
    const Session session = std::move(opened).value();
    ASSERT_EQ(session.timeline().step_count, 0u);
    EXPECT_EQ(lines_of(betti_csv(session)).size(), 1u);
    EXPECT_EQ(read_ply(mesh_ply(session, std::nullopt)).vertices.size(), 0u);
    std::istringstream json(plateaus_json(session));
    boost::property_tree::ptree root;
    boost::property_tree::read_json(json, root);
    EXPECT_EQ(root.get_child("plateaus").size(), 0u);
    EXPECT_EQ(plateau_table(session), "No plateau: no step has a complex.\n");
}

TEST(Writers, TableIsRankedAlignedAndShort) {
    const Session session = finished_sample("torus", 2000);
    const std::vector<std::string> lines = lines_of(plateau_table(session));
    const std::vector<Plateau> plateaus = session.plateaus();
    ASSERT_GT(plateaus.size(), 20u);
    ASSERT_EQ(lines.size(), 22u);
    EXPECT_EQ(lines[21], "and " + std::to_string(plateaus.size() - 20) + " shorter ones");
    const std::size_t column = lines[0].find("Betti numbers");
    ASSERT_NE(column, std::string::npos);
    double last = 1e9;
    for (std::size_t k = 1; k <= 20; ++k) {
        EXPECT_EQ(lines[k][column], '(') << lines[k];
        const double length = std::strtod(lines[k].c_str(), nullptr);
        EXPECT_LE(length, last);
        last = length;
    }
    EXPECT_EQ(lines[1].substr(column), "(1, 2, 1)");
}

TEST(Writers, CloudTextKeepsEveryBit) {
    for (const char* shape : {"torus", "corner-curve"}) {
        const PointCloud cloud = sample_shape(shape, {.size = 500, .noise = 0.1}).value();
        const std::string text = cloud_xyz(cloud, 0, 200) + cloud_xyz(cloud, 200, 300);
        const auto read = read_cloud(text, "-", {});
        ASSERT_TRUE(read) << read.error().message;
        EXPECT_EQ(read.value().cloud.dimension, cloud.dimension);
        EXPECT_EQ(read.value().cloud.coordinates, cloud.coordinates);
    }
}

/// As lines through its center the points of a sphere are the projective plane.
PointCloud lines() {
    return sample_shape("sphere", {.size = 1500, .seed = 3}).value();
}

TEST(Writers, TorsionIsInTheTableAndInTheJson) {
    RunOptions options;
    options.metric.metric = Metric::Projective;
    options.nu = {1, 4, 5, 5};
    options.max_steps = 60;
    const Session session = finished(lines(), options);
    EXPECT_NE(plateau_table(session).find("(1, 1, 1), torsion: (1, 0, 0) over Z/3\n"), std::string::npos)
        << plateau_table(session);
    boost::property_tree::ptree tree;
    std::istringstream stream(plateaus_json(session));
    boost::property_tree::read_json(stream, tree);
    const std::vector<Plateau> plateaus = session.plateaus();
    std::size_t at = 0, with_torsion = 0;
    for (const auto& [key, plateau] : tree.get_child("plateaus")) {
        const auto torsion = plateau.get_child_optional("torsion");
        ASSERT_EQ(torsion.has_value(), !plateaus[at].torsion.empty());
        if (torsion) {
            ++with_torsion;
            EXPECT_EQ(torsion->get<std::uint32_t>("field"), 3u);
            std::vector<std::uint32_t> betti;
            for (const auto& [index, number] : torsion->get_child("betti")) {
                betti.push_back(number.get_value<std::uint32_t>());
            }
            EXPECT_EQ(betti, plateaus[at].torsion);
        }
        ++at;
    }
    EXPECT_GT(with_torsion, 0u);
    options.field = 5;
    EXPECT_NE(plateau_table(finished(lines(), options)).find("Betti numbers over Z/5\n"), std::string::npos);
}

}  // namespace
}  // namespace plateau
