#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <span>
#include <string>
#include <string_view>

namespace plateau {

/// Enough digits that reading gives the same bits. Shortest forms need to_chars, which one library lacks for double.
inline std::string exact(double number) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.17g", number);
    return text.data();
}

/// The same for JSON, which has no infinity.
inline std::string exact_or_null(double number) {
    return std::isfinite(number) ? exact(number) : "null";
}

inline std::string joined(std::span<const std::uint32_t> numbers, std::string_view separator) {
    std::string text;
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        if (k > 0) text += separator;
        text += std::to_string(numbers[k]);
    }
    return text;
}

}  // namespace plateau
