#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace plateau {

enum class PlyEncoding : std::uint8_t { Ascii, LittleEndian, BigEndian };
enum class PlyType : std::uint8_t { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

/// Bytes that a value of the type takes in a binary file.
std::uint32_t byte_size(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::Float32;
    std::optional<PlyType> list_count_type;  ///< set for a list: its length comes first, in this type
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;

    bool has_list() const;
    /// Bytes of a row of a binary file. Precondition: no list.
    std::uint64_t row_size() const;
};

struct PlyHeader {
    PlyEncoding encoding = PlyEncoding::Ascii;
    std::vector<PlyElement> elements;  ///< in file order
    std::size_t size = 0;              ///< bytes up to the first row
    std::uint64_t lines = 0;
};

/// Reads the header of a PLY file. Errors: MalformedInput, naming the line.
Result<PlyHeader> parse_ply_header(std::string_view bytes);

}  // namespace plateau
