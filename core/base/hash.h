#pragma once

#include <cstdint>
#include <cstring>

namespace plateau {

/// 64-bit FNV-1a over little-endian words; the same bytes give the same value on every machine.
class Fnv1a64 {
public:
    void add_byte(std::uint8_t byte) { value_ = (value_ ^ byte) * 0x100000001b3ull; }
    void add_u32(std::uint32_t word) {
        for (int shift = 0; shift < 32; shift += 8) add_byte(static_cast<std::uint8_t>(word >> shift));
    }
    void add_u64(std::uint64_t word) {
        for (int shift = 0; shift < 64; shift += 8) add_byte(static_cast<std::uint8_t>(word >> shift));
    }
    /// The bits of a double, not its rounded print.
    void add_f64(double number) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &number, sizeof bits);
        add_u64(bits);
    }
    std::uint64_t value() const { return value_; }

private:
    std::uint64_t value_ = 0xcbf29ce484222325ull;
};

}  // namespace plateau
