#pragma once

#include <cstdint>

namespace plateau {

enum class NumberType : std::uint8_t { Int8, Uint8, Int16, Uint16, Int32, Uint32, Int64, Uint64, Float32, Float64 };
enum class ByteOrder : std::uint8_t { LittleEndian, BigEndian };

/// Bytes that a number of the type takes in a file.
std::uint32_t byte_size(NumberType type);

/// The number that begins at `field`, whatever the byte order of this machine; 64-bit integers are rounded to the
/// nearest double, all others fit. Precondition: byte_size(type) bytes can be read.
double decode_number(const char* field, NumberType type, ByteOrder order);

}  // namespace plateau
