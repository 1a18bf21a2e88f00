#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/cloud_reader.h"

namespace plateau {
namespace {

using Numbers = std::vector<double>;
const Numbers kTwoPoints = {1, 2, 3, 4, 5, 6};

Error failure(const std::string& text, std::string_view name) {
    auto result = read_cloud(text, name, {});
    if (result) {
        ADD_FAILURE() << "no error in " << text;
        return {};
    }
    return result.error();
}

TEST(OffReader, HeadersOfEveryKind) {
    for (const char* text :
         {"OFF\n2 1 0\n1 2 3\n4 5 6\n2 0 1\n", "OFF 2 1 0\n1 2 3\n4 5 6\n", "OFF2 1 0\n1 2 3\n4 5 6\n",
          "# remark\n\nOFF # remark\n# remark\n2 1\n1 2 3 # remark\n\n4 5 6\n",
          "COFF\n2 0 0\n1 2 3 9 9 9 9\n4 5 6 8 8\n", "NOFF\n2 0 0\n1 2 3 0 0 1\n4 5 6 0 0 1\n",
          "CNOFF\n2 0 0\n1 2 3 0 0 1 9 9 9 9\n4 5 6 0 0 1 9 9 9 9\n", "STOFF\n2 0 0\n1 2 3 0 0\n4 5 6 0 0\n",
          "OFF\r\n2 0 0\r\n1 2 3\r\n4 5 6\r\n"}) {
        for (const char* name : {"a.off", "-", "a.txt"}) {
            auto result = read_cloud(text, name, {});
            ASSERT_TRUE(result) << result.error().message << " in " << text;
            EXPECT_EQ(result.value().cloud.coordinates, kTwoPoints) << text;
        }
    }
}

TEST(OffReader, ColumnsChooseAPlane) {
    auto result = read_cloud("OFF\n2 0 0\n1 2 3\n4 5 6\n", "a.off", {.columns = {1, 3}});
    ASSERT_TRUE(result);
    EXPECT_EQ(result.value().cloud.coordinates, (Numbers{1, 3, 4, 6}));
}

TEST(OffReader, Errors) {
    EXPECT_EQ(failure("OFF\n3 0 0\n1 2 3\n4 5 6\n", "a.off").message,
              "The header promises 3 vertices, but the file ends after 2.");
    EXPECT_EQ(failure("OFF\n18446744073709551615 0 0\n1 2 3\n", "a.off").code, ErrorCode::MalformedInput);
    EXPECT_EQ(failure("OFF\n-1 0 0\n1 2 3\n", "a.off").code, ErrorCode::MalformedInput);
    EXPECT_EQ(failure("OFF\n", "a.off").code, ErrorCode::MalformedInput);
    EXPECT_EQ(failure("8 6 12\n1 2 3\n", "a.off").code, ErrorCode::MalformedInput);
    EXPECT_EQ(failure("OFF\n0 0 0\n", "a.off").code, ErrorCode::EmptyInput);
    EXPECT_EQ(failure("OFF\n2 0 0\n1 2\n4 5 6\n", "a.off").code, ErrorCode::RaggedRows);
    EXPECT_EQ(failure("OFF\n2 0 0\n1 2 nan\n4 5 6\n", "a.off").message,
              "Line 3 has \"nan\", which is not a finite number.");
    EXPECT_EQ(failure("OFF BINARY\n2 0 0\n", "a.off").code, ErrorCode::UnknownFormat);
    EXPECT_EQ(failure("4OFF\n2 0 0\n1 2 3 1\n4 5 6 1\n", "a.off").code, ErrorCode::UnsupportedDimension);
    EXPECT_EQ(failure("nOFF\n2\n2 0 0\n1 2\n4 5\n", "-").code, ErrorCode::UnsupportedDimension);
}

TEST(ObjReader, OnlyVerticesCount) {
    const std::string text =
        "# remark\nmtllib a.mtl\no thing\nv 1 2 3\nvn 0 0 1\nvt 0 0\n  v 4 5 6 1.0 # remark\nf 1/1/1 2//1 \\\n 3\ns "
        "1\n";
    for (const char* name : {"a.obj", "A.OBJ", "-", "thing"}) {
        auto result = read_cloud(text, name, {});
        ASSERT_TRUE(result) << result.error().message;
        EXPECT_EQ(result.value().cloud.coordinates, kTwoPoints);
    }
}

TEST(ObjReader, Errors) {
    EXPECT_EQ(failure("o thing\nf 1 2 3\n", "a.obj").code, ErrorCode::EmptyInput);
    EXPECT_EQ(failure("v 1 2 3\nv 1 2\n", "a.obj").message, "Line 2 has fewer than three coordinates.");
    EXPECT_EQ(failure("v 1 2 3\nv 1 2 x\n", "a.obj").code, ErrorCode::MalformedInput);
    EXPECT_EQ(failure("v 1 2 3\nv 1 2 inf\n", "a.obj").code, ErrorCode::NotANumber);
}

TEST(FileKind, OtherFilesAreNamed) {
    const std::vector<std::pair<std::string, std::string>> files = {
        {std::string("\x89PNG\r\n\x1a\n\0\0", 10), "PNG"},
        {std::string("PK\x03\x04\x14\0", 6), "zip"},
        {"\x1F\x8B\x08", "gzip"},
        {"  {\"points\": []}", "JSON"},
        {"[[1,2],[3,4]]", "JSON"},
        {"<!DOCTYPE html>\n<html></html>", "web page"},
        {"%PDF-1.7", "PDF"},
        {"solid thing\nfacet normal 0 0 1\n", "STL"},
        {std::string("\xFF\xFE\x31\0", 4), "UTF-16"},
        {std::string("1 2 3\n\0\x01\x02", 9), "binary"},
    };
    for (const auto& [bytes, kind] : files) {
        for (const char* name : {"a.xyz", "a.ply", "a.off", "a.obj", "-"}) {
            const Error error = failure(bytes, name);
            EXPECT_EQ(error.code, ErrorCode::UnknownFormat) << kind;
            EXPECT_NE(error.message.find(kind), std::string::npos) << error.message;
        }
    }
}

}  // namespace
}  // namespace plateau
