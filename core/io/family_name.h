#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "timeline/timeline.h"

namespace plateau {

/// The families' names on the command line and in files, by their numbers.
inline constexpr std::array<std::string_view, 5> kFamilyNames = {"witness", "delaunay", "surface", "auto", "dilated"};

inline std::string_view family_name(Family family) {
    return kFamilyNames[static_cast<std::size_t>(family)];
}

/// The family of the name, or nothing.
inline std::optional<Family> family_named(std::string_view name) {
    for (std::size_t k = 0; k < kFamilyNames.size(); ++k) {
        if (kFamilyNames[k] == name) return static_cast<Family>(k);
    }
    return std::nullopt;
}

}  // namespace plateau
