#pragma once

#include <cstdint>
#include <cstring>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace plateau {

/// The bytes of a value, in file order.
template <class T>
std::string packed(T value, bool big_endian) {
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    if (big_endian) bytes.assign(bytes.rbegin(), bytes.rend());
    return bytes;
}

/// LZF-compressed data that use every kind of token where the text allows it: literals, short and long copies, also
/// such as reach into what they write.
std::string lzf_compressed(std::string_view text);

/// Header and length of a .npy file of the given format version; `dictionary` as Python writes it.
std::string npy_file(int version, const std::string& dictionary, const std::string& values);

/// A file format as the tests write it, sharing no code with the readers.
struct CloudFormat {
    const char* name;
    const char* extension;
    /// The bytes of points in space, three coordinates each that fit single precision.
    std::function<std::string(const std::vector<double>&)> write;
};

/// Every format and encoding that can be read.
const std::vector<CloudFormat>& cloud_formats();

/// Points in a box whose coordinates are multiples of 1/1024; tests/web/cloud-files.ts makes the same.
std::vector<double> scattered_points(std::uint32_t size);

}  // namespace plateau
