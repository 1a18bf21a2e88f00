#pragma once

#include <cstdint>

namespace plateau {

/// Deterministic random bits (splitmix64): the same seed gives the same sequence on every machine.
/// Draw each value into a named variable; two draws among the arguments of one call have no order.
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next_bits() {
        state_ += 0x9e3779b97f4a7c15ull;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
        return z ^ (z >> 31);
    }
    /// Uniform in [0, 1), a multiple of 2^-53.
    double next_unit() { return static_cast<double>(next_bits() >> 11) * 0x1p-53; }
    /// Uniform in [low, high).
    double next_between(double low, double high) { return low + (high - low) * next_unit(); }

private:
    std::uint64_t state_;
};

}  // namespace plateau
