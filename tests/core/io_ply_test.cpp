#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "cloud_files.h"
#include "io/cloud_reader.h"

namespace plateau {
namespace {

using Numbers = std::vector<double>;
const Numbers kTwoPoints = {1, -2, 3, 4, 5, 6};

ReadCloud read(const std::string& bytes, const ReadOptions& options = {}) {
    auto result = read_cloud(bytes, "a.ply", options);
    if (!result) {
        ADD_FAILURE() << result.error().message;
        return {};
    }
    return std::move(result).value();
}

Error failure(const std::string& bytes) {
    auto result = read_cloud(bytes, "a.ply", {});
    if (result) {
        ADD_FAILURE() << "no error in " << bytes;
        return {};
    }
    return result.error();
}

TEST(PlyReader, Ascii) {
    const std::string body =
        "comment remark\nobj_info remark\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n1 -2 3\n4 5 6\n3 0 1 0\n";
    EXPECT_EQ(read("ply\nformat ascii 1.0\n" + body).cloud.coordinates, kTwoPoints);
    std::string windows;
    for (const char c : "ply\nformat ascii 1.0\n" + body) windows += c == '\n' ? "\r\n" : std::string(1, c);
    EXPECT_EQ(read(windows).cloud.coordinates, kTwoPoints);
    // The name does not matter.
    EXPECT_EQ(read_cloud("ply\nformat ascii 1.0\n" + body, "-", {}).value().cloud.coordinates, kTwoPoints);
    EXPECT_EQ(read_cloud("ply\nformat ascii 1.0\n" + body, "a.txt", {}).value().cloud.coordinates, kTwoPoints);
}

TEST(PlyReader, AsciiWithForeignElementsListsAndOrder) {
    const ReadCloud got = read(
        "ply\nformat ascii 1.0\nelement camera 1\nproperty float fov\nproperty list uchar float view\n"
        "element nothing 4000000000\nelement vertex 2\nproperty uchar red\nproperty double z\n"
        "property list uchar int neighbors\nproperty double x\nproperty double y\nend_header\n"
        "90 2 0.5 0.5\n\n255 3 0 1 -2\n0 6 2 0 1 4 5\n");
    EXPECT_EQ(got.cloud.coordinates, kTwoPoints);
    EXPECT_EQ(got.columns_in_file, 4u);
    EXPECT_TRUE(got.warnings.empty());
}

TEST(PlyReader, BinaryOfBothOrders) {
    for (const bool big : {false, true}) {
        const std::string format = big ? "binary_big_endian" : "binary_little_endian";
        for (const std::string end : {"\n", "\r\n", "\r"}) {
            std::string bytes =
                "ply" + end + "format " + format + " 1.0" + end + "element face 2" + end +
                "property list uchar int vertex_indices" + end + "element skipped 3" + end + "property short a" + end +
                "property double b" + end + "element vertex 2" + end + "property short y" + end + "property double x" +
                end + "property list ushort double extra" + end + "property float z" + end + "end_header" + end;
            // The first data byte is \n: it must not be taken for a part of the header's last line end.
            bytes += packed<std::uint8_t>(10, big) + std::string(40, '\n') + packed<std::uint8_t>(0, big);
            bytes += std::string(30, 'x');
            bytes += packed<std::int16_t>(-2, big) + packed(1.0, big) + packed<std::uint16_t>(1, big) +
                     packed(9.0, big) + packed(3.0f, big);
            bytes +=
                packed<std::int16_t>(5, big) + packed(4.0, big) + packed<std::uint16_t>(0, big) + packed(6.0f, big);
            EXPECT_EQ(read(bytes).cloud.coordinates, kTwoPoints);
        }
    }
}

TEST(PlyReader, EveryTypeOfNumber) {
    for (const bool big : {false, true}) {
        const auto cloud_of = [&](const std::string& type, const std::string& first, const std::string& second) {
            const std::string format = big ? "binary_big_endian" : "binary_little_endian";
            const std::string zero(first.size(), '\0');
            return read("ply\nformat " + format + " 1.0\nelement vertex 2\nproperty " + type + " x\nproperty " + type +
                        " y\nend_header\n" + first + zero + zero + second)
                .cloud;
        };
        const auto check = [&](const std::string& type, auto low, auto high) {
            const PointCloud cloud = cloud_of(type, packed(low, big), packed(high, big));
            EXPECT_EQ(cloud.dimension, 2u);
            EXPECT_EQ(cloud.coordinates, (Numbers{static_cast<double>(low), 0, 0, static_cast<double>(high)})) << type;
        };
        for (const char* name : {"char", "int8"}) check(name, std::int8_t{-128}, std::int8_t{127});
        for (const char* name : {"uchar", "uint8"}) check(name, std::uint8_t{1}, std::uint8_t{255});
        for (const char* name : {"short", "int16"}) check(name, std::int16_t{-32768}, std::int16_t{32767});
        for (const char* name : {"ushort", "uint16"}) check(name, std::uint16_t{1}, std::uint16_t{65535});
        for (const char* name : {"int", "int32"}) check(name, std::int32_t{-2147483647}, std::int32_t{2147483647});
        for (const char* name : {"uint", "uint32"}) check(name, std::uint32_t{1}, std::uint32_t{4294967295});
        for (const char* name : {"float", "float32"}) check(name, -0.1f, 3e38f);
        for (const char* name : {"double", "float64"}) check(name, -0.1, 1e150);
    }
}

TEST(PlyReader, ColumnsAreVertexProperties) {
    const ReadCloud got = read_cloud(
                              "ply\nformat ascii 1.0\nelement vertex 2\nproperty float u\nproperty float v\n"
                              "end_header\n1 2\n3 4\n",
                              "a.ply", {.columns = {2, 1}})
                              .value();
    EXPECT_EQ(got.cloud.coordinates, (Numbers{2, 1, 4, 3}));
}

TEST(PlyReader, Errors) {
    const std::string start = "ply\nformat ascii 1.0\n";
    const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
    const auto expect = [&](const std::string& bytes, ErrorCode code, const std::string& part) {
        const Error error = failure(bytes);
        EXPECT_EQ(error.code, code) << error.message;
        EXPECT_NE(error.message.find(part), std::string::npos) << error.message;
    };
    expect("1 2 3\n4 5 6\n", ErrorCode::MalformedInput, "Line 1");
    expect("ply\n", ErrorCode::MalformedInput, "end_header");
    expect("ply\nend_header\n", ErrorCode::MalformedInput, "format");
    expect("ply\nformat ascii 2.0\nend_header\n", ErrorCode::MalformedInput, "Line 2");
    expect(start + "element vertex -1\nend_header\n", ErrorCode::MalformedInput, "Line 3");
    expect(start + "property float x\nend_header\n", ErrorCode::MalformedInput, "Line 3");
    expect(start + "element vertex 2\nproperty quad x\nend_header\n", ErrorCode::MalformedInput, "Line 4");
    expect(start + "element vertex 2\nproperty list float int x\nend_header\n", ErrorCode::MalformedInput, "Line 4");
    expect(start + "nonsense\nend_header\n", ErrorCode::MalformedInput, "nonsense");
    expect(start + "element face 0\nend_header\n", ErrorCode::MalformedInput, "no element vertex");
    expect(start + "element vertex 1\nproperty float a\nend_header\n1\n", ErrorCode::MalformedInput, "x and y");
    expect(start + "element vertex 0\n" + xyz + "end_header\n", ErrorCode::EmptyInput, "no points");
    expect(start + "element vertex 3\n" + xyz + "end_header\n1 2 3\n4 5 6\n", ErrorCode::MalformedInput, "after 2");
    expect(start + "element vertex 2\n" + xyz + "end_header\n1 2 3\n4 5\n", ErrorCode::RaggedRows, "Line 9");
    expect(start + "element vertex 2\n" + xyz + "end_header\n1 2 3\n4 5 6 7\n", ErrorCode::RaggedRows, "Line 9");
    expect(start + "element vertex 2\n" + xyz + "end_header\n1 2 3\n4 nan 6\n", ErrorCode::NotANumber, "Line 9");
    const std::string binary = "ply\nformat binary_little_endian 1.0\n";
    expect(binary + "element vertex 18446744073709551615\n" + xyz + "end_header\n" + std::string(30, 'x'),
           ErrorCode::MalformedInput, "after 2");
    expect(binary + "element face 9000000000000000000\nproperty double a\nelement vertex 1\n" + xyz + "end_header\n",
           ErrorCode::MalformedInput, "face");
    expect(
        binary + "element vertex 1\n" + xyz + "property list char int a\nend_header\n" + std::string(12, '\0') + "\xFF",
        ErrorCode::MalformedInput, "negative");
    expect(binary + "element vertex 1\n" + xyz + "property list uint double a\nend_header\n" + std::string(12, '\0') +
               std::string(20, '\x7F'),
           ErrorCode::MalformedInput, "ends after");
    const std::string nan = packed(std::numeric_limits<float>::quiet_NaN(), false);
    expect(binary + "element vertex 2\n" + xyz + "end_header\n" + std::string(12, '\0') + nan + std::string(8, '\0'),
           ErrorCode::NotANumber, "Vertex 2");
}

TEST(PlyReader, SlicesGiveTheSameCloud) {
    std::string bytes =
        "ply\nformat binary_little_endian 1.0\nelement vertex 5000\nproperty float x\nproperty float y\nend_header\n";
    for (int k = 0; k < 5000; ++k) bytes += packed(static_cast<float>(k), false) + packed(0.5f, false);
    CloudReader reader(bytes, "a.ply", {});
    int slices = 1;
    while (!reader.advance(0)) ++slices;
    EXPECT_GT(slices, 10);
    EXPECT_EQ(reader.take().value().cloud.coordinates, read(bytes).cloud.coordinates);
}

}  // namespace
}  // namespace plateau
