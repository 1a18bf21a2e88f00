#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "base/result.h"
#include "cloud/point_cloud.h"

namespace plateau {

/// A built-in shape that clouds can be sampled from.
struct SampleShape {
    std::string_view name;       ///< as on the command line
    std::uint32_t dimension;     ///< of the ambient space
    std::uint32_t default_size;  ///< points that show its plateau clearly
    std::string_view look_for;   ///< one sentence for the visitor
};

/// The shapes in their listed order.
std::span<const SampleShape> sample_shapes();

struct SampleOptions {
    std::uint32_t size = 1000;
    double noise = 0;  ///< radius of the uniform ball added to each point, in input units
    std::uint64_t seed = 1;
};

/// n points of the named shape, the same bits on every machine (+ - * / sqrt only).
/// Errors: InvalidOption for an unknown shape (the sentence lists the known ones), size 0 or above 10 million, or
/// noise that is negative or not finite.
Result<PointCloud> sample_shape(std::string_view name, const SampleOptions& options);

}  // namespace plateau
