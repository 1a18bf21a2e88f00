#include "cloud/spread_points.h"

#include <cmath>

namespace plateau {
namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFFu;

}  // namespace

SpreadPoints::SpreadPoints(std::uint32_t dimension, std::uint32_t size, double area)
    : dimension_(dimension), size_(size), least_distance_(0.5 * std::sqrt(area / size)) {
    std::size_t buckets = 16;
    while (buckets < size) buckets *= 2;
    first_in_bucket_.assign(buckets, kNone);
    next_in_bucket_.reserve(size);
    coordinates_.reserve(std::size_t{size} * dimension);
}

SpreadPoints::Cell SpreadPoints::cell_of(const std::array<double, 3>& point) const {
    Cell cell{};
    for (std::uint32_t axis = 0; axis < dimension_; ++axis) {
        cell[axis] = static_cast<std::int64_t>(std::floor(point[axis] / least_distance_));
    }
    return cell;
}

std::size_t SpreadPoints::bucket_of(const Cell& cell) const {
    std::uint64_t hash = 0;
    for (const std::int64_t index : cell) {
        hash = (hash ^ static_cast<std::uint64_t>(index)) * 0x9e3779b97f4a7c15ull;
        hash ^= hash >> 32;
    }
    return static_cast<std::size_t>(hash) & (first_in_bucket_.size() - 1);
}

bool SpreadPoints::is_close_to_any(const std::array<double, 3>& point) const {
    const double least_squared = least_distance_ * least_distance_;
    const Cell center = cell_of(point);
    const std::int64_t depth = dimension_ == 3 ? 1 : 0;
    for (std::int64_t x = -1; x <= 1; ++x) {
        for (std::int64_t y = -1; y <= 1; ++y) {
            for (std::int64_t z = -depth; z <= depth; ++z) {
                std::uint32_t other = first_in_bucket_[bucket_of({center[0] + x, center[1] + y, center[2] + z})];
                for (; other != kNone; other = next_in_bucket_[other]) {
                    double squared = 0;
                    for (std::uint32_t axis = 0; axis < dimension_; ++axis) {
                        const double difference = point[axis] - coordinates_[std::size_t{other} * dimension_ + axis];
                        squared += difference * difference;
                    }
                    if (squared < least_squared) return true;
                }
            }
        }
    }
    return false;
}

bool SpreadPoints::add(const std::array<double, 3>& point) {
    constexpr int kMostRefusals = 200;
    if (refusals_ < kMostRefusals && is_close_to_any(point)) {
        ++refusals_;
        return false;
    }
    refusals_ = 0;
    const std::size_t bucket = bucket_of(cell_of(point));
    next_in_bucket_.push_back(first_in_bucket_[bucket]);
    first_in_bucket_[bucket] = static_cast<std::uint32_t>(next_in_bucket_.size() - 1);
    coordinates_.insert(coordinates_.end(), point.begin(), point.begin() + dimension_);
    return true;
}

}  // namespace plateau
