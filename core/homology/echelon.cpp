#include "homology/echelon.h"

#include <utility>

namespace plateau {

namespace {

std::uint32_t inverse(std::uint32_t value, std::uint32_t prime) {
    std::uint32_t power = 1;  // value^(prime-2), by Fermat
    for (std::uint32_t exponent = prime - 2; exponent > 0; exponent /= 2) {
        if (exponent % 2 == 1) power = power * value % prime;
        value = value * value % prime;
    }
    return power;
}

}  // namespace

void Echelon::reset(std::uint32_t row_count) {
    columns_.clear();
    led_by_.assign(row_count, kNoRow);
}

std::uint32_t Echelon::insert(Column column) {
    looked_at_ = 0;
    while (!column.empty()) {
        std::uint32_t& leader = led_by_[column.front().row];
        if (leader == kNoRow) {
            leader = rank();
            columns_.push_back(std::move(column));
            return columns_.back().front().row;
        }
        subtract(column, columns_[leader]);
    }
    return kNoRow;
}

void Echelon::shrink_to(std::uint32_t rank) {
    for (; columns_.size() > rank; columns_.pop_back()) led_by_[columns_.back().front().row] = kNoRow;
}

// Cancels the leading row of the column by a multiple of the pivot.
void Echelon::subtract(Column& column, const Column& pivot) {
    looked_at_ += static_cast<std::uint32_t>(column.size() + pivot.size());
    const std::uint32_t factor = column.front().value * inverse(pivot.front().value, prime_) % prime_;
    sum_.clear();
    auto a = column.begin() + 1;
    auto b = pivot.begin() + 1;
    while (a != column.end() || b != pivot.end()) {
        if (b == pivot.end() || (a != column.end() && a->row < b->row)) {
            sum_.push_back(*a++);
            continue;
        }
        const std::uint32_t minus = prime_ - factor * b->value % prime_;  // never 0 mod p
        if (a == column.end() || b->row < a->row) {
            sum_.push_back({b->row, minus});
        } else {
            const std::uint32_t value = (a->value + minus) % prime_;
            if (value != 0) sum_.push_back({a->row, value});
            ++a;
        }
        ++b;
    }
    column.swap(sum_);
}

}  // namespace plateau
