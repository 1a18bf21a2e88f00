#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "io/binary_number.h"

namespace plateau {

enum class PlyEncoding : std::uint8_t { Ascii, LittleEndian, BigEndian };

struct PlyProperty {
    std::string name;
    NumberType type = NumberType::Float32;
    std::optional<NumberType> list_count_type;  ///< set for a list: its length comes first, in this type
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
