#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "base/random.h"
#include "cloud_files.h"
#include "io/cloud_reader.h"
#include "io/lzf.h"
#include "io/saved_options.h"
#include "io/session_file.h"

namespace plateau {
namespace {

using namespace std::string_literals;
using namespace std::string_view_literals;

struct Seed {
    const char* name;
    std::string bytes;
    std::vector<std::uint32_t> columns = {};  ///< those to be named for it, if any
};

std::vector<Seed> valid_files() {
    const std::string header =
        "element extra 2\nproperty list uchar short a\nproperty int b\nelement vertex 3\nproperty float x\n"
        "property double y\nproperty uchar red\nproperty short z\nproperty list ushort float w\nend_header\n";
    const auto body = [](bool big_endian) {
        const auto packed = [&](std::string bytes) {
            return big_endian ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
        };
        const std::string one_short = packed("\x01"s + '\0');
        std::string bytes;
        for (int k = 0; k < 2; ++k) bytes += "\x01"s + one_short + packed("\x07\0\0\0"s);
        for (char k = 0; k < 3; ++k) {
            bytes += packed("\0\0\x80\x3F"s) + packed("\0\0\0\0\0\0\xF0\x3F"s) + "\xFF" + packed(k + "\0"s);
            bytes += one_short + packed("\0\0\x80\x3F"s);
        }
        return bytes;
    };
    std::vector<Seed> files = {
        {"a.txt", "# remark\nx y z\n1 2 3\n4.5e-3 -5 .6\n7 8 9\n"},
        {"a.csv", "\"x\",\"y\",\"z\",\"w\"\r\n1,2,3,4\r\n5, 6 ,7,8\r\n9,10,11,12"},
        {"a.xyz", "//X Y Z R\n1 2 3 255\n4 5 6 0\n"},
        {"-", "1;2\n3;4\n\n5;6\n"},
        {"a.off", "COFF # remark\n3 1 0\n1 2 3 255 0 0\n4 5 6\n7 8 9\n3 0 1 2\n"},
        {"a.obj", "mtllib a\nv 1 2 3\nv 4 5 6 0.5\nvn 0 0 1\nf 1//1 2 3\nv -1 1e3 0\n"},
        {"a.ply", "ply\nformat ascii 1.0\n" + header + "2 1 2 7\n0 7\n1 2 255 3 1 0.5\n4 5 0 6 0\n7 8 0 9 2 1 1\n"},
        {"a.ply", "ply\nformat binary_little_endian 1.0\n" + header + body(false)},
        {"a.ply", "ply\r\nformat binary_big_endian 1.0\r\n" + header + body(true)},
        {"a.pcd",
         "# .PCD v0.7\nVERSION 0.7\nFIELDS rgb x y z\nSIZE 4 4 8 2\nTYPE U F F I\nCOUNT 1 1 1 1\nWIDTH 2\nHEIGHT 2\n"
         "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 4\nDATA ascii\n255 1 2 3\n0 nan nan nan\n0 4 5 6\n1 7 8 9\n"},
        {"a.npy",
         npy_file(2, "{'descr': '>i2', 'fortran_order': True, 'shape': (3, 4), }",
                  "\0\1\0\2\0\3\0\4\0\5\0\6\1\0\2\0\3\0\0\0\0\0\0\0"s),
         {1, 2, 3}},
    };
    for (const CloudFormat& format : cloud_formats()) {
        if (format.extension == "pcd"sv || format.extension == "npy"sv) {
            files.push_back({format.extension == "pcd"sv ? "a.pcd" : "a.npy", format.write(scattered_points(4))});
        }
    }
    return files;
}

std::string mutated(std::string bytes, Random& random) {
    constexpr std::string_view kPieces[] = {"\n"sv,
                                            "\r"sv,
                                            " "sv,
                                            ","sv,
                                            ";"sv,
                                            "-"sv,
                                            "nan"sv,
                                            "1e999"sv,
                                            "\0"sv,
                                            "\xFF"sv,
                                            "#"sv,
                                            "list"sv,
                                            "0"sv,
                                            "vertex"sv,
                                            "element"sv,
                                            "99999999999999999999"sv,
                                            "4294967295"sv,
                                            "v "sv,
                                            "OFF"sv,
                                            "ply\n"sv,
                                            "double"sv,
                                            "end_header\n"sv,
                                            "# .PCD"sv,
                                            "binary\n"sv,
                                            "_compressed\n"sv,
                                            "COUNT"sv,
                                            "<u1"sv,
                                            "True"sv,
                                            "("sv,
                                            "'"sv};
    const std::uint64_t changes = 1 + random.next_bits() % 4;
    for (std::uint64_t k = 0; k < changes; ++k) {
        const std::size_t at = random.next_bits() % (bytes.size() + 1);
        const std::size_t length = random.next_bits() % 12;
        const std::string_view piece = kPieces[random.next_bits() % std::size(kPieces)];
        switch (random.next_bits() % 5) {
            case 0:
                bytes.insert(at, piece);
                break;
            case 1:
                bytes.erase(at, length);
                break;
            case 2:
                bytes.insert(at, bytes.substr(at, length));
                break;
            case 3:
                bytes.resize(at);
                break;
            default:
                if (at < bytes.size()) bytes[at] = static_cast<char>(random.next_bits());
        }
    }
    return bytes;
}

TEST(ReaderFuzz, SeedsAreValid) {
    for (const Seed& seed : valid_files()) {
        const auto result = read_cloud(seed.bytes, seed.name, {seed.columns});
        EXPECT_TRUE(result) << seed.name << ": " << result.error().message;
    }
}

TEST(ReaderFuzz, AnyBytesGiveACloudOrASentence) {
    Random random(20240229);
    int clouds = 0;
    int errors = 0;
    for (const Seed& seed : valid_files()) {
        for (int round = 0; round < 4000; ++round) {
            const std::string bytes = mutated(seed.bytes, random);
            const char* name = round % 4 == 0 ? "-" : seed.name;
            ReadOptions options;
            if (round % 3 == 0) options.columns = {2, 1, 3};
            if (round % 5 == 0) options.as = ReadAs::PointsOfAnyDimension;
            const auto result = read_cloud(bytes, name, options);
            if (!result) {
                ++errors;
                const std::string& message = result.error().message;
                ASSERT_FALSE(message.empty());
                ASSERT_LT(message.size(), 250u) << message;
                for (const char c : message) ASSERT_TRUE(c >= ' ' && c <= '~') << message;
                continue;
            }
            ++clouds;
            const PointCloud& cloud = result.value().cloud;
            ASSERT_TRUE(validated(cloud));
            ASSERT_GE(cloud.size(), 2u);
            // No file makes more than it holds; only compressed data expand, and not without limit.
            const bool may_expand = bytes.find("binary_compressed") != std::string::npos;
            ASSERT_LE(cloud.coordinates.size(), bytes.size() * (may_expand ? kMaxLzfExpansion : 1));
        }
    }
    // Both ways out were taken often: the fuzz reaches behind the first check.
    EXPECT_GT(clouds, 3000);
    EXPECT_GT(errors, 3000);
}

std::vector<Seed> valid_matrices() {
    const auto array = [](const char* dictionary, const std::string& values) {
        return npy_file(1, dictionary, values);
    };
    return {
        {"a.csv", "# remark\n0,1,2\n1,0,2.5\n2,2.5,0\n"},
        {"a.csv", ",a,b,c\na,0,1,2\nb,1,0,2\nc,2,2,0\n"},
        {"a.txt", "1\n2 3\n4 5 6\n"},
        {"-", "0\n1;0\n2;3;0\n4;5;6;0\n"},
        {"a.npy", array("{'descr': '|u1', 'fortran_order': False, 'shape': (3, 3), }", "\0\1\2\1\0\3\2\3\0"s)},
        {"a.npy", array("{'descr': '>i2', 'fortran_order': True, 'shape': (2, 2), }", "\0\0\1\1\1\1\0\0"s)},
        {"a.npy", array("{'descr': '|u1', 'fortran_order': False, 'shape': (6,), }", "\1\2\3\4\5\6"s)},
    };
}

std::vector<std::string> valid_sessions() {
    SavedRun saved;
    saved.options = {{"family", "auto"}, {"nu", "1,6,6,4"}, {"box", "1,0.5"}, {"steps", "12"}};
    saved.reached = 4;
    saved.hash = 0x0123456789abcdef;
    saved.shown = 3;
    saved.view = "{\"points\": 4}";
    PointCloud matrix;
    matrix.distances = {4, {1, 2, 3, 0.1, 5, 6}, {}};
    PointCloud narrow;
    narrow.distances = {3, {}, {1, 2, 3}};
    std::vector<std::string> sessions;
    for (const PointCloud& cloud : {PointCloud{3, {0, 0, 0, 1, 2, 3, 0.1, 5, 6}}, PointCloud{2, {0, 0, 1, 1, 0, 1}},
                                    PointCloud{5, {1, 2, 3, 4, 5, 6, 7, 8, 9, 0.1}}, matrix, narrow}) {
        sessions.push_back(session_bytes(cloud, saved));
    }
    return sessions;
}

/// As long as before: what is longer or shorter mostly fails for its length alone.
std::string with_other_bytes(std::string bytes, Random& random) {
    const std::uint64_t changes = 1 + random.next_bits() % 3;
    for (std::uint64_t k = 0; k < changes; ++k) {
        const std::size_t at = random.next_bits() % bytes.size();
        bytes[at] = static_cast<char>(random.next_bits());
    }
    return bytes;
}

TEST(ReaderFuzz, AnyBytesGiveASessionOrASentence) {
    Random random(20240302);
    ReadOptions options;
    options.memory_limit = 1 << 20;
    int sessions = 0;
    int errors = 0;
    for (const std::string& valid : valid_sessions()) {
        ASSERT_TRUE(read_cloud(valid, "a.plateau", options));
        for (int round = 0; round < 4000; ++round) {
            std::string bytes = round % 3 == 1 ? with_other_bytes(valid, random) : mutated(valid, random);
            // Numbers that a header can hold, at places where it holds them.
            if (round % 3 == 0) {
                constexpr std::string_view kCounts[] = {"0"sv,     "1"sv,          "2"sv,
                                                        "65536"sv, "4294967296"sv, "18446744073709551615"sv};
                std::vector<std::size_t> places;
                for (std::size_t at = 1; at < std::min<std::size_t>(bytes.size(), 200); ++at) {
                    if (bytes[at - 1] == ' ' && bytes[at] >= '0' && bytes[at] <= '9') places.push_back(at);
                }
                if (!places.empty()) {
                    const std::size_t at = places[random.next_bits() % places.size()];
                    bytes.replace(at, 1, kCounts[random.next_bits() % std::size(kCounts)]);
                }
            }
            const auto result = read_cloud(bytes, "a.plateau", options);
            std::string sentence;
            if (result) {
                const ReadCloud& read = result.value();
                ASSERT_TRUE(validated(read.cloud));
                ASSERT_GE(read.cloud.size(), 2u);
                const std::size_t numbers = read.cloud.coordinates.size() + read.cloud.distances.entries.size() +
                                            read.cloud.distances.narrow.size();
                ASSERT_LE(4 * numbers, bytes.size());
                if (read.saved) {
                    ++sessions;
                    ASSERT_LE(read.saved->view.size(), bytes.size());
                    const auto known = options_of(*read.saved);
                    if (!known) sentence = known.error().message;
                }
            } else {
                ++errors;
                sentence = result.error().message;
                ASSERT_FALSE(sentence.empty());
            }
            ASSERT_LT(sentence.size(), 250u) << sentence;
            for (const char c : sentence) ASSERT_TRUE(c >= ' ' && c <= '~') << sentence;
        }
    }
    EXPECT_GT(sessions, 2000);
    EXPECT_GT(errors, 2000);
}

TEST(ReaderFuzz, AnyBytesGiveDistancesOrASentence) {
    Random random(20240301);
    ReadOptions options;
    options.as = ReadAs::Distances;
    options.memory_limit = 1 << 20;
    int matrices = 0;
    int errors = 0;
    for (const Seed& seed : valid_matrices()) {
        const auto valid = read_cloud(seed.bytes, seed.name, options);
        ASSERT_TRUE(valid) << seed.name << ": " << valid.error().message;
        for (int round = 0; round < 4000; ++round) {
            const std::string bytes = mutated(seed.bytes, random);
            const auto result = read_cloud(bytes, round % 4 == 0 ? "-" : seed.name, options);
            std::vector<std::string> sentences;
            if (result) {
                ++matrices;
                sentences = result.value().warnings;
                const DistanceMatrix& matrix = result.value().cloud.distances;
                ASSERT_GE(matrix.size, 2u);
                const std::size_t count = matrix.entries.size() + matrix.narrow.size();
                ASSERT_EQ(count, DistanceMatrix::entry_count(matrix.size));
                ASSERT_LE(count, bytes.size());
                for (std::size_t k = 0; k < count; ++k) {
                    ASSERT_TRUE(matrix.entry(k) >= 0 && matrix.entry(k) <= kMaxCoordinate);
                    ASSERT_FALSE(std::signbit(matrix.entry(k)));
                }
            } else {
                ++errors;
                sentences = {result.error().message};
            }
            for (const std::string& sentence : sentences) {
                ASSERT_FALSE(sentence.empty());
                ASSERT_LT(sentence.size(), 250u) << sentence;
                for (const char c : sentence) ASSERT_TRUE(c >= ' ' && c <= '~') << sentence;
            }
        }
    }
    EXPECT_GT(matrices, 2000);
    EXPECT_GT(errors, 2000);
}

}  // namespace
}  // namespace plateau
