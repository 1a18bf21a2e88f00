#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace plateau {

/// The distances between n witnesses that need have no coordinates: symmetric, 0 on the diagonal, of which only what is
/// below it is kept, row by row: entry (i, j), i > j, is number i (i - 1) / 2 + j. Numbers that came in single
/// precision stay so; they are as exact and take half the memory.
struct DistanceMatrix {
    std::uint32_t size = 0;       ///< n; 0: there is no matrix
    std::vector<double> entries;  ///< n (n - 1) / 2 distances in input units, or none
    std::vector<float> narrow;    ///< the same in single precision, or none

    /// How many distances n witnesses have.
    static std::uint64_t entry_count(std::uint64_t n) { return n == 0 ? 0 : n * (n - 1) / 2; }
    /// Place of the pair among the entries. Precondition: a > b.
    static std::size_t place(std::uint32_t a, std::uint32_t b) { return static_cast<std::size_t>(entry_count(a)) + b; }
    double entry(std::size_t place) const { return entries.empty() ? double{narrow[place]} : entries[place]; }
    double distance(std::uint32_t a, std::uint32_t b) const {
        if (a == b) return 0;
        return entry(a > b ? place(a, b) : place(b, a));
    }
    /// All distances of one witness, its own included. Cost: O(n).
    void row(std::uint32_t witness, std::span<double> out) const;
    /// Bytes held.
    std::uint64_t memory() const { return entries.capacity() * sizeof(double) + narrow.capacity() * sizeof(float); }
};

}  // namespace plateau
