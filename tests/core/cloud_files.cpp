#include "cloud_files.h"

#include <algorithm>
#include <cstdio>
#include <map>

namespace plateau {
namespace {

using Points = std::vector<double>;

std::string rows(const Points& points, const std::string& before, const char* separator) {
    std::string text;
    for (std::size_t k = 0; k < points.size(); k += 3) {
        text += before;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            char number[40];
            std::snprintf(number, sizeof number, "%.17g", points[k + axis]);
            text += (axis > 0 ? separator : "") + std::string(number);
        }
        text += "\n";
    }
    return text;
}

template <class T>
std::string binary_rows(const Points& points, bool big_endian) {
    std::string bytes;
    for (const double value : points) bytes += packed(static_cast<T>(value), big_endian);
    return bytes;
}

template <class T>
std::string binary_columns(const Points& points, bool big_endian) {
    std::string bytes;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t k = axis; k < points.size(); k += 3) {
            bytes += packed(static_cast<T>(points[k]), big_endian);
        }
    }
    return bytes;
}

std::string count_of(const Points& points) {
    return std::to_string(points.size() / 3);
}

std::string ply_header(const Points& points, const char* format, const char* type) {
    std::string text = "ply\nformat " + std::string(format) + " 1.0\nelement vertex " + count_of(points) + "\n";
    for (const char* axis : {"x", "y", "z"}) text += "property " + std::string(type) + " " + axis + "\n";
    return text + "end_header\n";
}

std::string pcd_header(const Points& points, const char* size, const char* data) {
    return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z\nSIZE " + std::string(size) +
           "\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " + count_of(points) + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " +
           count_of(points) + "\nDATA " + data + "\n";
}

template <class T>
std::string npy(const Points& points, int version, const char* type, bool by_columns) {
    const bool big_endian = type[0] == '>';
    return npy_file(version,
                    "{'descr': '" + std::string(type) + "', 'fortran_order': " + (by_columns ? "True" : "False") +
                        ", 'shape': (" + count_of(points) + ", 3), }",
                    by_columns ? binary_columns<T>(points, big_endian) : binary_rows<T>(points, big_endian));
}

}  // namespace

std::string lzf_compressed(std::string_view text) {
    constexpr std::size_t kMostLiterals = 32;
    constexpr std::size_t kLongest = 264;
    constexpr std::size_t kFarthest = 8192;
    std::string result;
    std::string literals;
    const auto flush = [&] {
        for (std::size_t k = 0; k < literals.size(); k += kMostLiterals) {
            const std::string run = literals.substr(k, kMostLiterals);
            result += static_cast<char>(run.size() - 1);
            result += run;
        }
        literals.clear();
    };
    std::map<std::string_view, std::size_t> last;
    std::size_t at = 0;
    while (at < text.size()) {
        const std::string_view key = text.substr(at, 3);
        const auto found = key.size() == 3 ? last.find(key) : last.end();
        std::size_t length = 0;
        if (found != last.end() && at - found->second <= kFarthest) {
            const std::size_t most = std::min(kLongest, text.size() - at);
            while (length < most && text[found->second + length] == text[at + length]) ++length;
            flush();
            const std::size_t distance = at - found->second - 1;
            const std::size_t code = length - 2;
            result += static_cast<char>((code < 7 ? code : 7) << 5 | distance >> 8);
            if (code >= 7) result += static_cast<char>(code - 7);
            result += static_cast<char>(distance & 255);
        } else {
            length = 1;
            literals += text[at];
        }
        for (std::size_t k = 0; k < length; ++k, ++at) {
            if (at + 3 <= text.size()) last[text.substr(at, 3)] = at;
        }
    }
    flush();
    return result;
}

std::string npy_file(int version, const std::string& dictionary, const std::string& values) {
    const std::size_t prefix = version == 1 ? 10 : 12;
    std::string text = dictionary;
    while ((prefix + text.size() + 1) % 64 != 0) text += ' ';
    text += '\n';
    const auto length = static_cast<std::uint32_t>(text.size());
    return "\x93NUMPY" + std::string(1, static_cast<char>(version)) + '\0' +
           (version == 1 ? packed(static_cast<std::uint16_t>(length), false) : packed(length, false)) + text + values;
}

const std::vector<CloudFormat>& cloud_formats() {
    static const std::vector<CloudFormat> formats = {
        {"xyz", "xyz", [](const Points& points) { return rows(points, "", " "); }},
        {"txt with a comment", "txt", [](const Points& points) { return "# a scan\n" + rows(points, "", "\t"); }},
        {"csv with names", "csv", [](const Points& points) { return "x,y,z\n" + rows(points, "", ","); }},
        {"ply ascii", "ply",
         [](const Points& points) { return ply_header(points, "ascii", "double") + rows(points, "", " "); }},
        {"ply little endian", "ply",
         [](const Points& points) {
             return ply_header(points, "binary_little_endian", "float") + binary_rows<float>(points, false);
         }},
        {"ply big endian", "ply",
         [](const Points& points) {
             return ply_header(points, "binary_big_endian", "double") + binary_rows<double>(points, true);
         }},
        {"off", "off",
         [](const Points& points) { return "OFF\n" + count_of(points) + " 0 0\n" + rows(points, "", " "); }},
        {"obj", "obj", [](const Points& points) { return "o scan\n" + rows(points, "v ", " "); }},
        {"pcd ascii", "pcd",
         [](const Points& points) { return pcd_header(points, "4 4 4", "ascii") + rows(points, "", " "); }},
        {"pcd binary", "pcd",
         [](const Points& points) {
             return pcd_header(points, "4 4 4", "binary") + binary_rows<float>(points, false);
         }},
        {"pcd compressed", "pcd",
         [](const Points& points) {
             const std::string values = binary_columns<double>(points, false);
             const std::string data = lzf_compressed(values);
             return pcd_header(points, "8 8 8", "binary_compressed") +
                    packed(static_cast<std::uint32_t>(data.size()), false) +
                    packed(static_cast<std::uint32_t>(values.size()), false) + data;
         }},
        {"npy by rows", "npy", [](const Points& points) { return npy<double>(points, 1, "<f8", false); }},
        {"npy by columns", "npy", [](const Points& points) { return npy<float>(points, 2, "<f4", true); }},
        {"npy big endian", "npy", [](const Points& points) { return npy<double>(points, 3, ">f8", false); }},
    };
    return formats;
}

std::vector<double> scattered_points(std::uint32_t size) {
    std::uint32_t state = 12345;
    std::vector<double> points;
    for (std::uint32_t k = 0; k < 3 * size; ++k) {
        state = state * 1664525u + 1013904223u;
        points.push_back(static_cast<double>(state >> 20) / 1024 - 2);
    }
    return points;
}

}  // namespace plateau
