// What the command writes beside tables and meshes, and the sessions that it opens again.

#include <gtest/gtest.h>

#include <boost/property_tree/json_parser.hpp>
#include <chrono>
#include <csignal>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "command.h"
#include "io/cloud_reader.h"
#include "io/complex_vtk.h"
#include "io/mesh_files.h"
#include "io/report_json.h"

namespace plateau {
namespace {

class Exports : public Command {
protected:
    static Session finished(const PointCloud& cloud, const RunOptions& options = {}) {
        Session session = Session::open(cloud, options).value();
        session.run({});
        return session;
    }

    std::string hash_of(const std::vector<std::string>& words) const {
        std::vector<std::string> arguments = {"run"};
        arguments.insert(arguments.end(), words.begin(), words.end());
        arguments.insert(arguments.end(), {"--hash", "--betti", "/dev/null"});
        const Outcome outcome = plateau(arguments);
        EXPECT_EQ(outcome.code, 0) << outcome.error;
        EXPECT_EQ(outcome.error, "");
        return outcome.output;
    }
};

TEST_F(Exports, FilesAreThoseOfTheWriters) {
    const std::string file = sample_file("torus", 400);
    const Session session = finished(sample_shape("torus", {.size = 400}).value());
    const Outcome outcome =
        plateau({"run", file, "--mesh", path("m.off"), "--complex", path("c.vtk"), "--report", path("r.json")});
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_EQ(outcome.output, "");
    EXPECT_EQ(contents(path("m.off")), mesh_off(session, std::nullopt));
    EXPECT_EQ(contents(path("c.vtk")), complex_vtk(session, std::nullopt));
    EXPECT_EQ(contents(path("r.json")), surface_report_json(session, std::nullopt));
    EXPECT_EQ(plateau({"run", file, "--mesh", path("m.GLB"), "--at", "80"}).code, 0);
    EXPECT_EQ(contents(path("m.GLB")), mesh_glb(session, 80u));
    EXPECT_EQ(plateau({"run", file, "--complex", "-", "--at", "80"}).output, complex_vtk(session, 80u));
    const std::string report = plateau({"run", file, "--report", "-", "--at", "80"}).output;
    EXPECT_EQ(report, surface_report_json(session, 80u));

    std::istringstream text(report);
    boost::property_tree::ptree root;
    boost::property_tree::read_json(text, root);
    EXPECT_EQ(root.get<int>("step"), 80);
    EXPECT_EQ(root.get<int>("components"), 1);
    EXPECT_EQ(root.get<int>("genus"), 1);
    EXPECT_EQ(root.get_child("parts").size(), 1u);
    EXPECT_GT(root.get<double>("volume"), 0);
}

TEST_F(Exports, NumbersTooLargeForDoubleAreNull) {
    PointCloud cloud = sample_shape("torus", {.size = 200}).value();
    for (double& coordinate : cloud.coordinates) coordinate *= 5e149;
    RunOptions options;
    options.max_steps = 60;
    const Session session = finished(cloud, options);
    std::istringstream text(surface_report_json(session, 60u));
    boost::property_tree::ptree root;
    boost::property_tree::read_json(text, root);
    EXPECT_EQ(root.get<int>("components"), 1);
    EXPECT_GT(root.get<double>("area"), 1e300);
    EXPECT_EQ(root.get<std::string>("volume"), "null");
}

TEST_F(Exports, WhatIsNotThereIsRefusedBeforeTheRun) {
    const std::string file = sample_file("torus", 100);
    EXPECT_TRUE(contains(refused({"run", file, "--mesh", path("m.stl")}), ".ply, .off and .glb"));
    EXPECT_TRUE(contains(refused({"run", file, "--at", "5"}), "--session"));
    EXPECT_TRUE(contains(refused({"run", file, "--at", "5", "--betti", "-"}), "--report"));
    EXPECT_TRUE(contains(refused({"run", file, "--report", "-", "--family", "delaunay"}), "family delaunay"));
    EXPECT_TRUE(contains(refused({"run", "-", "--report", "-"}, "0 0\n1 0\n0 1\n"), "auto or surface"));
    EXPECT_TRUE(contains(refused({"run", file, "--complex", "-", "--at", "101"}), "100 steps"));
    refused({"run", file, "--complex", "-", "--session", "-"});
    refused({"run", file, "--session", path("no/such/folder.plateau")});
    EXPECT_TRUE(contains(refused({"run", "-"}, "plateau session 1\npoints 1 2 double\ndata\n"), "promises 2 numbers"));
}

TEST_F(Exports, ASessionIsTheSameRun) {
    const std::string file = sample_file("torus", 300);
    const std::string session = path("s.plateau");
    const std::vector<std::string> words = {"--family", "delaunay", "--nu",    "1,2,3,4",
                                            "--first",  "9",        "--steps", "120"};
    std::vector<std::string> saving = {file, "--session", session, "--at", "30"};
    saving.insert(saving.end(), words.begin(), words.end());
    const std::string hash = hash_of(saving);
    EXPECT_EQ(hash_of({session}), hash);
    EXPECT_EQ(plateau({"run", "-", "--hash", "--betti", "/dev/null"}, contents(session)).output, hash);
    // What the command line names counts; the rest is that of the file.
    EXPECT_EQ(hash_of({session, "--steps", "70"}),
              hash_of({file, "--family", "delaunay", "--nu", "1,2,3,4", "--first", "9", "--steps", "70"}));
    EXPECT_EQ(hash_of({session, "--first", "0"}),
              hash_of({file, "--family", "delaunay", "--nu", "1,2,3,4", "--steps", "120"}));
    EXPECT_EQ(hash_of({session, "--nu", "1,3,4,5"}),
              hash_of({file, "--family", "delaunay", "--nu", "1,3,4,5", "--first", "9", "--steps", "120"}));
    // With the family goes its nu.
    EXPECT_EQ(hash_of({session, "--family", "witness"}),
              hash_of({file, "--family", "witness", "--first", "9", "--steps", "120"}));
    EXPECT_EQ(hash_of({session, "--metric", "l1"}),
              hash_of({file, "--metric", "l1", "--first", "9", "--steps", "120"}));
    // It can be saved again, whole and at another step.
    EXPECT_EQ(hash_of({session, "--session", path("again.plateau")}), hash);
    EXPECT_EQ(contents(path("again.plateau")), contents(session));
    hash_of({session, "--session", path("other.plateau"), "--at", "31"});
    EXPECT_EQ(read_cloud(contents(path("other.plateau")), "", {}).value().saved->shown, 31u);
}

TEST_F(Exports, ASessionOfWitnessesKeepsItsMetric) {
    const std::string file = sample_file("sphere", 120);
    const std::string session = path("s.plateau");
    const std::string hash = hash_of({file, "--metric", "periodic", "--box", "2,2.5,0", "--max-dim", "1", "--field",
                                      "3", "--until", "0.5", "--session", session});
    EXPECT_EQ(hash_of({session}), hash);
    EXPECT_EQ(hash_of({session, "--until", "0.7"}), hash_of({file, "--metric", "periodic", "--box", "2,2.5,0",
                                                             "--max-dim", "1", "--field", "3", "--until", "0.7"}));
    EXPECT_EQ(hash_of({session, "--max-dim", "2"}), hash_of({file, "--metric", "periodic", "--box", "2,2.5,0",
                                                             "--max-dim", "2", "--field", "3", "--until", "0.5"}));
    EXPECT_EQ(hash_of({session, "--metric", "geodesic", "--knn", "6"}),
              hash_of({file, "--metric", "geodesic", "--knn", "6", "--field", "3", "--until", "0.5"}));
    const std::string matrix = written("m.csv", "0,1,2,3\n1,0,2,2\n2,2,0,1\n3,2,1,0\n");
    const std::string distances = hash_of({matrix, "--metric", "matrix", "--session", session});
    EXPECT_EQ(hash_of({session}), distances);
    EXPECT_EQ(hash_of({session, "--metric", "matrix"}), distances);
    EXPECT_TRUE(contains(refused({"run", session, "--metric", "l1"}), "matrix"));
}

TEST_F(Exports, ASessionOfDilatedWitnessesKeepsTheirRadius) {
    const std::string file = sample_file("sphere", 200);
    const std::string session = path("s.plateau");
    const std::string hash =
        hash_of({file, "--family", "dilated", "--dilation", "0.4", "--steps", "60", "--session", session});
    EXPECT_NE(hash, hash_of({file, "--family", "dilated", "--steps", "60"}));
    EXPECT_EQ(hash_of({session}), hash);
    EXPECT_EQ(hash_of({session, "--dilation", "0.3"}),
              hash_of({file, "--family", "dilated", "--dilation", "0.3", "--steps", "60"}));
}

TEST_F(Exports, ARunThatIsNotTheSavedOneIsTold) {
    const std::string file = sample_file("torus", 200);
    const std::string session = path("s.plateau");
    hash_of({file, "--session", session});
    std::string bytes = contents(session);
    bytes[bytes.size() - 3] ^= 1;
    const std::string changed = written("changed.plateau", bytes);
    const Outcome outcome = plateau({"run", changed, "--betti", "/dev/null"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_TRUE(contains(outcome.error, "not the run that was saved: its first 200 steps")) << outcome.error;
    // Other options make another run, as the user wanted; a shorter one has not come as far.
    EXPECT_EQ(plateau({"run", changed, "--family", "delaunay", "--betti", "/dev/null"}).error, "");
    EXPECT_EQ(plateau({"run", changed, "--steps", "150", "--betti", "/dev/null"}).error, "");
}

TEST_F(Exports, CtrlCSavesASessionThatGoesOn) {
    written("stdin", "");
    const std::string file = sample_file("torus", 60'000);
    const std::string session = path("s.plateau");
    const pid_t child =
        started({"run", file, "--session", session, "--mesh", path("m.ply"), "--at", "60000", "--progress"});
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (!contains(contents(path("stderr")), "step ") && std::chrono::steady_clock::now() < deadline) {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    ASSERT_EQ(kill(child, SIGINT), 0);
    EXPECT_EQ(ended(child).code, 130);
    const auto read = read_cloud(contents(session), "s.plateau", {});
    ASSERT_TRUE(read) << read.error().message;
    const std::uint32_t reached = read.value().saved->reached;
    EXPECT_GT(reached, 0u);
    EXPECT_LT(reached, 60'000u);
    const Outcome again =
        plateau({"run", session, "--steps", std::to_string(reached), "--hash", "--betti", "/dev/null"});
    char hash[32];
    std::snprintf(hash, sizeof hash, "hash %016llx\n", static_cast<unsigned long long>(read.value().saved->hash));
    EXPECT_EQ(again.output, hash);
    EXPECT_EQ(again.error, "");
}

}  // namespace
}  // namespace plateau
