#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "io/binary_number.h"

namespace plateau {

enum class PcdEncoding : std::uint8_t { Ascii, Binary, Compressed };

struct PcdField {
    std::string name;
    NumberType type = NumberType::Float32;
    std::uint32_t count = 1;  ///< values a point
};

struct PcdHeader {
    PcdEncoding encoding = PcdEncoding::Ascii;
    std::vector<PcdField> fields;  ///< in file order, at least one
    std::uint64_t points = 0;
    std::size_t size = 0;  ///< bytes up to the first point
    std::uint64_t lines = 0;

    /// Values a point: the columns of the file.
    std::uint32_t columns() const;
    /// Bytes of a point, uncompressed.
    std::uint64_t row_size() const;
};

/// Does the file begin as PCD files do, with "# .PCD" or, behind other comments, with its version?
bool begins_as_pcd(std::string_view bytes);

/// Reads the header of a PCD file, versions 0.5 to 0.7. Errors: MalformedInput, naming the line or what is missing or
/// contradicts itself (WIDTH × HEIGHT and POINTS, lists of different length).
Result<PcdHeader> parse_pcd_header(std::string_view bytes);

}  // namespace plateau
