#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "metrics/metric.h"

namespace plateau {

/// The metrics' names on the command line and in files, by their numbers.
inline constexpr std::array<std::string_view, 8> kMetricNames = {"euclidean",  "l1",       "linf",     "angular",
                                                                 "projective", "periodic", "geodesic", "matrix"};
/// The same in a sentence.
inline constexpr std::string_view kMetricChoice =
    "euclidean, l1, linf, angular, projective, periodic, geodesic or matrix";

inline std::string_view metric_name(Metric metric) {
    return kMetricNames[static_cast<std::size_t>(metric)];
}

/// The metric of the name, or nothing.
inline std::optional<Metric> metric_named(std::string_view name) {
    for (std::size_t k = 0; k < kMetricNames.size(); ++k) {
        if (kMetricNames[k] == name) return static_cast<Metric>(k);
    }
    return std::nullopt;
}

}  // namespace plateau
