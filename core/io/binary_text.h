#pragma once

#include <cstdint>
#include <cstring>
#include <string>

#include "io/binary_number.h"

namespace plateau {

/// Appends the bytes of a number in the byte order of the file, whatever that of this machine is.
template <class Word>
void append_word(std::string& bytes, Word word, ByteOrder order) {
    for (std::size_t k = 0; k < sizeof word; ++k) {
        const std::size_t place = order == ByteOrder::LittleEndian ? k : sizeof word - 1 - k;
        bytes += static_cast<char>(word >> (8 * place) & 0xFF);
    }
}

inline void append_u32(std::string& bytes, std::uint32_t number, ByteOrder order) {
    append_word(bytes, number, order);
}

/// The bits of the number.
inline void append_f32(std::string& bytes, float number, ByteOrder order) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &number, sizeof bits);
    append_word(bytes, bits, order);
}
inline void append_f64(std::string& bytes, double number, ByteOrder order) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &number, sizeof bits);
    append_word(bytes, bits, order);
}

}  // namespace plateau
