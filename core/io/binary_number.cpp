#include "io/binary_number.h"

#include <cstring>

namespace plateau {

std::uint32_t byte_size(NumberType type) {
    switch (type) {
        case NumberType::Int8:
        case NumberType::Uint8:
            return 1;
        case NumberType::Int16:
        case NumberType::Uint16:
            return 2;
        case NumberType::Int32:
        case NumberType::Uint32:
        case NumberType::Float32:
            return 4;
        case NumberType::Int64:
        case NumberType::Uint64:
        case NumberType::Float64:
            break;
    }
    return 8;
}

double decode_number(const char* field, NumberType type, ByteOrder order) {
    const std::uint32_t size = byte_size(type);
    std::uint64_t word = 0;
    for (std::uint32_t k = 0; k < size; ++k) {
        const std::uint32_t at = order == ByteOrder::BigEndian ? k : size - 1 - k;
        word = word << 8 | static_cast<unsigned char>(field[at]);
    }
    switch (type) {
        case NumberType::Int8:
            return static_cast<std::int8_t>(word);
        case NumberType::Int16:
            return static_cast<std::int16_t>(word);
        case NumberType::Int32:
            return static_cast<std::int32_t>(word);
        case NumberType::Int64:
            return static_cast<double>(static_cast<std::int64_t>(word));
        case NumberType::Uint8:
        case NumberType::Uint16:
        case NumberType::Uint32:
        case NumberType::Uint64:
            return static_cast<double>(word);
        case NumberType::Float32: {
            const auto bits = static_cast<std::uint32_t>(word);
            float number = 0;
            std::memcpy(&number, &bits, sizeof number);
            return number;
        }
        case NumberType::Float64:
            break;
    }
    double number = 0;
    std::memcpy(&number, &word, sizeof number);
    return number;
}

}  // namespace plateau
