#pragma once

#include <cstdint>
#include <cstdio>
#include <string>

namespace plateau {

/// 12345 as "12,345".
inline std::string grouped(std::uint64_t number) {
    const std::string digits = std::to_string(number);
    std::string text;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % 3 == 0) text += ',';
        text += digits[i];
    }
    return text;
}

/// Bytes as "1,234 MB", rounded up.
inline std::string in_megabytes(std::uint64_t bytes) {
    return grouped((bytes + (1u << 20) - 1) >> 20) + " MB";
}

/// A number with at most six significant digits.
inline std::string short_number(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", number);
    return text;
}

}  // namespace plateau
