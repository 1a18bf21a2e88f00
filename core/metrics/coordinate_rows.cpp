#include "metrics/coordinate_rows.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "cloud/trigonometry.h"

namespace plateau {

namespace {

/// A row by a rule for two points, `measure(a, b)`, and another for what comes out, `distance(comparable)`.
template <class Measure>
class Rows : public DistanceRows {
public:
    Rows(const PointCloud& cloud, Measure measure) : cloud_(&cloud), measure_(std::move(measure)) {}

    void fill(std::uint32_t witness, const Limits&, std::span<double> row) override {
        for (std::uint32_t other = 0; other < row.size(); ++other) row[other] = measure_(*cloud_, other, witness);
    }
    double distance(double comparable) const override { return measure_.distance(comparable); }
    std::uint64_t memory() const override { return measure_.memory(); }

private:
    const PointCloud* cloud_;
    Measure measure_;
};

struct Euclidean {
    double operator()(const PointCloud& cloud, std::uint32_t a, std::uint32_t b) const {
        return distance_squared(cloud.point(a), cloud.point(b));
    }
    static double distance(double comparable) { return std::sqrt(comparable); }
    static std::uint64_t memory() { return 0; }
};

struct SumOfDifferences {
    double operator()(const PointCloud& cloud, std::uint32_t a, std::uint32_t b) const {
        double sum = 0;
        for (std::uint32_t axis = 0; axis < cloud.dimension; ++axis) {
            sum += std::abs(cloud.point(a)[axis] - cloud.point(b)[axis]);
        }
        return sum;
    }
    static double distance(double comparable) { return comparable; }
    static std::uint64_t memory() { return 0; }
};

struct LargestDifference {
    double operator()(const PointCloud& cloud, std::uint32_t a, std::uint32_t b) const {
        double largest = 0;
        for (std::uint32_t axis = 0; axis < cloud.dimension; ++axis) {
            largest = std::max(largest, std::abs(cloud.point(a)[axis] - cloud.point(b)[axis]));
        }
        return largest;
    }
    static double distance(double comparable) { return comparable; }
    static std::uint64_t memory() { return 0; }
};

/// Between directions, or between lines where `Lines`.
template <bool Lines>
class Angle {
public:
    explicit Angle(const PointCloud& cloud) : directions_(cloud.coordinates) {
        const std::size_t d = cloud.dimension;
        for (std::size_t at = 0; at < directions_.size(); at += d) {
            double* const direction = directions_.data() + at;
            // By a power of two, which rounds nothing: squared norms neither overflow nor vanish.
            double largest = 0;
            for (std::size_t axis = 0; axis < d; ++axis) largest = std::max(largest, std::abs(direction[axis]));
            int exponent = 0;
            std::frexp(largest, &exponent);
            for (std::size_t axis = 0; axis < d; ++axis) direction[axis] = std::ldexp(direction[axis], -exponent);
            norms_squared_.push_back(product(direction, direction, d));
        }
    }

    double operator()(const PointCloud& cloud, std::uint32_t a, std::uint32_t b) const {
        const std::size_t d = cloud.dimension;
        const double dot = product(directions_.data() + a * d, directions_.data() + b * d, d);
        const double norms = norms_squared_[a] * norms_squared_[b];
        const double cosine_part = dot * dot;
        const bool obtuse = !Lines && dot < 0;
        // Rounding can make the square of the product the larger one.
        return obtuse ? 1 + std::min(cosine_part / norms, 1.0) : std::max(norms - cosine_part, 0.0) / norms;
    }
    static double distance(double comparable) {
        return comparable <= 1 ? angle_of_squared_sine(comparable) : kTwoPi / 4 + angle_of_squared_sine(comparable - 1);
    }
    std::uint64_t memory() const { return (directions_.capacity() + norms_squared_.capacity()) * sizeof(double); }

private:
    static double product(const double* a, const double* b, std::size_t d) {
        double sum = 0;
        for (std::size_t axis = 0; axis < d; ++axis) sum += a[axis] * b[axis];
        return sum;
    }
    std::vector<double> directions_;
    std::vector<double> norms_squared_;
};

class Periodic {
public:
    Periodic(const PointCloud& cloud, const std::vector<double>& box) : wrapped_(cloud.coordinates) {
        const std::size_t d = cloud.dimension;
        for (std::size_t axis = 0; axis < d; ++axis) {
            periods_.push_back(box.empty() ? 1 : box[box.size() == 1 ? 0 : axis]);
        }
        // The remainder is exact, so wrapping rounds nothing but the step back above zero.
        for (std::size_t i = 0; i < wrapped_.size(); ++i) {
            const double period = periods_[i % d];
            if (period == 0) continue;
            wrapped_[i] = std::fmod(wrapped_[i], period);
            if (wrapped_[i] < 0) wrapped_[i] += period;
        }
    }

    double operator()(const PointCloud& cloud, std::uint32_t a, std::uint32_t b) const {
        const std::size_t d = cloud.dimension;
        double sum = 0;
        for (std::size_t axis = 0; axis < d; ++axis) {
            double along = std::abs(wrapped_[a * d + axis] - wrapped_[b * d + axis]);
            if (periods_[axis] > 0) along = std::min(along, periods_[axis] - along);
            sum += along * along;
        }
        return sum;
    }
    static double distance(double comparable) { return std::sqrt(comparable); }
    std::uint64_t memory() const { return wrapped_.capacity() * sizeof(double); }

private:
    std::vector<double> wrapped_;  // coordinates, from 0 to the period
    std::vector<double> periods_;
};

template <class Measure>
std::unique_ptr<DistanceRows> rows_by(const PointCloud& cloud, Measure measure) {
    return std::make_unique<Rows<Measure>>(cloud, std::move(measure));
}

}  // namespace

std::unique_ptr<DistanceRows> make_coordinate_rows(const PointCloud& cloud, const MetricOptions& options) {
    switch (options.metric) {
        case Metric::L1:
            return rows_by(cloud, SumOfDifferences{});
        case Metric::LInf:
            return rows_by(cloud, LargestDifference{});
        case Metric::Angular:
            return rows_by(cloud, Angle<false>(cloud));
        case Metric::Projective:
            return rows_by(cloud, Angle<true>(cloud));
        case Metric::Periodic:
            return rows_by(cloud, Periodic(cloud, options.box));
        default:
            return rows_by(cloud, Euclidean{});
    }
}

}  // namespace plateau
