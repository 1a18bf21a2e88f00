// The command with other metrics than the Euclidean one, and with points of any dimension.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "command.h"
#include "io/cloud_reader.h"

namespace plateau {
namespace {

/// Points of an integer grid in the plane, and how far they are from each other.
struct Grid {
    std::string points;
    std::string square;
    std::string triangle;
};

Grid grid(int side) {
    Grid grid;
    const auto number = [](double value) {
        char text[32];
        std::snprintf(text, sizeof text, "%.17g", value);
        return std::string(text);
    };
    for (int a = 0; a < side * side; ++a) {
        grid.points += std::to_string(a / side) + " " + std::to_string(a % side) + "\n";
        for (int b = 0; b < side * side; ++b) {
            const double dx = a / side - b / side;
            const double dy = a % side - b % side;
            const std::string distance = number(std::sqrt(dx * dx + dy * dy));
            grid.square += (b > 0 ? "," : "") + distance;
            if (b < a) grid.triangle += (b > 0 ? " " : "") + distance;
        }
        grid.square += "\n";
        if (a > 0) grid.triangle += "\n";
    }
    return grid;
}

TEST_F(Command, MatrixAndPointsGiveTheSameHash) {
    const Grid tied = grid(6);
    const std::vector<std::string> options = {"--family", "witness", "--max-dim", "2", "--hash"};
    const auto with = [&](std::vector<std::string> words) {
        words.insert(words.end(), options.begin(), options.end());
        return words;
    };
    const Outcome points = plateau(with({"run", "-"}), tied.points);
    EXPECT_EQ(points.code, 0) << points.error;
    for (const std::string* text : {&tied.square, &tied.triangle}) {
        const Outcome matrix = plateau(with({"run", "-", "--metric", "matrix"}), *text);
        EXPECT_EQ(matrix.code, 0) << matrix.error;
        EXPECT_EQ(matrix.output, points.output);
        EXPECT_EQ(matrix.error, "");
    }
}

TEST_F(Command, EveryMetricRuns) {
    const std::string file = written("g.txt", grid(7).points);
    const std::string space = sample_file("sphere", 120);
    const auto first_lines = [&](std::vector<std::string> words) {
        words.insert(words.end(), {"--betti", "-", "--steps", "12"});
        const Outcome outcome = plateau(words);
        EXPECT_EQ(outcome.code, 0) << words[3] << outcome.error;
        return outcome.output;
    };
    std::vector<std::string> outputs;
    for (const char* metric : {"l1", "linf", "angular", "projective", "geodesic", "euclidean"}) {
        outputs.push_back(first_lines({"run", space, "--metric", metric, "--family", "witness"}));
        EXPECT_EQ(outputs.back().substr(0, outputs.back().find('\n')),
                  "step,landmark,epsilon,family,beta0,beta1,beta2");
    }
    outputs.push_back(first_lines({"run", file, "--metric", "periodic", "--box", "7"}));
    outputs.push_back(first_lines({"run", file, "--metric", "periodic", "--box", "7,0"}));
    outputs.push_back(first_lines({"run", file, "--metric", "geodesic", "--knn", "3"}));
    std::sort(outputs.begin(), outputs.end());
    EXPECT_EQ(std::unique(outputs.begin(), outputs.end()), outputs.end()) << "each is its own";
}

TEST_F(Command, AsManyColumnsOfBettiNumbersAsAskedFor) {
    const std::string file = sample_file("sphere", 80);
    for (int last = 0; last <= 6; ++last) {
        const Outcome outcome = plateau(
            {"run", file, "--family", "witness", "--max-dim", std::to_string(last), "--steps", "10", "--betti", "-"});
        EXPECT_EQ(outcome.code, 0) << outcome.error;
        const std::string header = outcome.output.substr(0, outcome.output.find('\n'));
        EXPECT_EQ(header.substr(header.rfind(',')), ",beta" + std::to_string(last));
        const std::string line = outcome.output.substr(header.size() + 1, outcome.output.find('\n', header.size() + 1));
        EXPECT_EQ(std::count(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(line.find('\n')), ','), 4 + last);
    }
}

TEST_F(Command, WideTablesAreReadAsPointsOfManyDimensionsWithANote) {
    const std::string text = "1 2 3 4 5\n1 2 3 4 6\n9 2 3 4 5\n1 7 3 4 5\n";
    const Outcome wide = plateau({"run", "-", "--betti", "-"}, text);
    EXPECT_EQ(wide.code, 0);
    EXPECT_TRUE(contains(wide.error, "points in R^5")) << wide.error;
    EXPECT_TRUE(contains(wide.output, ",beta4\n")) << wide.output;
    const Outcome four = plateau({"run", "-", "--columns", "1,2,4,5"}, text);
    EXPECT_EQ(four.code, 0);
    EXPECT_EQ(four.error, "");
}

TEST_F(Command, BadMetricsAreOneLineAndExit2) {
    const std::string file = sample_file("torus", 100);
    const std::string matrix = written("m.csv", grid(3).square);
    EXPECT_TRUE(contains(refused({"run", file, "--metric", "l3"}), "periodic, geodesic or matrix"));
    EXPECT_TRUE(contains(refused({"run", file, "--metric", "l1", "--family", "auto"}), "Only family witness"));
    EXPECT_TRUE(contains(refused({"run", file, "--metric", "periodic"}), "unit box"));
    EXPECT_TRUE(contains(refused({"run", file, "--metric", "periodic", "--box", "1,2"}), "3 coordinates"));
    refused({"run", file, "--metric", "periodic", "--box", "1,two,3"});
    refused({"run", file, "--metric", "periodic", "--box", ""});
    refused({"run", file, "--metric", "periodic", "--box", "-1"});
    refused({"run", file, "--box", "2"});
    refused({"run", file, "--knn", "5"});
    refused({"run", file, "--metric", "geodesic", "--knn", "0"});
    refused({"run", file, "--metric", "geodesic", "--knn", "-1"});
    EXPECT_TRUE(contains(refused({"run", "-", "--metric", "geodesic", "--knn", "1"}, "0 0\n0 1\n9 9\n9 8\n"),
                         "falls into 2 pieces, the smallest of 2 points around point 1"));
    refused({"run", file, "--max-dim", "2"});
    EXPECT_TRUE(contains(refused({"run", file, "--family", "witness", "--max-dim", "7"}), "beta6 at most"));
    refused({"run", file, "--family", "witness", "--max-dim", "x"});
    EXPECT_TRUE(contains(refused({"run", matrix, "--metric", "matrix", "--columns", "1,2"}), "no columns"));
    refused({"run", matrix, "--metric", "matrix", "--family", "delaunay"});
    EXPECT_TRUE(contains(refused({"run", "-", "--metric", "matrix"}, "0 1\n2 0\n"), "Line 2, row 2, column 1"));
    std::string wide = "0 1 1 1 1 1 1 1 1\n";
    EXPECT_TRUE(contains(refused({"run", "-", "--metric", "matrix", "--memory", "1"}, std::string(1 << 20, ' ') + wide),
                         "but only 1 MB may be used"));
}

TEST_F(Command, AMeshNeedsAPlaceAndStraightEdges) {
    const std::string matrix = written("m.csv", grid(3).square);
    const std::string plane = written("g.txt", grid(5).points);
    const std::string mesh = path("m.ply");
    EXPECT_TRUE(contains(refused({"run", matrix, "--metric", "matrix", "--mesh", mesh}), "no mesh of this run"));
    refused({"run", plane, "--metric", "periodic", "--box", "5", "--mesh", mesh});
    refused({"run", "-", "--metric", "projective", "--mesh", mesh}, "1 2\n3 4\n5 1\n");
    EXPECT_TRUE(contains(refused({"run", "-", "--columns", "1,2,3,4", "--mesh", mesh}, "1 2 3 4\n5 6 7 9\n0 0 0 1\n"),
                         "4 coordinates"));
    EXPECT_EQ(plateau({"run", plane, "--metric", "l1", "--mesh", mesh}).code, 0);
    EXPECT_TRUE(contains(contents(mesh), "element edge"));
}

}  // namespace
}  // namespace plateau
