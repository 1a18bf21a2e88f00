#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "dilated/slivers.h"

namespace plateau {

/// The sliver measures' names on the command line and in files, by their numbers.
inline constexpr std::array<std::string_view, 2> kSliverNames = {"literal", "normalized"};
/// The same in a sentence.
inline constexpr std::string_view kSliverChoice = "literal or normalized";

inline std::string_view sliver_name(SliverMeasure measure) {
    return kSliverNames[static_cast<std::size_t>(measure)];
}

/// The measure of the name, or nothing.
inline std::optional<SliverMeasure> sliver_named(std::string_view name) {
    for (std::size_t k = 0; k < kSliverNames.size(); ++k) {
        if (kSliverNames[k] == name) return static_cast<SliverMeasure>(k);
    }
    return std::nullopt;
}

}  // namespace plateau
