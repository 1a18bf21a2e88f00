// `plateau inspect`.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "command.h"
#include "io/inspection_text.h"
#include "session/session.h"

namespace plateau {
namespace {

TEST_F(Command, InspectPrintsOneLine) {
    const std::string torus = sample_file("torus", 300);
    const Outcome outcome = plateau({"inspect", torus, "--step", "40", "--simplex", "7,2,31"});
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_EQ(outcome.error, "");
    RunOptions options;
    options.max_steps = 40;
    Session session = Session::open(sample_shape("torus", {.size = 300}).value(), options).value();
    session.run({});
    EXPECT_EQ(outcome.output, inspection_text(session.inspect(40, {7, 2, 31}).value()) + "\n");
    EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 1);
}

TEST_F(Command, InspectTakesTheOptionsOfRuns) {
    const std::string torus = sample_file("torus", 200);
    const Outcome wide =
        plateau({"inspect", torus, "--step", "20", "--simplex", "20", "--family", "witness", "--nu", "2,4,4"});
    EXPECT_TRUE(contains(wide.output, "among their 2 nearest landmarks")) << wide.output << wide.error;
    const Outcome dilated =
        plateau({"inspect", torus, "--step", "20", "--simplex", "20", "--family", "dilated", "--dilation", "0.5"});
    EXPECT_TRUE(contains(dilated.output, "within zeta")) << dilated.output << dilated.error;
    const Outcome sum = plateau({"inspect", "-", "--metric", "l1", "--step", "3", "--simplex", "1,3"}, contents(torus));
    EXPECT_EQ(sum.code, 0) << sum.error;
}

// Its own options are followed, and no further than to the step.
TEST_F(Command, InspectOpensSessions) {
    const std::string torus = sample_file("torus", 200);
    const std::string session = path("run.plateau");
    ASSERT_EQ(plateau({"run", torus, "--nu", "1,4,5,4", "--session", session}).code, 0);
    const std::vector<std::string> question = {"--step", "30", "--simplex", "3,30"};
    std::vector<std::string> of_session = {"inspect", session};
    std::vector<std::string> of_points = {"inspect", torus, "--nu", "1,4,5,4"};
    of_session.insert(of_session.end(), question.begin(), question.end());
    of_points.insert(of_points.end(), question.begin(), question.end());
    const Outcome saved = plateau(of_session);
    EXPECT_EQ(saved.code, 0) << saved.error;
    EXPECT_EQ(saved.output, plateau(of_points).output);
}

TEST_F(Command, InspectRefusesWhatIsNoQuestion) {
    const std::string torus = sample_file("torus", 50);
    EXPECT_TRUE(contains(refused({"inspect", torus, "--step", "9"}), "--simplex"));
    EXPECT_TRUE(contains(refused({"inspect", torus, "--simplex", "1,2"}), "--step"));
    EXPECT_TRUE(contains(refused({"inspect", torus, "--step", "0", "--simplex", "1"}), "--step 0 is out of range"));
    EXPECT_TRUE(
        contains(refused({"inspect", torus, "--step", "9", "--simplex", "a"}), "--simplex takes whole numbers"));
    EXPECT_TRUE(contains(refused({"inspect", torus, "--step", "9", "--simplex", "2,2"}), "named twice"));
    EXPECT_TRUE(contains(refused({"inspect", torus, "--step", "51", "--simplex", "2"}), "Step 51 is not computed"));
    EXPECT_TRUE(contains(refused({"inspect", path("none"), "--step", "1", "--simplex", "1"}), "none"));
}

}  // namespace
}  // namespace plateau
