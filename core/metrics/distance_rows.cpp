#include "metrics/distance_rows.h"

#include <algorithm>
#include <limits>
#include <string>

#include "metrics/coordinate_rows.h"
#include "metrics/geodesic_rows.h"

namespace plateau {

namespace {

class MatrixRows : public DistanceRows {
public:
    explicit MatrixRows(const DistanceMatrix& distances) : distances_(&distances) {}
    void fill(std::uint32_t witness, const Limits&, std::span<double> row) override { distances_->row(witness, row); }
    double distance(double comparable) const override { return comparable; }

private:
    const DistanceMatrix* distances_;
};

Error invalid(std::string message) {
    return {ErrorCode::InvalidOption, std::move(message)};
}

std::optional<Error> check_directions(const PointCloud& cloud) {
    for (std::uint32_t i = 0; i < cloud.size(); ++i) {
        const auto point = cloud.point(i);
        if (std::any_of(point.begin(), point.end(), [](double coordinate) { return coordinate != 0; })) continue;
        return invalid("Point " + std::to_string(i + 1) + " is the origin, which has no direction: leave it out.");
    }
    return std::nullopt;
}

std::optional<Error> check_box(const PointCloud& cloud, const std::vector<double>& box) {
    if (box.empty()) {
        for (std::size_t k = 0; k < cloud.coordinates.size(); ++k) {
            if (cloud.coordinates[k] >= 0 && cloud.coordinates[k] <= 1) continue;
            return invalid("Point " + std::to_string(k / cloud.dimension + 1) +
                           " lies outside the unit box: name the periods, such as --box 24 or --box 1,2.");
        }
        return std::nullopt;
    }
    if (box.size() != 1 && box.size() != cloud.dimension) {
        return invalid("The box has " + std::to_string(box.size()) + " periods, but the points have " +
                       std::to_string(cloud.dimension) + " coordinates: name one for each, or one for all.");
    }
    const bool sound =
        std::all_of(box.begin(), box.end(), [](double period) { return period >= 0 && period <= 1e150; });
    if (!sound || std::all_of(box.begin(), box.end(), [](double period) { return period == 0; })) {
        return invalid("A period of the box must be a positive number, or 0 for an axis without one.");
    }
    return std::nullopt;
}

}  // namespace

bool DistanceRows::prepare(const Deadline&) {
    return true;
}

double DistanceRows::nearest_other(std::uint32_t witness, std::span<double> row) {
    fill(witness, {}, row);
    row[witness] = std::numeric_limits<double>::infinity();
    return *std::min_element(row.begin(), row.end());
}

std::uint64_t estimated_rows_memory(const PointCloud& cloud, const MetricOptions& options) {
    const std::uint64_t n = cloud.size();
    const std::uint64_t coordinates = cloud.coordinates.size() * sizeof(double);
    switch (options.metric) {
        case Metric::Angular:
        case Metric::Projective:
            return coordinates + n * sizeof(double);
        case Metric::Periodic:
            return coordinates;
        case Metric::Geodesic: {
            // Tree, and a neighbor as it was found and as an edge at both of its ends.
            constexpr std::uint64_t kBytesPerNeighbor = 48;
            return 2 * coordinates + n * std::min<std::uint64_t>(options.neighbors, n) * kBytesPerNeighbor;
        }
        default:
            return 0;
    }
}

std::unique_ptr<DistanceRows> make_distance_rows(const PointCloud& cloud, const MetricOptions& options) {
    if (options.metric == Metric::Matrix) return std::make_unique<MatrixRows>(cloud.distances);
    if (options.metric == Metric::Geodesic) return std::make_unique<GeodesicRows>(cloud, options.neighbors);
    return make_coordinate_rows(cloud, options);
}

std::optional<Error> check_metric(const PointCloud& cloud, const MetricOptions& options) {
    const bool has_matrix = cloud.distances.size > 0;
    if (options.metric == Metric::Matrix && !has_matrix) {
        return invalid("The metric matrix needs a distance matrix, not points.");
    }
    if (options.metric != Metric::Matrix && has_matrix) {
        return invalid("A distance matrix has no coordinates: take the metric matrix.");
    }
    switch (options.metric) {
        case Metric::Angular:
        case Metric::Projective:
            return check_directions(cloud);
        case Metric::Periodic:
            return check_box(cloud, options.box);
        case Metric::Geodesic:
            if (options.neighbors == 0) return invalid("Every point must be joined to at least 1 neighbor.");
            return std::nullopt;
        default:
            return std::nullopt;
    }
}

}  // namespace plateau
