#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/cloud_reader.h"

namespace plateau {
namespace {

using Numbers = std::vector<double>;

ReadCloud read(const std::string& text, std::string_view name = "cloud.txt", const ReadOptions& options = {}) {
    auto result = read_cloud(text, name, options);
    if (!result) {
        ADD_FAILURE() << result.error().message << " in " << text;
        return {};
    }
    return std::move(result).value();
}

Error failure(const std::string& text, std::string_view name = "cloud.txt", const ReadOptions& options = {}) {
    auto result = read_cloud(text, name, options);
    if (result) {
        ADD_FAILURE() << "no error in " << text;
        return {};
    }
    return result.error();
}

TEST(TableReader, SeparatorsGiveTheSameCloud) {
    for (const char* text : {"1 2 3\n4 5 6\n", "1\t2\t3\n4\t5\t6\n", "1,2,3\n4,5,6\n", "1;2;3\n4;5;6\n",
                             "1, 2, 3\n4 ,5 , 6", "  1   2\t 3  \n\t4 5 6\t", "1,2,3,\n4,5,6,\n", "1 2 3\r\n4 5 6\r\n",
                             "1 2 3\r4 5 6\r", "\n\n1 2 3\n\n4 5 6\n\n",
                             "\xEF\xBB\xBF"
                             "1 2 3\n4 5 6\n",
                             "+1 2. 3.0e0\n.4e1 50E-1 0006\n"}) {
        for (const char* name : {"a.txt", "a.xyz", "a.csv", "A.CSV", "-", "", "a.dat"}) {
            const ReadCloud got = read(text, name);
            EXPECT_EQ(got.cloud.dimension, 3u) << text;
            EXPECT_EQ(got.cloud.coordinates, (Numbers{1, 2, 3, 4, 5, 6})) << text;
            EXPECT_EQ(got.columns_in_file, 3u);
            EXPECT_TRUE(got.warnings.empty());
        }
    }
}

TEST(TableReader, CommentsAndHeadersAreSkipped) {
    for (const char* text :
         {"# remark\n1 2\n3 4\n", "// X Y\n1 2\n3 4\n", "; remark\n1 2\n# more, and; more\n3 4\n", "x y\n1 2\n3 4\n",
          "x,y\n1,2\n3,4\n", "\"x\";\"y\"\n1;2\n3;4\n", "# remark\n\nlongitude latitude\n1 2\n3 4"}) {
        const ReadCloud got = read(text);
        EXPECT_EQ(got.cloud.dimension, 2u) << text;
        EXPECT_EQ(got.cloud.coordinates, (Numbers{1, 2, 3, 4})) << text;
    }
}

TEST(TableReader, DecimalsAreCorrectlyRounded) {
    const ReadCloud got = read("0.1 1e-320\n17976931348623157e-10 -0.30000000000000004\n");
    EXPECT_EQ(got.cloud.coordinates, (Numbers{0.1, 1e-320, 17976931348623157e-10, -0.30000000000000004}));
}

TEST(TableReader, DuplicatePointsAreKept) {
    EXPECT_EQ(read("1 2\n1 2\n3 4\n1 2\n").cloud.size(), 4u);
}

TEST(TableReader, ManyColumnsAskForAChoice) {
    const Error error = failure("1 2 3 4 5 6\n7 8 9 10 11 12\n", "cloud.csv");
    EXPECT_EQ(error.code, ErrorCode::UnsupportedDimension);
    EXPECT_EQ(error.message, "6 columns: choose the coordinates with --columns 1,2,3");
}

TEST(TableReader, AnyDimensionTakesThemAllWithAWarning) {
    ReadOptions options;
    options.as = ReadAs::PointsOfAnyDimension;
    const ReadCloud got = read("a b c d e\n1 2 3 4 5\n6 7 8 9 10\n", "c.txt", options);
    EXPECT_EQ(got.cloud.dimension, 5u);
    EXPECT_EQ(got.cloud.coordinates, (Numbers{1, 2, 3, 4, 5, 6, 7, 8, 9, 10}));
    ASSERT_EQ(got.warnings.size(), 1u);
    EXPECT_EQ(got.warnings[0],
              "Took all 5 columns as coordinates: points in R^5. If they are not, name the ones that are, such as "
              "--columns 1,2,3.");
    EXPECT_TRUE(read("1 2 3\n4 5 6\n", "c.txt", options).warnings.empty());
    EXPECT_EQ(read("x,y,z,w\n1,2,3,4\n5,6,7,8\n", "c.csv", options).cloud.dimension, 3u) << "by their names";
    options.columns = {5, 1, 2, 3};
    const ReadCloud four = read("1 2 3 4 5\n6 7 8 9 10\n", "c.txt", options);
    EXPECT_EQ(four.cloud.coordinates, (Numbers{5, 1, 2, 3, 10, 6, 7, 8}));
    options.columns = {1};
    EXPECT_EQ(failure("1 2 3\n", "c.txt", options).code, ErrorCode::InvalidOption);
}

TEST(TableReader, ColumnsAreTakenInTheirGivenOrder) {
    const ReadCloud got = read("name,a,b,c\nfirst,1,2,3\nsecond,4,5,6\n", "c.csv", {.columns = {4, 2}});
    EXPECT_EQ(got.cloud.dimension, 2u);
    EXPECT_EQ(got.cloud.coordinates, (Numbers{3, 1, 6, 4}));
    EXPECT_EQ(got.columns_in_file, 4u);
    EXPECT_TRUE(got.warnings.empty());
    // Without a header the first row is kept although its first field is a word.
    EXPECT_EQ(read("first,1,2,3\nsecond,4,5,6\n", "c.csv", {.columns = {2, 3, 4}}).cloud.size(), 2u);
}

TEST(TableReader, ColumnsThatCannotBe) {
    EXPECT_EQ(failure("1 2 3\n", "c.txt", {.columns = {1, 4}}).code, ErrorCode::InvalidOption);
    EXPECT_NE(failure("1 2 3\n", "c.txt", {.columns = {1, 4}}).message.find("column 4"), std::string::npos);
    for (const std::vector<std::uint32_t>& columns :
         std::vector<std::vector<std::uint32_t>>{{1}, {1, 2, 3, 4}, {0, 1}, {2, 2}}) {
        EXPECT_EQ(failure("1 2 3 4\n5 6 7 8\n", "c.txt", {.columns = columns}).code, ErrorCode::InvalidOption);
    }
}

TEST(TableReader, NamedCoordinatesAreFoundAndReported) {
    for (const char* text :
         {"r,X,Y,Z\n9,1,2,3\n9,4,5,6\n", "//R X Y Z\n9 1 2 3\n9 4 5 6\n", ",\"x\",\"y\",\"z\"\n9,1,2,3\n9,4,5,6\n"}) {
        const ReadCloud got = read(text, "c.csv");
        EXPECT_EQ(got.cloud.coordinates, (Numbers{1, 2, 3, 4, 5, 6})) << text;
        ASSERT_EQ(got.warnings.size(), 1u);
        EXPECT_EQ(got.warnings[0], "Took columns 2,3,4 of 4 as coordinates, by their names.");
    }
    EXPECT_EQ(read("id,x,y\n1,2,3\n4,5,6\n").cloud.coordinates, (Numbers{2, 3, 5, 6}));
}

TEST(TableReader, XyzFilesTakeTheirFirstThreeColumns) {
    const ReadCloud got = read("1 2 3 255 0 0\n4 5 6 255 0 0\n", "scan.xyz");
    EXPECT_EQ(got.cloud.coordinates, (Numbers{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(got.warnings, std::vector<std::string>{"Took columns 1,2,3 of 6 as coordinates."});
    EXPECT_EQ(got.columns_in_file, 6u);
    // Colors and normals are three columns more; fewer can be coordinates.
    const ReadCloud five = read("1 2 3 4 5\n6 7 8 9 0\n", "five.xyz");
    EXPECT_EQ(five.cloud.dimension, 3u);
    EXPECT_EQ(five.warnings, std::vector<std::string>{"Took columns 1,2,3 of 5 as coordinates. Take points of R^5 with "
                                                      "--columns 1,2,3,4,5."});
    const ReadCloud named = read("1 2 3 red\n4 5 6 blue\n", "named.xyz");
    EXPECT_EQ(named.warnings, std::vector<std::string>{"Took columns 1,2,3 of 4 as coordinates."});
}

TEST(TableReader, RaggedRowsNameTheLine) {
    const Error error = failure("# remark\n1 2 3\n4 5\n");
    EXPECT_EQ(error.code, ErrorCode::RaggedRows);
    EXPECT_EQ(error.message, "Line 3 has 2 columns, but line 2 has 3.");
    EXPECT_EQ(failure("1 2\n3 4 5\n").code, ErrorCode::RaggedRows);
}

TEST(TableReader, NumbersThatAreNoneNameTheLine) {
    for (const char* text :
         {"1 2\n3 nan\n", "1 2\n3 -inf\n", "1 2\nInfinity 4\n", "1 2\n3 NaN\n", "1 2\n3 1e999\n", "1 2\n3 1e151\n"}) {
        const Error error = failure(text);
        EXPECT_EQ(error.code, ErrorCode::NotANumber) << text;
        EXPECT_NE(error.message.find("Line 2 "), std::string::npos) << error.message;
    }
    EXPECT_EQ(failure("nan nan\n1 2\n").code, ErrorCode::NotANumber);
}

TEST(TableReader, MalformedFieldsNameTheLine) {
    for (const char* text : {"1 2\n3 four\n", "1,2\n3,\"4\"\n", "1 2\n3 0x10\n", "1 2\n3 4e\n", "1 2\n3 --4\n",
                             "1 2\n3 .\n", "1,2,3\n3,,4\n", "1 2\n3 1.2.3\n", "1 2\n3 nano\n"}) {
        const Error error = failure(text);
        EXPECT_EQ(error.code, ErrorCode::MalformedInput) << text;
        EXPECT_NE(error.message.find("Line 2 "), std::string::npos) << error.message;
    }
    // A decimal comma would read as another column.
    EXPECT_EQ(failure("1,5;2,5\n3,5;4,5\n").code, ErrorCode::MalformedInput);
}

TEST(TableReader, ALetterIsNoQuestionOfColumns) {
    const Error error = failure("Dear friend,\nhow are you today\n");
    EXPECT_EQ(error.code, ErrorCode::MalformedInput);
    EXPECT_EQ(error.message, "Line 2 has \"how\" where a number should be.");
}

TEST(TableReader, MessagesStayPrintableAndShort) {
    const Error error = failure("1 2\n3 \x01\xFF" + std::string(5000, 'a') + "\n");
    EXPECT_EQ(error.message, "Line 2 has \"??" + std::string(22, 'a') + "...\" where a number should be.");
}

TEST(TableReader, TooLittleIsAnError) {
    EXPECT_EQ(failure("").code, ErrorCode::EmptyInput);
    EXPECT_EQ(failure(" \n\r\n\t").code, ErrorCode::EmptyInput);
    EXPECT_EQ(failure("\xEF\xBB\xBF").code, ErrorCode::EmptyInput);
    EXPECT_EQ(failure("# only a remark\n").code, ErrorCode::EmptyInput);
    EXPECT_EQ(failure("x y z\n").code, ErrorCode::EmptyInput);
    EXPECT_EQ(failure("1 2 3\n").code, ErrorCode::TooFewPoints);
    EXPECT_EQ(failure("1 2\n1 2\n1.0 2e0\n").code, ErrorCode::TooFewPoints);
    EXPECT_NE(failure("1 2\n1 2\n1 2\n").message.find("All 3 points"), std::string::npos);
    EXPECT_EQ(failure("1\n2\n").code, ErrorCode::UnsupportedDimension);
    EXPECT_EQ(failure("1 " + std::string(10'000, '1') + "\n2 3 4").code, ErrorCode::NotANumber);
    std::string wide = "1";
    for (int k = 0; k < 5000; ++k) wide += " 1";
    EXPECT_EQ(failure(wide).code, ErrorCode::MalformedInput);
}

TEST(TableReader, SlicesGiveTheSameCloud) {
    std::string text;
    for (int k = 0; k < 5000; ++k) text += std::to_string(k) + " " + std::to_string(k * k % 997) + "\n";
    CloudReader reader(text, "a.txt", {});
    int slices = 1;
    while (!reader.advance(0)) ++slices;
    EXPECT_GT(slices, 10);
    auto sliced = reader.take();
    ASSERT_TRUE(sliced);
    EXPECT_EQ(sliced.value().cloud.size(), 5000u);
    EXPECT_EQ(sliced.value().cloud.coordinates, read(text).cloud.coordinates);
    // take() without advance() reads all.
    EXPECT_EQ(CloudReader(text, "a.txt", {}).take().value().cloud.size(), 5000u);
}

TEST(TableReader, AdvanceAfterAnErrorIsDone) {
    CloudReader reader("1 2\nx\n", "a.txt", {});
    while (!reader.advance(0)) {
    }
    EXPECT_TRUE(reader.advance(10));
    EXPECT_EQ(reader.take().error().code, ErrorCode::RaggedRows);
}

}  // namespace
}  // namespace plateau
