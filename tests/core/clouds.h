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
};

/// The name, for messages.
std::ostream& operator<<(std::ostream& out, const TestCloud& cloud);

/// At least 34 clouds in the plane and in space, the same bits at every call: shapes, grids, cospherical and tied
/// points, duplicates, lower-dimensional sets, dimensions that rise late, extreme scales, and sets at which surfaces
/// touch. All have at most 60 points but a few named `..._large`.
std::vector<TestCloud> test_clouds();

/// The cloud of that name; throws std::out_of_range when there is none.
TestCloud test_cloud(const std::string& name);

}  // namespace plateau
