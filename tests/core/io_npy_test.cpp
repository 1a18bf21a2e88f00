#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "cloud_files.h"
#include "io/cloud_reader.h"

namespace plateau {
namespace {

using namespace std::string_literals;

using Numbers = std::vector<double>;

std::string dictionary(const std::string& type, const std::string& shape, const char* fortran_order = "False") {
    return "{'descr': '" + type + "', 'fortran_order': " + fortran_order + ", 'shape': " + shape + ", }";
}

template <class T>
std::string values(const std::vector<T>& numbers, bool big_endian = false) {
    std::string bytes;
    for (const T number : numbers) bytes += packed(number, big_endian);
    return bytes;
}

const std::string kSix = values<double>({1, 2, 3, 4, 5, 6});

ReadCloud read(const std::string& bytes, const ReadOptions& options = {}) {
    auto result = read_cloud(bytes, "a.npy", options);
    if (!result) {
        ADD_FAILURE() << result.error().message;
        return {};
    }
    return std::move(result).value();
}

Error failure(const std::string& bytes, const ReadOptions& options = {}) {
    auto result = read_cloud(bytes, "a.npy", options);
    if (result) {
        ADD_FAILURE() << "no error in " << bytes;
        return {};
    }
    return result.error();
}

TEST(NpyReader, VersionsOrdersAndShapes) {
    for (const int version : {1, 2, 3}) {
        const ReadCloud space = read(npy_file(version, dictionary("<f8", "(2, 3)"), kSix));
        EXPECT_EQ(space.cloud.dimension, 3u);
        EXPECT_EQ(space.cloud.coordinates, (Numbers{1, 2, 3, 4, 5, 6}));
        EXPECT_EQ(space.columns_in_file, 3u);
        EXPECT_TRUE(space.warnings.empty());
        EXPECT_EQ(read(npy_file(version, dictionary("<f8", "(2, 3)", "True"), kSix)).cloud.coordinates,
                  (Numbers{1, 3, 5, 2, 4, 6}));
        const ReadCloud plane = read(npy_file(version, dictionary("<f8", "(3, 2)"), kSix));
        EXPECT_EQ(plane.cloud.dimension, 2u);
        EXPECT_EQ(plane.cloud.coordinates, (Numbers{1, 2, 3, 4, 5, 6}));
        EXPECT_EQ(read(npy_file(version, dictionary("<f8", "(3, 2)", "True"), kSix)).cloud.coordinates,
                  (Numbers{1, 4, 2, 5, 3, 6}));
    }
    const std::string bytes = npy_file(1, dictionary("<f8", "(2, 3)"), kSix);
    for (const char* name : {"-", "a.xyz", "a.csv", "a.ply", "a.dat"}) {
        const auto result = read_cloud(bytes, name, {});
        ASSERT_TRUE(result) << name << ": " << result.error().message;
        EXPECT_EQ(result.value().cloud.coordinates, (Numbers{1, 2, 3, 4, 5, 6})) << name;
    }
}

TEST(NpyReader, EveryTypeOfNumber) {
    const auto check = [](const std::string& type, auto low, auto high) {
        using T = decltype(low);
        for (const bool big : {false, true}) {
            const std::string order = sizeof low == 1 ? "|" : big ? ">" : "<";
            EXPECT_EQ(read(npy_file(1, dictionary(order + type, "(2, 2)"), values<T>({low, 0, 0, high}, big)))
                          .cloud.coordinates,
                      (Numbers{static_cast<double>(low), 0, 0, static_cast<double>(high)}))
                << type;
        }
    };
    check("i1", std::int8_t{-128}, std::int8_t{127});
    check("u1", std::uint8_t{1}, std::uint8_t{255});
    check("i2", std::int16_t{-32768}, std::int16_t{32767});
    check("u2", std::uint16_t{1}, std::uint16_t{65535});
    check("i4", std::int32_t{-2147483647}, std::int32_t{2147483647});
    check("u4", std::uint32_t{1}, std::uint32_t{4294967295});
    check("i8", std::int64_t{-9007199254740993}, std::int64_t{9007199254740993});
    check("u8", std::uint64_t{1}, std::numeric_limits<std::uint64_t>::max());
    check("f4", -0.1f, 3e38f);
    check("f8", -0.1, 1e150);
}

TEST(NpyReader, HeadersThatMeanTheSame) {
    for (const std::string& text : {"{\"descr\": \"<f8\", \"fortran_order\": False, \"shape\": (2, 3)}"s,
                                    "{'shape':(2,3),'fortran_order':False,'descr':'<f8'}"s,
                                    "{ 'descr' : '=f8' , 'fortran_order' : False , 'shape' : ( 2 , 3 , ) , }"s,
                                    "{'descr': '<f8', 'fortran_order': False, 'shape': (2L, 3L), }"s}) {
        EXPECT_EQ(read(npy_file(1, text, kSix)).cloud.coordinates, (Numbers{1, 2, 3, 4, 5, 6})) << text;
    }
}

TEST(NpyReader, MoreColumnsAskForAChoice) {
    for (const char* order : {"False", "True"}) {
        const std::string bytes = npy_file(1, dictionary("|u1", "(2, 4)", order),
                                           order == "True"s ? "\1\5\2\6\3\7\4\10" : "\1\2\3\4\5\6\7\10");
        const Error error = failure(bytes);
        EXPECT_EQ(error.code, ErrorCode::UnsupportedDimension);
        EXPECT_EQ(error.message, "4 columns: choose the coordinates with --columns 1,2,3");
        const ReadCloud got = read(bytes, {.columns = {4, 2}});
        EXPECT_EQ(got.cloud.coordinates, (Numbers{4, 2, 8, 6}));
        EXPECT_EQ(got.columns_in_file, 4u);
        EXPECT_EQ(failure(bytes, {.columns = {1, 2, 5}}).code, ErrorCode::InvalidOption);
    }
}

TEST(NpyReader, AnyDimensionTakesAllColumns) {
    ReadOptions options;
    options.as = ReadAs::PointsOfAnyDimension;
    const ReadCloud got = read(npy_file(1, dictionary("|u1", "(2, 4)"), "\1\2\3\4\5\6\7\10"), options);
    EXPECT_EQ(got.cloud.dimension, 4u);
    EXPECT_EQ(got.cloud.coordinates, (Numbers{1, 2, 3, 4, 5, 6, 7, 8}));
    EXPECT_EQ(got.warnings.size(), 1u);
}

TEST(NpyReader, ASecondArrayIsLeftOutWithAWarning) {
    const std::string one = npy_file(1, dictionary("<f8", "(2, 3)"), kSix);
    const ReadCloud got = read(one + one);
    EXPECT_EQ(got.cloud.size(), 2u);
    EXPECT_EQ(got.warnings,
              std::vector<std::string>{"Took the first array of this NumPy file; what follows it was left out."});
}

TEST(NpyReader, Errors) {
    const auto expect = [](const std::string& bytes, ErrorCode code, const std::string& part) {
        const Error error = failure(bytes);
        EXPECT_EQ(error.code, code) << error.message;
        EXPECT_NE(error.message.find(part), std::string::npos) << error.message;
    };
    const auto malformed = [&](const std::string& bytes, const std::string& part) {
        expect(bytes, ErrorCode::MalformedInput, part);
    };
    const std::string good = npy_file(1, dictionary("<f8", "(2, 3)"), kSix);
    malformed("1 2 3\n4 5 6\n", "no NumPy array");
    for (const std::size_t size : {6u, 7u, 8u, 9u, 10u, 40u}) malformed(good.substr(0, size), "within its header");
    malformed(good.substr(0, good.size() - 1), "(2, 3) values, but only 5");
    malformed("\x93NUMPY\x04\0"s + good.substr(8), "version 4");
    for (const std::string& text :
         {""s, "{}"s, "{'descr': '<f8'}"s, "{'descr': '<f8', 'fortran_order': 0, 'shape': (2, 3)}"s,
          "{'descr': '<f8', 'fortran_order': False, 'shape': (2 3)}"s,
          "{'descr': '<f8', 'fortran_order': False, 'shape': (-2, 3)}"s,
          "{'descr': '<f8', 'fortran_order': False, 'shape': (99999999999999999999, 3)}"s,
          "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3), 'more': 1}"s,
          "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3)} x"s, "{'descr': '<f8"s}) {
        malformed(npy_file(1, text, kSix), "not understood");
    }
    for (const char* type : {"<f2", "<c16", "|b1", "|O", "<U3", "f8", ""}) {
        expect(npy_file(1, dictionary(type, "(2, 3)"), kSix), ErrorCode::UnknownFormat, "values of type");
    }
    expect(npy_file(1, "{'descr': [('x', '<f4')], 'fortran_order': False, 'shape': (2,)}", kSix),
           ErrorCode::UnknownFormat, "named fields");
    malformed(npy_file(1, dictionary("<f8", "()"), kSix), "shape ();");
    malformed(npy_file(1, dictionary("<f8", "(6,)"), kSix), "shape (6,);");
    malformed(npy_file(1, dictionary("<f8", "(1, 2, 3)"), kSix), "shape (1, 2, 3);");
    malformed(npy_file(1, dictionary("<f8", "(6, 1)"), kSix), "two or three columns");
    malformed(npy_file(1, dictionary("<f8", "(6, 0)"), kSix), "two or three columns");
    malformed(npy_file(1, dictionary("<f8", "(18446744073709551615, 3)"), kSix), "but only 6");
    expect(npy_file(1, dictionary("<f8", "(0, 3)"), ""), ErrorCode::EmptyInput, "no points");
    expect(npy_file(1, dictionary("<f8", "(1, 3)"), kSix), ErrorCode::TooFewPoints, "one point");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    expect(npy_file(1, dictionary("<f8", "(2, 2)"), values<double>({1, 2, 3, nan})), ErrorCode::NotANumber, "Row 2");
}

TEST(NpyReader, SlicesGiveTheSameCloud) {
    const std::vector<double> points = scattered_points(5000);
    for (const CloudFormat& format : cloud_formats()) {
        if (format.extension != "npy"s) continue;
        CloudReader reader(format.write(points), "a.npy", {});
        int slices = 1;
        while (!reader.advance(0)) ++slices;
        EXPECT_GT(slices, 10) << format.name;
        EXPECT_EQ(reader.take().value().cloud.coordinates, points) << format.name;
    }
}

}  // namespace
}  // namespace plateau
