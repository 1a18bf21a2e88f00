#pragma once

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

/// Whether two tuples of a handful of values are equal; std::equal would call memcmp for them.
template <class Value>
bool equal_few(const Value* a, const Value* b, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        if (a[i] != b[i]) return false;
    }
    return true;
}

}  // namespace plateau
