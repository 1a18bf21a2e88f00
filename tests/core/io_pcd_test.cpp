#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "cloud_files.h"
#include "io/cloud_reader.h"
#include "io/lzf.h"

namespace plateau {
namespace {

using namespace std::string_literals;

using Numbers = std::vector<double>;
const Numbers kTwoPoints = {1, -2, 3, 4, 5, 6};

ReadCloud read(const std::string& bytes, const ReadOptions& options = {}) {
    auto result = read_cloud(bytes, "a.pcd", options);
    if (!result) {
        ADD_FAILURE() << result.error().message;
        return {};
    }
    return std::move(result).value();
}

Error failure(const std::string& bytes) {
    auto result = read_cloud(bytes, "a.pcd", {});
    if (result) {
        ADD_FAILURE() << "no error in " << bytes;
        return {};
    }
    return result.error();
}

/// A header for so many points in one row; `fields` holds the lines FIELDS, SIZE, TYPE and COUNT.
std::string header(const std::string& fields, int points, const std::string& data) {
    const std::string count = std::to_string(points);
    return "# .PCD v0.7\nVERSION 0.7\n" + fields + "WIDTH " + count + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " +
           count + "\nDATA " + data + "\n";
}

const std::string kXyz = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n";

std::string compressed_block(const std::string& values) {
    const std::string data = lzf_compressed(values);
    return packed(static_cast<std::uint32_t>(data.size()), false) +
           packed(static_cast<std::uint32_t>(values.size()), false) + data;
}

TEST(PcdReader, AsciiOfEveryLineEnd) {
    const std::string text = header(kXyz, 2, "ascii") + "1 -2 3\n\n4 5 6\n";
    for (const std::string end : {"\n", "\r\n", "\r"}) {
        std::string bytes;
        for (const char c : text) bytes += c == '\n' ? end : std::string(1, c);
        EXPECT_EQ(read(bytes).cloud.coordinates, kTwoPoints);
    }
    for (const char* name : {"-", "a.txt", "a.ply", "a.dat"}) {
        EXPECT_EQ(read_cloud(text, name, {}).value().cloud.coordinates, kTwoPoints) << name;
    }
}

TEST(PcdReader, HeadersThatSomeProgramsWrite) {
    const std::string rows = "1 -2 3\n4 5 6\n";
    for (const std::string& text :
         {"VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 2\nHEIGHT 1\nPOINTS 2\nDATA ascii\n"s,
          "# remark\n\nVERSION 0.6\nFIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nCOUNT 1 1 1\nPOINTS 2\nDATA ascii\n"s,
          "VERSION .5\nCOLUMNS x y z\nSIZE 4 2 1\nTYPE F I I\nWIDTH 1\nHEIGHT 2\nDATA ascii\n"s}) {
        EXPECT_EQ(read(text + rows).cloud.coordinates, kTwoPoints) << text;
        EXPECT_EQ(read_cloud(text + rows, "-", {}).value().cloud.coordinates, kTwoPoints) << text;
    }
}

TEST(PcdReader, FieldsOfAnyOrderTypeAndCount) {
    const std::string fields = "FIELDS rgb y histogram x _ z\nSIZE 4 2 1 8 1 4\nTYPE U I U F U F\nCOUNT 1 1 3 1 2 1\n";
    const auto columns = [](int which, int k) -> std::string {
        const double x[] = {1, 4};
        const std::int16_t y[] = {-2, 5};
        const float z[] = {3, 6};
        switch (which) {
            case 0:
                return "\x7F\0\xFF\0"s;
            case 1:
                return packed(y[k], false);
            case 2:
                return "\x09\x08\x07"s;
            case 3:
                return packed(x[k], false);
            case 4:
                return "\n\n"s;
            default:
                return packed(z[k], false);
        }
    };
    std::string by_rows;
    for (int k = 0; k < 2; ++k) {
        for (int field = 0; field < 6; ++field) by_rows += columns(field, k);
    }
    std::string by_fields;
    for (int field = 0; field < 6; ++field) {
        for (int k = 0; k < 2; ++k) by_fields += columns(field, k);
    }
    const std::string files[] = {
        header(fields, 2, "ascii") + "255 -2 9 8 7 1 0 0 3\n255 5 9 8 7 4 0 0 6\n",
        header(fields, 2, "binary") + by_rows,
        header(fields, 2, "binary_compressed") + compressed_block(by_fields),
    };
    for (const std::string& bytes : files) {
        const ReadCloud got = read(bytes);
        EXPECT_EQ(got.cloud.coordinates, kTwoPoints);
        EXPECT_EQ(got.columns_in_file, 9u);
        EXPECT_TRUE(got.warnings.empty());
        // Columns are values: the histogram takes three.
        EXPECT_EQ(read(bytes, {.columns = {6, 4, 2}}).cloud.coordinates, (Numbers{1, 8, -2, 4, 8, 5}));
    }
}

TEST(PcdReader, PlaneWithoutZ) {
    const ReadCloud got = read(header("FIELDS y x\nSIZE 4 4\nTYPE F F\nCOUNT 1 1\n", 2, "ascii") + "1 2\n3 4\n");
    EXPECT_EQ(got.cloud.dimension, 2u);
    EXPECT_EQ(got.cloud.coordinates, (Numbers{2, 1, 4, 3}));
}

TEST(PcdReader, EveryTypeOfNumber) {
    const auto check = [](const std::string& type, auto low, auto high) {
        const std::string size = std::to_string(sizeof low);
        const std::string fields = "FIELDS x y\nSIZE " + size + " " + size + "\nTYPE " + type + " " + type + "\n";
        const std::string zero = packed(decltype(low){}, false);
        const std::string lowest = packed(low, false);
        const std::string highest = packed(high, false);
        const Numbers expected = {static_cast<double>(low), 0, 0, static_cast<double>(high)};
        EXPECT_EQ(read(header(fields, 2, "binary") + lowest + zero + zero + highest).cloud.coordinates, expected);
        EXPECT_EQ(read(header(fields, 2, "binary_compressed") + compressed_block(lowest + zero + zero + highest))
                      .cloud.coordinates,
                  expected);
    };
    check("I", std::int8_t{-128}, std::int8_t{127});
    check("U", std::uint8_t{1}, std::uint8_t{255});
    check("I", std::int16_t{-32768}, std::int16_t{32767});
    check("U", std::uint16_t{1}, std::uint16_t{65535});
    check("I", std::int32_t{-2147483647}, std::int32_t{2147483647});
    check("U", std::uint32_t{1}, std::uint32_t{4294967295});
    check("I", std::int64_t{-9007199254740993}, std::int64_t{9007199254740993});
    check("U", std::uint64_t{1}, std::numeric_limits<std::uint64_t>::max());
    check("F", -0.1f, 3e38f);
    check("F", -0.1, 1e150);
}

TEST(PcdReader, PointsWithoutCoordinatesAreLeftOutAndCounted) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<float> values = {1, -2, 3, nan, nan, nan, 4, 5, 6, -nan, 0, 0};
    std::string rows;
    for (const float value : values) rows += packed(value, false);
    std::string columns;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t k = axis; k < values.size(); k += 3) columns += packed(values[k], false);
    }
    std::string organized = header(kXyz, 4, "ascii");
    organized.replace(organized.find("WIDTH 4\nHEIGHT 1"), 16, "WIDTH 2\nHEIGHT 2");
    const std::string files[] = {organized + "1 -2 3\nnan nan nan\n4 5 6\n-NaN 0 0\n", header(kXyz, 4, "binary") + rows,
                                 header(kXyz, 4, "binary_compressed") + compressed_block(columns)};
    for (const std::string& bytes : files) {
        const ReadCloud got = read(bytes);
        EXPECT_EQ(got.cloud.coordinates, kTwoPoints);
        EXPECT_EQ(got.warnings, std::vector<std::string>{"Left out 2 of 4 points, which have no coordinates (NaN)."});
    }
    // Only what is asked for counts.
    EXPECT_EQ(read(files[0], {.columns = {2, 3}}).cloud.coordinates, (Numbers{-2, 3, 5, 6, 0, 0}));
    const Error error = failure(header(kXyz, 2, "ascii") + "nan nan nan\nnan 1 1\n");
    EXPECT_EQ(error.code, ErrorCode::EmptyInput);
    EXPECT_EQ(error.message, "None of the 2 points of this PCD file has coordinates.");
}

TEST(PcdReader, WhatFollowsTheLastPointIsLeftOutWithAWarning) {
    const std::string two = packed(1.f, false) + packed(-2.f, false) + packed(3.f, false) + packed(4.f, false) +
                            packed(5.f, false) + packed(6.f, false);
    for (const std::string& bytes : {header(kXyz, 2, "ascii") + "1 -2 3\n4 5 6\n", header(kXyz, 2, "binary") + two}) {
        EXPECT_TRUE(read(bytes + "\n\n").warnings.empty());
        const ReadCloud got = read(bytes + "7 8 9\n");
        EXPECT_EQ(got.cloud.coordinates, kTwoPoints);
        EXPECT_EQ(got.warnings,
                  std::vector<std::string>{"The PCD header promises 2 points; what follows them was left out."});
    }
}

TEST(PcdReader, Errors) {
    const auto expect = [](const std::string& bytes, ErrorCode code, const std::string& part) {
        const Error error = failure(bytes);
        EXPECT_EQ(error.code, code) << error.message;
        EXPECT_NE(error.message.find(part), std::string::npos) << error.message;
    };
    const auto malformed = [&](const std::string& bytes, const std::string& part) {
        expect(bytes, ErrorCode::MalformedInput, part);
    };
    const auto changed = [](std::string text, const std::string& from, const std::string& to) {
        return text.replace(text.find(from), from.size(), to);
    };
    const std::string good = header(kXyz, 2, "ascii") + "1 2 3\n4 5 6\n";
    malformed("1 2 3\n4 5 6\n", "Line 1");
    malformed("# .PCD v0.7\nVERSION 0.7\n", "no line DATA");
    malformed(changed(good, "VERSION 0.7", "VERSION 0.9"), "Line 2");
    malformed(changed(good, "DATA ascii", "DATA base64"), "Line 11");
    malformed(changed(good, "POINTS 2", "POINTS -2"), "Line 10");
    malformed(changed(good, "POINTS 2", "NONSENSE 2"), "NONSENSE");
    malformed(changed(good, "FIELDS x y z", "FIELDS"), "FIELDS");
    malformed(changed(good, "SIZE 4 4 4", "SIZE 4 4"), "one SIZE");
    malformed(changed(good, "TYPE F F F", "TYPE F F"), "one SIZE");
    malformed(changed(good, "COUNT 1 1 1", "COUNT 1 1"), "one SIZE");
    malformed(changed(good, "COUNT 1 1 1", "COUNT 1 1 5000"), "4096");
    malformed(changed(good, "COUNT 1 1 1", "COUNT 18446744073709551615 1 2"), "4096");
    malformed(changed(good, "SIZE 4 4 4", "SIZE 4 4 2"), "\"F\" of SIZE 2");
    malformed(changed(good, "TYPE F F F", "TYPE F F C"), "\"z\"");
    malformed(changed(good, "FIELDS x y z", "FIELDS a b c"), "x and y");
    malformed(changed(good, "COUNT 1 1 1", "COUNT 1 0 1"), "x and y");
    malformed(changed(good, "HEIGHT 1", "HEIGHT 2"), "WIDTH 2 times HEIGHT 2 is not POINTS 2");
    malformed(changed(changed(good, "WIDTH 2", "WIDTH 4294967296"), "HEIGHT 1", "HEIGHT 4294967296"), "contradicts");
    malformed(changed(changed(good, "WIDTH 2\n", ""), "POINTS 2\n", ""), "how many");
    malformed(header(kXyz, 3, "ascii") + "1 2 3\n4 5 6\n", "after 2");
    malformed(header(kXyz, 3, "binary") + std::string(35, 'x'), "after 2");
    malformed(header(kXyz, 2, "ascii") + "1 2 3\n4 five 6\n", "Line 13 has \"five\"");
    expect(header(kXyz, 2, "ascii") + "1 2 3\n4 5\n", ErrorCode::RaggedRows, "Line 13");
    expect(header(kXyz, 2, "ascii") + "1 2 3\n4 5 inf\n", ErrorCode::NotANumber, "Line 13");
    expect(header(kXyz, 1, "ascii") + "1 2 3\n", ErrorCode::TooFewPoints, "one point");
    expect(header(kXyz, 0, "ascii"), ErrorCode::EmptyInput, "no points");
    const std::string infinite = packed(std::numeric_limits<float>::infinity(), false);
    expect(header(kXyz, 2, "binary") + std::string(12, '\0') + infinite + std::string(8, '\0'), ErrorCode::NotANumber,
           "Point 2");
    const std::string compressed = header(kXyz, 2, "binary_compressed");
    const auto word = [](std::uint32_t value) { return packed(value, false); };
    malformed(compressed + "abc", "after 0");
    malformed(compressed + word(100) + word(24) + "abc", "100 bytes, but only 3");
    malformed(compressed + word(3) + word(23) + "abc", "hold 23 bytes");
    malformed(compressed + word(3) + word(24) + "\x01" + "bc", "damaged");
    // A bomb: refused before memory is asked for.
    malformed(header(kXyz, 300000000, "binary_compressed") + word(3) + word(3600000000u) + "abc", "damaged");
}

TEST(PcdReader, SlicesGiveTheSameCloud) {
    const std::vector<double> points = scattered_points(20000);
    for (const CloudFormat& format : cloud_formats()) {
        if (format.extension != "pcd"s) continue;
        const std::string bytes = format.write(points);
        CloudReader reader(bytes, "a.pcd", {});
        int slices = 1;
        while (!reader.advance(0)) ++slices;
        EXPECT_GT(slices, 70) << format.name;
        EXPECT_EQ(reader.take().value().cloud.coordinates, points) << format.name;
    }
}

/// All of the data in slices of three bytes; nothing if they are broken.
std::string expanded(const std::string& data, std::size_t size) {
    LzfDecoder decoder(data, size);
    while (true) {
        const auto status = decoder.advance(3);
        if (status != LzfDecoder::Status::More) {
            return status == LzfDecoder::Status::Done ? decoder.output() : "broken";
        }
    }
}

TEST(Lzf, TokensByHand) {
    EXPECT_EQ(expanded("", 0), "");
    EXPECT_EQ(expanded("\x02"s + "abc", 3), "abc");
    // A copy of length 4 from distance 2 reaches into what it writes.
    EXPECT_EQ(expanded("\x01"s + "ab" + "\x40\x01", 6), "ababab");
    // A long copy: 7 + 255 + 2 times the byte before, the most that one token makes.
    EXPECT_EQ(expanded("\0a\xE0\xFF\0"s, 265), std::string(265, 'a'));
    for (const std::string& broken : {""s, "\x05"s + "abc", "\x20\0"s, "\0a\x20"s, "\0a\xE0"s, "\0a\xE0\x01"s,
                                      "\0a\x20\x01"s, "\x04"s + "abcde", "\x02"s + "abcd"}) {
        EXPECT_EQ(expanded(broken, 3), "broken");
    }
}

TEST(Lzf, WhatWasCompressedComesBack) {
    std::string text;
    std::uint32_t state = 1;
    for (int k = 0; k < 30000; ++k) {
        state = state * 1664525u + 1013904223u;
        if (state >> 29 == 0) {
            text.append(state >> 22 & 1023, static_cast<char>(state >> 8));
        } else {
            text += static_cast<char>(state >> 24 & (k < 20000 ? 3 : 255));
        }
        if (text.size() > 100000) break;
    }
    const std::string data = lzf_compressed(text);
    EXPECT_LT(data.size(), text.size());
    EXPECT_EQ(expanded(data, text.size()), text);
    EXPECT_EQ(expanded(data, text.size() - 1), "broken");
    EXPECT_EQ(expanded(data, text.size() + 1), "broken");
}

}  // namespace
}  // namespace plateau
