#pragma once

#include <array>
#include <cstddef>

namespace plateau {

/// Ascending insertion sort of a handful of distinct values.
template <class Value>
void sort_few(Value* values, std::size_t count) {
    for (std::size_t i = 1; i < count; ++i) {
        const Value value = values[i];
        std::size_t place = i;
        for (; place > 0 && value < values[place - 1]; --place) values[place] = values[place - 1];
        values[place] = value;
    }
}

/// The same of three values, without branches where the machine has them: which order they are in cannot be foreseen.
template <class Value>
void sort_three(std::array<Value, 3>& values) {
    const auto order = [](Value& a, Value& b) {
        const Value low = b < a ? b : a;
        b = b < a ? a : b;
        a = low;
    };
    order(values[0], values[1]);
    order(values[1], values[2]);
    order(values[0], values[1]);
}

/// Whether two tuples of a handful of values are equal; std::equal would call memcmp for them.
template <class Value>
bool equal_few(const Value* a, const Value* b, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        if (a[i] != b[i]) return false;
    }
    return true;
}

}  // namespace plateau
