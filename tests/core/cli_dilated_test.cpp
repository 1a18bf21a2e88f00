// Family dilated, its outputs and where a run stops, through the command.

#include <cmath>
#include <sstream>

#include "command.h"
#include "io/writers.h"

namespace plateau {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

TEST_F(Command, PumpsAreALineALandmark) {
    const std::string file = sample_file("torus", 400);
    const std::string pumps = path("pumps.csv");
    const Outcome outcome = plateau(
        {"run", file, "--family", "dilated", "--pump", "--omega-bar", "0.5", "--steps", "200", "--pumps", pumps});
    ASSERT_EQ(outcome.code, 0) << outcome.error;
    const auto lines = lines_of(contents(pumps));
    ASSERT_EQ(lines.size(), 201u);
    EXPECT_EQ(lines[0], "step,landmark,omega,sliver_before,sliver_after,thresholds,amplitude,hidden");
    bool is_pumped = false;
    double last_amplitude = 0;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        std::istringstream fields(lines[i]);
        std::vector<double> values;
        for (std::string field; std::getline(fields, field, ',');) values.push_back(std::stod(field));
        ASSERT_EQ(values.size(), 8u);
        EXPECT_EQ(values[0], static_cast<double>(i));
        EXPECT_GE(values[4], values[3]) << "pumping made the star worse, step " << i;
        EXPECT_GE(values[6], last_amplitude);
        last_amplitude = values[6];
        is_pumped = is_pumped || values[2] > 0;
    }
    EXPECT_TRUE(is_pumped);
    EXPECT_GT(last_amplitude, 0.5);
    EXPECT_TRUE(contains(outcome.error, "more than half of the distance")) << outcome.error;

    RunOptions options;
    options.family = Family::Dilated;
    options.max_steps = 200;
    options.dilated.pumps = true;
    options.dilated.pump.omega_bar = 0.5;
    Session session = Session::open(sample_shape("torus", {.size = 400}).value(), options).value();
    session.run({});
    EXPECT_EQ(contents(pumps), pumps_csv(session));
}

TEST_F(Command, TheoryIsItsConstants) {
    const std::string file = sample_file("torus", 300);
    const Outcome theory = plateau({"run", file, "--family", "dilated", "--theory", "--steps", "60", "--hash"});
    const Outcome spelled =
        plateau({"run", file, "--family", "dilated", "--dilation", "0.036756427623585226", "--pump", "--zeta2",
                 "0.5881028419773636", "--sliver", "literal", "--steps", "60", "--hash"});
    ASSERT_EQ(theory.code, 0) << theory.error;
    EXPECT_EQ(theory.output, spelled.output);
    EXPECT_NEAR(0.036756427623585226, 0.375 * std::sin(std::acos(-1.0) / 32), 1e-16);
    EXPECT_NEAR(0.5881028419773636, 6 * std::sin(std::acos(-1.0) / 32), 1e-15);
    const Outcome other = plateau({"run", file, "--family", "dilated", "--steps", "60", "--hash"});
    EXPECT_NE(theory.output, other.output);
}

TEST_F(Command, StopsAtTheNthLongPlateau) {
    const std::string file = sample_file("helix", 400);
    const std::vector<std::string> words = {"run", file, "--min-length", "0.2", "--betti", "-"};
    const Outcome first = plateau(words);
    ASSERT_EQ(first.code, 0) << first.error;
    EXPECT_TRUE(contains(first.error, "a plateau is as long as was asked for")) << first.error;
    auto more = words;
    more.insert(more.end(), {"--nth", "2"});
    const Outcome second = plateau(more);
    EXPECT_GT(lines_of(second.output).size(), lines_of(first.output).size());
    EXPECT_EQ(second.output.rfind(first.output, 0), 0u) << "the same run, longer";
}

TEST_F(Command, SaysWhereFewerPlateausAreAsLong) {
    const std::string file = sample_file("helix", 400);
    const Outcome some = plateau({"run", file, "--min-length", "0.2", "--nth", "50"});
    ASSERT_EQ(some.code, 0) << some.error;
    EXPECT_TRUE(contains(some.error, "Only 4 plateaus are as long as was asked for")) << some.error;
    const Outcome none = plateau({"run", file, "--min-length", "40"});
    ASSERT_EQ(none.code, 0) << none.error;
    EXPECT_TRUE(contains(none.error, "No plateau is as long as was asked for")) << none.error;
}

TEST_F(Command, RefusesOptionsThatWouldDoNothing) {
    const std::string file = sample_file("torus", 100);
    const auto objection = [&](std::vector<std::string> words) {
        words.insert(words.begin(), {"run", file, "--steps", "20"});
        const Outcome outcome = plateau(words);
        EXPECT_EQ(outcome.code, 2);
        return outcome.error;
    };
    for (const char* option : {"--dilation", "--omega-bar", "--zeta2"}) {
        EXPECT_TRUE(contains(objection({option, "0.3"}), std::string(option) + " is for family dilated")) << option;
    }
    EXPECT_TRUE(contains(objection({"--sliver", "literal"}), "add --family dilated"));
    EXPECT_TRUE(contains(objection({"--theory"}), "add --family dilated"));
    EXPECT_TRUE(contains(objection({"--pump"}), "add --family dilated"));
    for (const char* option : {"--omega-bar", "--zeta2"}) {
        EXPECT_TRUE(contains(objection({"--family", "dilated", option, "0.3"}), "is for --pump")) << option;
    }
    EXPECT_TRUE(contains(objection({"--family", "dilated", "--sliver", "normalized"}), "is for --pump"));
    EXPECT_TRUE(contains(objection({"--family", "dilated", "--rho", "2"}), "families surface and auto"));
    EXPECT_TRUE(contains(objection({"--field", "3"}), "families witness and dilated"));
    EXPECT_TRUE(contains(objection({"--min-length", "0", "--nth", "3"}), "above 0"));
    // What a session says about itself counts.
    const std::string session = path("pumped.plateau");
    ASSERT_EQ(plateau({"run", file, "--family", "dilated", "--pump", "--steps", "20", "--session", session}).code, 0);
    EXPECT_EQ(plateau({"run", session, "--omega-bar", "0.1", "--pumps", path("p.csv")}).code, 0);
}

TEST_F(Command, SaysHowManyLandmarksAreHidden) {
    const std::string file = sample_file("torus", 400);
    std::vector<std::string> words = {"run", file, "--family", "dilated", "--steps", "200", "--dilation", "0"};
    EXPECT_FALSE(contains(plateau(words).error, "hidden"));
    words.insert(words.end(), {"--pump", "--omega-bar", "0.5"});
    const std::string error = plateau(words).error;
    EXPECT_TRUE(contains(error, " of 200 landmarks are hidden: ")) << error;
}

TEST_F(Command, FourCoordinatesAreForFamilyDilated) {
    const PointCloud cloud = sample_shape("clifford", {.size = 300}).value();
    const std::string file = written("c.txt", cloud_xyz(cloud, 0, 300));
    EXPECT_TRUE(contains(plateau({"run", file, "--steps", "40"}).output, "dilated"));
    EXPECT_TRUE(contains(plateau({"run", file, "--steps", "40", "--max-dim", "2"}).output, "witness"));
}

}  // namespace
}  // namespace plateau
