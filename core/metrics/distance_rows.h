#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>

#include "base/deadline.h"
#include "base/result.h"
#include "cloud/point_cloud.h"
#include "metrics/metric.h"

namespace plateau {

/// How large a comparable distance has to be for a witness to be out of interest.
class Limits {
public:
    /// None: every distance is of interest.
    Limits() = default;
    /// That of witness w is first[w * stride].
    Limits(const double* first, std::size_t stride) : first_(first), stride_(stride) {}
    double operator[](std::uint32_t witness) const {
        return first_ == nullptr ? std::numeric_limits<double>::infinity() : first_[witness * stride_];
    }

private:
    const double* first_ = nullptr;
    std::size_t stride_ = 0;
};

/// Where distances come from: one row of them after the other, each from one witness to all.
///
/// What a row holds are *comparable distances*: numbers that are at least 0, are 0 for a distance of 0 and order as the
/// distances do, made of + - * / and square roots alone, so that they are the same bits everywhere. Squared distances
/// are comparable.
class DistanceRows {
public:
    virtual ~DistanceRows() = default;

    /// Gets ready until the deadline passes; true when there is nothing left to do, also after a failure.
    virtual bool prepare(const Deadline& deadline);
    /// Why no row can be made, once prepared.
    virtual std::optional<Error> failure() const { return std::nullopt; }

    /// The comparable distances from the witness to all, `row` one a witness; what is not below its limit may be any
    /// other number that is not below it.
    virtual void fill(std::uint32_t witness, const Limits& limits, std::span<double> row) = 0;
    /// The least comparable distance from the witness to another one, infinity where there is none; `row` is scratch,
    /// one number a witness.
    virtual double nearest_other(std::uint32_t witness, std::span<double> row);
    /// The distance, in input units (angles: radians), of a comparable one.
    virtual double distance(double comparable) const = 0;
    /// Bytes held beyond the cloud.
    virtual std::uint64_t memory() const { return 0; }
};

/// The rows of a cloud under a metric. `cloud` must outlive them. Precondition: check_metric() has no objection.
std::unique_ptr<DistanceRows> make_distance_rows(const PointCloud& cloud, const MetricOptions& options);

/// Bytes that they will hold.
std::uint64_t estimated_rows_memory(const PointCloud& cloud, const MetricOptions& options);

/// Why the metric cannot be taken for this cloud: no coordinates, or none that it can use (a zero vector has no
/// direction), or options that make no sense. InvalidOption, with a sentence that says what to do.
std::optional<Error> check_metric(const PointCloud& cloud, const MetricOptions& options);

}  // namespace plateau
