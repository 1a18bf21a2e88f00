#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "io/binary_number.h"

namespace plateau {

struct NpyHeader {
    NumberType type = NumberType::Float64;
    ByteOrder order = ByteOrder::LittleEndian;
    bool by_columns = false;           ///< Fortran order: all values of a column, then the next column
    std::vector<std::uint64_t> shape;  ///< extents, outermost first
    std::size_t size = 0;              ///< bytes up to the first value
};

/// Does the file begin as NumPy's .npy files do?
bool begins_as_npy(std::string_view bytes);

/// Reads the header of a .npy file, format versions 1 to 3. Errors: MalformedInput; UnknownFormat for values that are
/// no real numbers of up to 64 bits (or are half-precision floats, which the sentence says how to convert).
Result<NpyHeader> parse_npy_header(std::string_view bytes);

}  // namespace plateau
