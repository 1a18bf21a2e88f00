#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "cloud/point_cloud.h"

namespace plateau {

/// A small input with a property that could break something.
struct TestCloud {
    std::string name;  ///< letters, digits and underscores
    PointCloud cloud;
    int max_steps = 1000000;  ///< where to stop: dense clouds show their surface in the first steps
};

/// The name, for messages.
std::ostream& operator<<(std::ostream& out, const TestCloud& cloud);

/// At least 34 clouds in the plane and in space, the same bits at every call: shapes, grids, cospherical and tied
/// points, duplicates, lower-dimensional sets, dimensions that rise late, extreme scales, and sets at which surfaces
/// touch. Most have at most 60 points; those named `..._large` have up to 200, those named
/// `..._dense` more and fewer steps.
std::vector<TestCloud> test_clouds();

/// The cloud of that name; throws std::out_of_range when there is none.
TestCloud test_cloud(const std::string& name);

}  // namespace plateau
