// Drives the built command as a process.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "cloud/samples.h"
#include "command.h"
#include "io/mesh_files.h"
#include "io/writers.h"

namespace plateau {
namespace {

TEST_F(Command, HelpAndVersion) {
    for (const std::vector<std::string>& arguments :
         std::vector<std::vector<std::string>>{{"--help"}, {"run", "--help"}, {"sample", "--help"}, {"--version"}}) {
        const Outcome outcome = plateau(arguments);
        EXPECT_EQ(outcome.code, 0);
        EXPECT_EQ(outcome.error, "");
        EXPECT_FALSE(outcome.output.empty());
    }
    EXPECT_EQ(plateau({"--version"}).output.rfind("plateau ", 0), 0u);
    const std::string help = plateau({"run", "--help"}).output;
    for (const char* option :
         {"--family", "--nu",      "--first",  "--steps",   "--until",   "--rho",   "--columns",
          "--field",  "--metric",  "--knn",    "--box",     "--max-dim", "--betti", "--plateaus",
          "--mesh",   "--complex", "--report", "--session", "--at",      "--hash",  "--progress"}) {
        EXPECT_TRUE(contains(help, option)) << option;
    }
    for (const SampleShape& shape : sample_shapes()) {
        EXPECT_TRUE(contains(plateau({"sample", "--help"}).output, std::string(shape.name)));
    }
}

TEST_F(Command, SamplePrintsTheShape) {
    const Outcome outcome = plateau({"sample", "torus", "--n", "250", "--noise", "0.05", "--seed", "7"});
    EXPECT_EQ(outcome.code, 0);
    const PointCloud cloud = sample_shape("torus", {.size = 250, .noise = 0.05, .seed = 7}).value();
    EXPECT_EQ(outcome.output, cloud_xyz(cloud, 0, 250));
    const std::string circle = plateau({"sample", "circle-noise"}).output;
    EXPECT_EQ(std::count(circle.begin(), circle.end(), '\n'), 1000);
}

TEST_F(Command, WithoutOutputsTheTableOnStandardOutput) {
    const std::string circle = plateau({"sample", "circle-noise", "--n", "300"}).output;
    const Outcome outcome = plateau({"run", "-"}, circle);
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.error, "");
    EXPECT_EQ(outcome.output.rfind("length", 0), 0u);
    std::istringstream lines(outcome.output);
    std::string line;
    std::getline(lines, line);
    std::getline(lines, line);
    EXPECT_TRUE(contains(line, "(1, 1)")) << line;
    EXPECT_EQ(plateau({"run", sample_file("circle-noise", 300)}).output, outcome.output);
    EXPECT_EQ(plateau({"run", "-", "--progress"}, circle).output, outcome.output);
}

TEST_F(Command, OutputsAreThoseOfTheWriters) {
    const std::string file = sample_file("torus", 600);
    auto opened = Session::open(sample_shape("torus", {.size = 600}).value(), {});
    ASSERT_TRUE(opened);
    Session session = std::move(opened).value();
    session.run({});
    const Outcome outcome = plateau(
        {"run", file, "--betti", path("b.csv"), "--plateaus", path("p.json"), "--mesh", path("m.ply"), "--hash"});
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_EQ(outcome.error, "");
    char hash[32];
    std::snprintf(hash, sizeof hash, "hash %016llx\n", static_cast<unsigned long long>(session.hash()));
    EXPECT_EQ(outcome.output, hash);
    EXPECT_EQ(contents(path("b.csv")), betti_csv(session));
    EXPECT_EQ(contents(path("p.json")), plateaus_json(session));
    EXPECT_EQ(contents(path("m.ply")), mesh_ply(session, std::nullopt));

    EXPECT_EQ(plateau({"run", file, "--betti", "-"}).output, betti_csv(session));
    EXPECT_EQ(plateau({"run", file, "--plateaus", "-"}).output, plateaus_json(session));
    EXPECT_EQ(plateau({"run", file, "--mesh", "-", "--at", "40"}).output, mesh_ply(session, 40u));
    EXPECT_EQ(plateau({"run", file, "--betti", "-", "--hash"}).output, betti_csv(session) + hash);
    EXPECT_EQ(plateau({"run", file, "--hash"}).output, plateau_table(session) + hash);
}

TEST_F(Command, OptionsReachTheRun) {
    const std::string file = sample_file("torus", 300);
    const auto lines = [&](std::vector<std::string> options) {
        options.insert(options.begin(), {"run", file, "--betti", "-"});
        const std::string text = plateau(options).output;
        return std::count(text.begin(), text.end(), '\n') - 1;
    };
    EXPECT_EQ(lines({"--steps", "17"}), 17);
    EXPECT_LT(lines({"--until", "0.5"}), 100);
    EXPECT_TRUE(contains(plateau({"run", file, "--first", "42", "--betti", "-", "--steps", "1"}).output, "\n1,42,"));
    EXPECT_TRUE(contains(plateau({"run", file, "--family", "witness", "--betti", "-"}).output, ",witness,"));
    EXPECT_FALSE(contains(plateau({"run", file, "--family", "delaunay", "--betti", "-"}).output, ",surface,"));
    EXPECT_NE(plateau({"run", file, "--family", "delaunay", "--nu", "1,2,3,4", "--hash"}).output,
              plateau({"run", file, "--family", "delaunay", "--hash"}).output);
    // Options may stand before the input.
    EXPECT_EQ(plateau({"run", "--columns", "1,2", "--steps", "3", file}).code, 0);
    const std::string table = written("t.csv", "a,b,c,d\n1,0,0,7\n2,0,1,8\n3,1,0,9\n");
    EXPECT_EQ(plateau({"run", table, "--columns", "2,3", "--betti", "-"}).output,
              plateau({"run", "-", "--betti", "-"}, "0 0\n0 1\n1 0\n").output);
}

TEST_F(Command, StopsAtTheNoiseOrAtTheMemoryWithASentence) {
    const std::string file = sample_file("torus", 900);
    const Outcome noise = plateau({"run", file, "--until", "noise", "--betti", "-"});
    EXPECT_EQ(noise.code, 0);
    EXPECT_TRUE(contains(noise.error, "fallen to the noise, 0.0")) << noise.error;
    const auto steps = std::count(noise.output.begin(), noise.output.end(), '\n') - 1;
    EXPECT_GT(steps, 300);
    EXPECT_LT(steps, 900);

    const Outcome full = plateau({"run", file, "--memory", "2", "--betti", "-"});
    EXPECT_EQ(full.code, 0) << "what was computed is written";
    EXPECT_TRUE(contains(full.error, "all that it may take")) << full.error;
    EXPECT_EQ(full.output, noise.output.substr(0, full.output.size())) << "the same steps";
    EXPECT_GT(full.output.size(), 1000u);
}

TEST_F(Command, BadUsageIsOneLineAndExit2) {
    const std::string file = sample_file("torus", 100);
    refused({});
    refused({"walk"});
    refused({"run"});
    refused({"run", file, "another.xyz"});
    refused({"run", file, "--unknown"});
    refused({"run", file, "--steps", "many"});
    refused({"run", file, "--steps", "-1"});
    refused({"run", file, "--steps", "0"});
    refused({"run", file, "--steps", "99999999999"});
    refused({"run", file, "--until", "-1"});
    refused({"run", file, "--until", "noisy"});
    refused({"run", file, "--memory", "0"});
    refused({"run", file, "--memory", "much"});
    refused({"run", file, "--until", "nan"});
    refused({"run", file, "--rho", "-1"});
    refused({"run", file, "--first", "100"});
    refused({"run", file, "--field", "4"});
    refused({"run", file, "--nu", "1,two"});
    refused({"run", file, "--nu", "1,6,6,4,"});
    refused({"run", file, "--columns", "1"});
    refused({"run", file, "--columns", "1,1"});
    refused({"run", file, "--columns", "1,9"});
    refused({"run", file, "--at", "5"});
    refused({"run", file, "--betti", "-", "--mesh", "-"});
    EXPECT_TRUE(contains(refused({"run", file, "--family", "dilated", "--dilation", "1.5"}), "from 0 to 1"));
    EXPECT_TRUE(contains(refused({"run", file, "--family", "dilated", "--nu", "1,2"}), "has no nu"));
    EXPECT_TRUE(contains(refused({"run", file, "--family", "dilated", "--pumps", "-"}), "is for --pump"));
    EXPECT_TRUE(contains(refused({"run", file, "--family", "dilated", "--sliver", "thin"}), "literal or normalized"));
    EXPECT_TRUE(contains(refused({"run", file, "--family", "dilated", "--omega-bar", "0.7"}), "omega-bar"));
    EXPECT_TRUE(contains(refused({"run", file, "--family", "dilated", "--zeta2", "-1"}), "zeta2"));
    refused({"run", file, "--theory", "--dilation", "0.3"});
    EXPECT_TRUE(contains(refused({"run", file, "--family", "witness", "--pump"}), "add --family dilated"));
    EXPECT_TRUE(contains(refused({"run", file, "--min-length", "-1"}), "least length"));
    EXPECT_TRUE(contains(refused({"run", file, "--min-length", "1", "--nth", "0"}), "--nth 0"));
    refused({"run", file, "--nth", "2"});
    EXPECT_TRUE(contains(refused({"run", file, "--family", "cech"}), "witness, delaunay, surface, auto or dilated"));
    EXPECT_TRUE(contains(refused({"sample", "cube"}), "swiss-roll"));
    refused({"sample"});
    refused({"sample", "torus", "--n", "0"});
    refused({"sample", "torus", "--n", "20000000"});
    refused({"sample", "torus", "--noise", "-1"});
}

TEST_F(Command, StepOfTheMeshOutOfRange) {
    const std::string file = sample_file("torus", 100);
    refused({"run", file, "--mesh", path("m.ply"), "--at", "0"});
    EXPECT_TRUE(contains(refused({"run", file, "--mesh", path("m.ply"), "--at", "101"}), "100 steps"));
    // Only duplicates are left after step 2.
    EXPECT_TRUE(contains(refused({"run", "-", "--mesh", path("m.ply"), "--at", "3"}, "0 0\n1 1\n0 0\n"), "2 steps"));
    EXPECT_FALSE(std::ifstream(path("m.ply")).good());
}

TEST_F(Command, BadInputIsOneLineAndExit2) {
    EXPECT_TRUE(contains(refused({"run", path("missing.xyz")}), "missing.xyz"));
    refused({"run", path("")});
    EXPECT_TRUE(contains(refused({"run", "-"}, ""), "standard input: The file is empty."));
    EXPECT_TRUE(contains(refused({"run", "-"}, "1 2 3\n"), "one point"));
    EXPECT_TRUE(contains(refused({"run", "-"}, "1 2\n1 2\n"), "All 2 points are the same"));
    EXPECT_TRUE(contains(refused({"run", "-"}, "1 2\n3 nan\n"), "Line 2"));
    EXPECT_TRUE(contains(refused({"run", "-"}, "1 2\n3\n"), "Line 2"));
    EXPECT_TRUE(contains(refused({"run", written("a.xyz", "\x89PNG\r\n")}), "a.xyz: This seems to be a PNG"));
}

TEST_F(Command, OutputsThatCannotBeWritten) {
    const std::string file = sample_file("torus", 100);
    refused({"run", file, "--betti", path("no/such/folder.csv")});
    refused({"run", file, "--mesh", path("")});
    if (std::ifstream("/dev/full").good()) {
        EXPECT_TRUE(contains(refused({"run", file, "--plateaus", "/dev/full"}), "/dev/full"));
    }
}

TEST_F(Command, FlatCloudsRunWithANote) {
    const Outcome line = plateau({"run", "-"}, "0 0 0\n1 1 1\n2 2 2\n5 5 5\n");
    EXPECT_EQ(line.code, 0);
    EXPECT_EQ(line.error, "plateau: All points lie on one line.\n");
    const Outcome plane = plateau({"run", "-"}, "0 0 0\n1 0 0\n0 1 0\n1 1 0\n");
    EXPECT_EQ(plane.code, 0);
    EXPECT_EQ(plane.error, "plateau: All points lie in one plane.\n");
    EXPECT_EQ(plateau({"run", "-"}, "0 0\n1 0\n0 1\n").error, "");
}

TEST_F(Command, ColumnsTakenByTheReaderAreReported) {
    const Outcome outcome = plateau({"run", written("c.xyz", "0 0 0 9\n1 0 0 9\n0 1 0 9\n0 0 1 9\n")});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.error,
              "plateau: Took columns 1,2,3 of 4 as coordinates. Take points of R^4 with --columns 1,2,3,4.\n");
}

TEST_F(Command, CtrlCWritesWhatIsDone) {
    // Large enough that it cannot be finished; the first steps come within seconds even on a busy machine.
    written("stdin", "");
    const std::string file = sample_file("torus", 300'000);
    const pid_t child = started({"run", file, "--betti", path("b.csv"), "--plateaus", path("p.json"), "--progress"});
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (!contains(contents(path("stderr")), "step ") && std::chrono::steady_clock::now() < deadline) {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    ASSERT_EQ(kill(child, SIGINT), 0);
    const Outcome outcome = ended(child);
    EXPECT_EQ(outcome.code, 130);
    EXPECT_TRUE(contains(outcome.error, "Interrupted after step ")) << outcome.error;
    const std::string betti = contents(path("b.csv"));
    const auto steps = std::count(betti.begin(), betti.end(), '\n') - 1;
    EXPECT_GT(steps, 0);
    EXPECT_LT(steps, 300'000);
    EXPECT_TRUE(contains(outcome.error, "after step " + std::to_string(steps) + " of 300000"));
    EXPECT_TRUE(contains(contents(path("p.json")), "]}"));
}

TEST_F(Command, CtrlCWhileItWaitsForInput) {
    int pipe_ends[2];
    ASSERT_EQ(pipe2(pipe_ends, O_CLOEXEC), 0);
    const pid_t child = fork();
    if (child == 0) {
        dup2(pipe_ends[0], 0);
        close(pipe_ends[1]);
        execl(PLATEAU_BINARY, PLATEAU_BINARY, "run", "-", nullptr);
        _exit(127);
    }
    close(pipe_ends[0]);
    // Fill the pipe until it blocks for good: the command is reading, so its handler is in place.
    const std::string row(65536, '\n');
    for (int k = 0; k < 20; ++k) ASSERT_EQ(write(pipe_ends[1], row.data(), row.size()), 65536);
    kill(child, SIGINT);
    int status = 0;
    waitpid(child, &status, 0);
    close(pipe_ends[1]);
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 130);
}

TEST_F(Command, AReaderWhoLeavesEarlyIsNoError) {
    written("stdin", "");
    int pipe_ends[2];
    ASSERT_EQ(pipe2(pipe_ends, O_CLOEXEC), 0);
    const pid_t child = started({"sample", "torus", "--n", "200000"}, pipe_ends[1]);
    close(pipe_ends[1]);
    char first = 0;
    EXPECT_EQ(read(pipe_ends[0], &first, 1), 1);
    close(pipe_ends[0]);
    const Outcome outcome = ended(child);
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.error, "");
}

}  // namespace
}  // namespace plateau
