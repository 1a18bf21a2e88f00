#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cloud/point_cloud.h"
#include "complex/simplex_table.h"

namespace plateau {

/// Coordinates of landmarks by step.
struct LandmarkPoints {
    const PointCloud* cloud = nullptr;
    const std::vector<std::uint32_t>* landmarks = nullptr;  ///< [step-1] = input index

    std::span<const double> operator[](Step step) const { return cloud->point((*landmarks)[step - 1]); }
};

}  // namespace plateau
