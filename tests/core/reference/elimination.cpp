#include "reference/elimination.h"

#include <cstdint>
#include <map>
#include <utility>

namespace plateau::reference {

int rank_mod_two(const std::vector<std::vector<int>>& columns, int row_count) {
    const auto words = static_cast<std::size_t>(row_count + 63) / 64;
    std::vector<std::vector<std::uint64_t>> reduced(static_cast<std::size_t>(row_count));  // by lowest row
    int rank = 0;
    for (const std::vector<int>& column : columns) {
        std::vector<std::uint64_t> bits(words);
        for (const int row : column) bits[static_cast<std::size_t>(row) / 64] ^= std::uint64_t{1} << (row % 64);
        for (int row = 0; row < row_count; ++row) {
            if ((bits[static_cast<std::size_t>(row) / 64] >> (row % 64) & 1) == 0) continue;
            std::vector<std::uint64_t>& pivot = reduced[static_cast<std::size_t>(row)];
            if (pivot.empty()) {
                pivot = bits;
                ++rank;
                break;
            }
            for (std::size_t word = 0; word < words; ++word) bits[word] ^= pivot[word];
        }
    }
    return rank;
}

int rank_mod_prime(std::vector<std::vector<long>> rows, long prime) {
    std::size_t rank = 0;
    const std::size_t width = rows.empty() ? 0 : rows[0].size();
    for (std::size_t column = 0; column < width && rank < rows.size(); ++column) {
        std::size_t pivot = rank;
        while (pivot < rows.size() && rows[pivot][column] % prime == 0) ++pivot;
        if (pivot == rows.size()) continue;
        std::swap(rows[pivot], rows[rank]);
        for (std::size_t other = rank + 1; other < rows.size(); ++other) {
            const long factor = rows[other][column];
            if (factor == 0) continue;
            // Cross-multiplied: no inverse is needed for a rank.
            for (std::size_t c = column; c < width; ++c) {
                const long entry = rows[other][c] * rows[rank][column] - factor * rows[rank][c];
                rows[other][c] = ((entry % prime) + prime) % prime;
            }
        }
        ++rank;
    }
    return static_cast<int>(rank);
}

namespace {

int boundary_rank(const std::set<Simplex>& simplices, const std::set<Simplex>& faces, int prime) {
    std::map<Simplex, int> row_of;
    for (const Simplex& face : faces) row_of.emplace(face, static_cast<int>(row_of.size()));
    std::vector<std::vector<int>> columns;
    for (const Simplex& simplex : simplices) {
        columns.emplace_back();
        for (const Simplex& face : facets(simplex)) columns.back().push_back(row_of.at(face));
    }
    if (prime == 2) return rank_mod_two(columns, static_cast<int>(faces.size()));
    std::vector<std::vector<long>> rows;  // transposed: the rank is the same
    for (const std::vector<int>& column : columns) {
        rows.emplace_back(faces.size());
        long sign = 1;
        for (const int row : column) {
            rows.back()[static_cast<std::size_t>(row)] = (sign + prime) % prime;
            sign = -sign;
        }
    }
    return rank_mod_prime(rows, prime);
}

}  // namespace

std::vector<int> betti_numbers(const Complex& complex, int count, int prime) {
    std::vector<int> betti;
    int rank_below = 0;  // of the boundary of k-simplices
    for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
        const int rank_above = boundary_rank(complex[k + 1], complex[k], prime);
        betti.push_back(static_cast<int>(complex[k].size()) - rank_below - rank_above);
        rank_below = rank_above;
    }
    return betti;
}

}  // namespace plateau::reference
