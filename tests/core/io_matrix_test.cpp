// Distance matrices: every shape that is read, every way in which one can be wrong.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "base/random.h"
#include "cloud_files.h"
#include "io/cloud_reader.h"
#include "session/session.h"

namespace plateau {
namespace {

using namespace std::string_literals;

using Numbers = std::vector<double>;

ReadOptions as_distances() {
    ReadOptions options;
    options.as = ReadAs::Distances;
    return options;
}

ReadCloud read(const std::string& bytes, const std::string& name = "m.csv") {
    auto result = read_cloud(bytes, name, as_distances());
    if (!result) {
        ADD_FAILURE() << result.error().message << " in " << bytes;
        return {};
    }
    return std::move(result).value();
}

Error failure(const std::string& bytes, const std::string& name = "m.csv") {
    auto result = read_cloud(bytes, name, as_distances());
    if (result) {
        ADD_FAILURE() << "no error in " << bytes;
        return {};
    }
    return result.error();
}

void expect_error(const std::string& bytes, ErrorCode code, const std::string& message,
                  const std::string& name = "m.csv") {
    const Error error = failure(bytes, name);
    EXPECT_EQ(error.code, code) << error.message;
    EXPECT_EQ(error.message, message);
}

std::string dictionary(const std::string& type, const std::string& shape, const char* fortran_order = "False") {
    return "{'descr': '" + type + "', 'fortran_order': " + fortran_order + ", 'shape': " + shape + ", }";
}

template <class T>
std::string values(const std::vector<T>& numbers) {
    std::string bytes;
    for (const T number : numbers) bytes += packed(number, false);
    return bytes;
}

/// Three points of which the second and the third are 2.5 apart.
const Numbers kThree = {1, 2, 2.5};

TEST(MatrixReader, EveryShapeOfATable) {
    for (const char* text : {"0,1,2\n1,0,2.5\n2,2.5,0\n", "0 1 2\r\n1 0 2.5\r\n2 2.5 0", "0;1;2;\n1;0;2.5;\n2;2.5;0;\n",
                             "# remark\n\n0 1 2\n1 0 2.5\n\n2 2.5 0\n# end\n", "1\n2,2.5\n", "0\n1,0\n2,2.5,0\n",
                             "0\n1 0\n2 2.5 -0\n", "a,b,c\n0,1,2\n1,0,2.5\n2,2.5,0\n",
                             ",a,b,c\na,0,1,2\nb,1,0,2.5\nc,2,2.5,0\n", "a b c\na 0 1 2\nb 1 0 2.5\nc 2 2.5 0\n",
                             ",0,1,2\n0,0,1,2\n1,1,0,2.5\n2,2,2.5,0\n", "b 1\nc 2 2.5\n", "a 0\nb 1 0\nc 2 2.5 0\n",
                             "\xEF\xBB\xBF"
                             "0,1,2\n1,0,2.5\n2,2.5,0\n"}) {
        const ReadCloud got = read(text);
        EXPECT_EQ(got.cloud.size(), 3u) << text;
        EXPECT_EQ(got.cloud.dimension, 0u);
        EXPECT_EQ(got.cloud.distances.entries, kThree) << text;
        EXPECT_TRUE(got.warnings.empty()) << text;
        EXPECT_EQ(got.columns_in_file, 3u);
    }
    // Two points that coincide are no diagonal.
    EXPECT_EQ(read("0\n1 1\n3 3 3\n").cloud.distances.entries, (Numbers{0, 1, 1, 3, 3, 3}));
    EXPECT_EQ(read("5\n").cloud.distances.entries, Numbers{5});
}

TEST(MatrixReader, EveryShapeOfAnArray) {
    const Numbers square = {0, 1, 2, 1, 0, 2.5, 2, 2.5, 0};
    for (const char* order : {"False", "True"}) {
        const ReadCloud wide = read(npy_file(1, dictionary("<f8", "(3, 3)", order), values<double>(square)), "m.npy");
        EXPECT_EQ(wide.cloud.distances.entries, kThree);
        EXPECT_TRUE(wide.cloud.distances.narrow.empty());
    }
    const ReadCloud narrow =
        read(npy_file(1, dictionary("<f4", "(3, 3)"), values<float>({0, 1, 2, 1, 0, 2.5, 2, 2.5, 0})), "m.npy");
    EXPECT_EQ(narrow.cloud.distances.narrow, (std::vector<float>{1, 2, 2.5}));
    EXPECT_TRUE(narrow.cloud.distances.entries.empty());
    EXPECT_EQ(read(npy_file(1, dictionary("|u1", "(2, 2)"), "\0\7\7\0"s), "-").cloud.distances.narrow,
              std::vector<float>{7});
    EXPECT_EQ(read(npy_file(1, dictionary("<i4", "(2, 2)"), values<std::int32_t>({0, 16777217, 16777217, 0})), "-")
                  .cloud.distances.entries,
              Numbers{16777217});
    // Condensed: (1,2) (1,3) (1,4) (2,3) (2,4) (3,4).
    EXPECT_EQ(read(npy_file(1, dictionary("<f8", "(6,)"), values<double>({5, 6, 7, 8, 9, 10})), "m.npy")
                  .cloud.distances.entries,
              (Numbers{5, 6, 8, 7, 9, 10}));
    EXPECT_EQ(read(npy_file(1, dictionary("<f8", "(1,)"), values<double>({5})), "m.npy").cloud.distances.entries,
              Numbers{5});
}

TEST(MatrixReader, TheRowOfAWitnessHoldsBothSidesOfTheDiagonal) {
    const DistanceMatrix matrix = read("1\n2 3\n4 5 6\n").cloud.distances;
    Numbers row(4);
    for (std::uint32_t witness = 0; witness < 4; ++witness) {
        matrix.row(witness, row);
        for (std::uint32_t other = 0; other < 4; ++other) EXPECT_EQ(row[other], matrix.distance(witness, other));
    }
    EXPECT_EQ(row, (Numbers{4, 5, 6, 0}));
    EXPECT_EQ(matrix.distance(1, 2), 3);
}

TEST(MatrixReader, AZeroHasNoSign) {
    for (const char* text : {"-0\n1 1\n", "0 -0 1\n-0 0 1\n1 1 0\n"}) {
        const Numbers entries = read(text).cloud.distances.entries;
        EXPECT_EQ(entries, (Numbers{0, 1, 1}));
        EXPECT_FALSE(std::signbit(entries[0])) << text;
    }
    const auto array = npy_file(1, dictionary("<f4", "(3,)"), values<float>({-0.0f, 1, 1}));
    EXPECT_FALSE(std::signbit(read(array, "m.npy").cloud.distances.narrow[0]));
}

TEST(MatrixReader, NotSquare) {
    const ErrorCode code = ErrorCode::RaggedRows;
    expect_error("0 1 2\n1 0 2\n", code, "The matrix ends after row 2 of 3: it is not square.");
    expect_error("0 1\n1 0\n2 2\n", code, "Line 3 is one row more than there are columns: a matrix is square.");
    expect_error("# a\n0 1 2\n1 0\n2 2 0\n", code,
                 "Line 3 has 2 distances instead of 3, as many as line 2: a matrix is square, or what is below its "
                 "diagonal.");
    expect_error("1\n2 3\n4 5\n", code, "Line 3 is one row more than there are distances in the last row.");
    expect_error("1\n2 3 4\n5 6 7\n", code,
                 "Line 2 has 3 distances instead of 2: below a diagonal the rows have 1, 2, 3, ... numbers.");
    expect_error("1\n2 3\n4 5 6 7\n", code,
                 "Line 3 has 4 distances instead of 3: below a diagonal the rows have 1, 2, 3, ... numbers.");
    expect_error(npy_file(1, dictionary("<f8", "(2, 3)"), values<double>({0, 1, 2, 1, 0, 2})), code,
                 "This NumPy array has 2 rows and 3 columns; a distance matrix is square.", "m.npy");
}

TEST(MatrixReader, EntriesThatCannotBe) {
    const ErrorCode malformed = ErrorCode::MalformedInput;
    expect_error("0 1 2\n1 0 3\n2 4 0\n", malformed,
                 "Line 3, row 3, column 2 has 4, but row 2, column 3 has 3: the matrix is not symmetric.");
    expect_error("# a\n0 1 2\n1 0 -3\n2 -3 0\n", malformed, "Line 3, row 2, column 3: the distance is negative, -3.");
    expect_error("0 1 2\n1 0.5 3\n2 3 0\n", malformed,
                 "Line 2, row 2, column 2: the distance of a point to itself must be 0; got 0.5.");
    expect_error("0\n1 0\n2 3 0.5\n", malformed,
                 "Line 3, row 3, column 3: the distance of a point to itself must be 0; got 0.5.");
    expect_error("0,1\n,0\n", malformed, "Line 2, row 2, column 1: an empty field where a distance should be.");
    expect_error("0 1\n1 x\n", malformed, "Line 2, row 2, column 2: \"x\" where a distance should be.");
    expect_error("a b\n0 1\n1,0;\n", malformed,
                 "Line 3 has commas and semicolons: write decimals with a point and use one separator.");
    expect_error("Dear friend,\nhow are you\n", malformed,
                 "Line 2, row 1, column 1: \"are\" where a distance should be.");
    expect_error("Dear\nfriend\n", malformed, "Line 2 has \"friend\" where a number should be.");
    for (const char* text : {"0 nan\nnan 0\n", "0 inf\ninf 0\n", "0 1e999\n1e999 0\n", "nan 1\n1 0\n"}) {
        const Error error = failure(text);
        EXPECT_EQ(error.code, ErrorCode::NotANumber) << text;
        EXPECT_NE(error.message.find("Line 1, row 1, column "), std::string::npos) << error.message;
        EXPECT_NE(error.message.find("not a finite number"), std::string::npos) << error.message;
    }
    expect_error("1\n2 1e151\n", ErrorCode::NotANumber,
                 "Line 2, row 2, column 2: the distance is beyond 1e150; scale the matrix down.");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    expect_error(npy_file(1, dictionary("<f8", "(3,)"), values<double>({1, 2, nan})), ErrorCode::NotANumber,
                 "Row 2, column 3: the distance is not a finite number.", "m.npy");
    expect_error(npy_file(1, dictionary("<f4", "(2, 2)"), values<float>({0, 1, 2, 0})), malformed,
                 "Row 2, column 1 has 2, but row 1, column 2 has 1: the matrix is not symmetric.", "m.npy");
}

TEST(MatrixReader, ArraysThatAreNone) {
    const auto malformed = [](const std::string& bytes, const std::string& part) {
        const Error error = failure(bytes, "m.npy");
        EXPECT_EQ(error.code, ErrorCode::MalformedInput) << error.message;
        EXPECT_NE(error.message.find(part), std::string::npos) << error.message;
    };
    malformed(npy_file(1, dictionary("<f8", "(4,)"), values<double>({1, 2, 3, 4})), "has 4 values");
    malformed(npy_file(1, dictionary("<f8", "(2, 2)"), values<double>({0, 1, 1})), "more values than the 3");
    malformed(npy_file(1, dictionary("<f8", "(3,)"), values<double>({1, 2})), "more values than the 2");
    malformed(npy_file(1, dictionary("<f8", "()"), values<double>({1})), "0 dimensions");
    malformed(npy_file(1, dictionary("<f8", "(1, 1, 1)"), values<double>({0})), "3 dimensions");
    malformed(npy_file(1, dictionary("<f8", "(4294967297, 4294967297)"), values<double>({0})), "more values");
    malformed(npy_file(1, dictionary("<f8", "(18446744073709551615,)"), values<double>({0})), "more values");
    EXPECT_EQ(failure(npy_file(1, dictionary("<f8", "(0, 0)"), ""), "m.npy").code, ErrorCode::EmptyInput);
    EXPECT_EQ(failure(npy_file(1, dictionary("<f8", "(0,)"), ""), "m.npy").code, ErrorCode::EmptyInput);
    EXPECT_EQ(failure(npy_file(1, dictionary("<f8", "(1, 1)"), values<double>({0})), "m.npy").code,
              ErrorCode::TooFewPoints);
}

TEST(MatrixReader, TooLittleOrOfAnotherKind) {
    for (const char* text : {"", " \n", "# only a remark\n", "a b c\n"}) {
        EXPECT_EQ(failure(text).code, ErrorCode::EmptyInput) << text;
    }
    EXPECT_EQ(failure("0\n").code, ErrorCode::TooFewPoints);
    EXPECT_EQ(failure("0 0\n0 0\n").code, ErrorCode::TooFewPoints);
    EXPECT_EQ(failure("ply\nformat ascii 1.0\nend_header\n", "m.ply").code, ErrorCode::UnknownFormat);
    EXPECT_EQ(failure("OFF\n1 0 0\n0 0 0\n", "m.off").code, ErrorCode::UnknownFormat);
    EXPECT_EQ(failure("\x89PNG", "m.csv").code, ErrorCode::UnknownFormat);
    ReadOptions options = as_distances();
    options.columns = {1, 2};
    EXPECT_EQ(read_cloud("0 1\n1 0\n", "m.csv", options).error().code, ErrorCode::InvalidOption);
}

TEST(MatrixReader, WhatDoesNotFitIsRefusedWithWhatItTakes) {
    ReadOptions options = as_distances();
    options.memory_limit = 1 << 20;
    std::string line = "0";
    for (int k = 1; k < 2000; ++k) line += " 1";
    const auto refused = read_cloud(line + "\n", "m.csv", options);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::OutOfMemory);
    EXPECT_EQ(refused.error().message,
              "2,000 x 2,000 distances and their file need 16 MB, but only 1 MB may be used: take fewer points, or a "
              ".npy array of single precision.");
    // A triangle tells its size by its last row.
    const auto triangle = read_cloud("0\n1 0\n" + line + "\n", "m.csv", options);
    ASSERT_FALSE(triangle);
    EXPECT_EQ(triangle.error().code, ErrorCode::OutOfMemory);
    options.memory_limit = 100;
    EXPECT_TRUE(read_cloud("0 1\n1 0\n", "m.csv", options));

    RunOptions run;
    run.metric.metric = Metric::Matrix;
    run.memory_limit = 1000;
    EXPECT_EQ(Session::open(read("1\n2 3\n").cloud, run).error().code, ErrorCode::OutOfMemory);
}

TEST(MatrixReader, RoundingIsMendedWithAWarning) {
    const ReadCloud got = read("0 1 2\n1 0 3\n2.0000000000000004 3 0\n");
    EXPECT_EQ(got.cloud.distances.entries, (Numbers{1, 2.0000000000000004, 3}));
    ASSERT_EQ(got.warnings.size(), 1u);
    EXPECT_EQ(got.warnings[0],
              "1 distance differs by rounding from the mirror image (Line 3, row 3, column 1); what is "
              "below the diagonal was taken.");
}

TEST(MatrixReader, AFailingTriangleIsNamed) {
    for (const char* text : {"0 1 2 9\n1 0 2 9\n2 2 0 3\n9 9 3 0\n", "1\n2 2\n9 9 3\n"}) {
        const ReadCloud got = read(text);
        ASSERT_EQ(got.warnings.size(), 1u);
        EXPECT_EQ(got.warnings[0],
                  "The triangle inequality fails in 2 of 4 triples: from point 1 to point 4 it is 9, but by way of "
                  "point 3 2 + 3, for one. The distances are taken as they are.");
    }
    const ReadCloud last = read("8\n8 2\n8 9 3\n");
    ASSERT_EQ(last.warnings.size(), 1u);
    EXPECT_EQ(last.warnings[0],
              "The triangle inequality fails in 1 of 4 triples: from point 2 to point 4 it is 9, but by way of point 3 "
              "2 + 3. The distances are taken as they are.");
    // Any of the three sides can be the long one; a degenerate triangle is one.
    for (const char* text : {"5\n1 2\n", "1\n5 2\n", "2\n1 5\n"}) EXPECT_EQ(read(text).warnings.size(), 1u) << text;
    for (const char* text : {"3\n1 2\n", "1\n3 2\n", "2\n1 3\n", "0.3\n0.1 0.2\n"}) {
        EXPECT_TRUE(read(text).warnings.empty()) << text;
    }
}

/// Distances between the points 0, 1, 2, ... of a line.
std::string line_matrix(int n) {
    std::string text;
    for (int i = 1; i < n; ++i) {
        for (int j = 0; j < i; ++j) text += std::to_string(i - j) + (j + 1 < i ? " " : "\n");
    }
    return text;
}

TEST(MatrixReader, ManyTriplesAreDrawn) {
    EXPECT_TRUE(read(line_matrix(300)).warnings.empty());
    EXPECT_TRUE(read(line_matrix(301)).warnings.empty());
    std::string text;
    for (int i = 1; i < 301; ++i) {
        for (int j = 0; j < i; ++j) text += (i == 200 && j == 100 ? "9 " : "1 ");
        text += "\n";
    }
    const ReadCloud got = read(text);
    ASSERT_EQ(got.warnings.size(), 1u);
    EXPECT_NE(got.warnings[0].find(" of 2,000,000 triples that were drawn: from point 101 to point 201 it is 9"),
              std::string::npos)
        << got.warnings[0];
    EXPECT_EQ(read(text).warnings, got.warnings);
}

TEST(MatrixReader, SlicesGiveTheSameMatrix) {
    std::string text;
    Random random(5);
    for (int i = 1; i < 400; ++i) {
        for (int j = 0; j < i; ++j) text += std::to_string(1 + random.next_unit()) + (j + 1 < i ? "," : "\n");
    }
    CloudReader reader(text, "m.csv", as_distances());
    int slices = 1;
    while (!reader.advance(0)) ++slices;
    EXPECT_GT(slices, 20);
    const DistanceMatrix sliced = reader.take().value().cloud.distances;
    EXPECT_EQ(sliced.size, 400u);
    EXPECT_EQ(sliced.entries, read(text).cloud.distances.entries);
}

}  // namespace
}  // namespace plateau
