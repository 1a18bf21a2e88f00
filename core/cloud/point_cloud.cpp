#include "cloud/point_cloud.h"

#include <cmath>
#include <limits>
#include <string>

namespace plateau {

Result<PointCloud> validated(PointCloud cloud) {
    if (cloud.dimension == 0 && cloud.distances.size > 0) return cloud;
    if (cloud.coordinates.empty()) return Error{ErrorCode::EmptyInput, "The point cloud is empty."};
    if (cloud.dimension < 2) {
        return Error{ErrorCode::UnsupportedDimension, "Points have " + std::to_string(cloud.dimension) +
                                                          (cloud.dimension == 1 ? " coordinate" : " coordinates") +
                                                          "; they need at least 2."};
    }
    if (cloud.coordinates.size() % cloud.dimension != 0) {
        return Error{ErrorCode::RaggedRows,
                     "The last point has fewer than " + std::to_string(cloud.dimension) + " coordinates."};
    }
    // The largest index is a mark for "none" elsewhere.
    if (cloud.coordinates.size() / cloud.dimension >= std::numeric_limits<std::uint32_t>::max()) {
        return Error{ErrorCode::OutOfMemory, "More than 4294967294 points: that is more than fits."};
    }
    for (std::size_t k = 0; k < cloud.coordinates.size(); ++k) {
        // Written so that NaN fails it too.
        if (std::abs(cloud.coordinates[k]) <= kMaxCoordinate) continue;
        const std::string point = "Point " + std::to_string(k / cloud.dimension + 1);
        const std::string why = std::isfinite(cloud.coordinates[k])
                                    ? " has a coordinate beyond 1e150; scale the cloud down."
                                    : " has a coordinate that is not a finite number.";
        return Error{ErrorCode::NotANumber, point + why};
    }
    return cloud;
}

}  // namespace plateau
