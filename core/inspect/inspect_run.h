#pragma once

#include <cstdint>
#include <vector>

#include "base/result.h"
#include "cloud/point_cloud.h"
#include "dilated/dilated_complex.h"
#include "inspect/inspection.h"
#include "metrics/metric.h"
#include "timeline/timeline.h"

namespace plateau {

/// What a run was computed from.
struct RunBasis {
    const PointCloud& cloud;
    MetricOptions metric;
    std::vector<std::vector<std::uint32_t>> nu;  ///< one sequence a track
    double dilation = 0;                         ///< family dilated: zeta / epsilon
    double rho = 0;                              ///< surface: the largest radius-edge ratio; 0: any
};

/// Why the simplex of these landmarks (steps, in any order) is in the complex shown at the step, or why not, from the
/// definition: the record says what is there, ranks, balls and distances are computed anew from the cloud for the
/// landmarks of that step. The record is not touched.
/// Cost: straight distances O(n (k + log i)) and what delaunay_place() takes; others O(n i); family dilated n programs.
/// Errors: InvalidOption for a step that is not computed, and those of inspected().
Result<Inspection> inspect_run(const RunBasis& basis, const Timeline& timeline, Step step, std::vector<Step> vertices);

}  // namespace plateau
