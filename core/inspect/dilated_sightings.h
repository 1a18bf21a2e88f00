#pragma once

#include <span>

#include "cloud/point_cloud.h"
#include "dilated/weighted_landmarks.h"
#include "inspect/sightings.h"

namespace plateau {

/// The same for family dilated: the witnesses within zeta of the cell of the simplex, or the nearest one, with its
/// distance t. Vertices ascending, at most one more than the dimension.
/// Cost: a program for each of the n witnesses, ended early for most of them.
Sightings dilated_sightings(const PointCloud& witnesses, const WeightedLandmarks& landmarks,
                            std::span<const Step> simplex, double zeta);

}  // namespace plateau
