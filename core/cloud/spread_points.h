#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace plateau {

/// Points with a least distance between any two of them. Purely random points come in pairs that nearly coincide, and
/// at the smallest scales those pairs would pass for long plateaus.
class SpreadPoints {
public:
    /// Room for `size` points of `dimension` 2 or 3 spread over a curve's strip or a surface of about the given area:
    /// the least distance is half of sqrt(area / size). Precondition: size >= 1.
    SpreadPoints(std::uint32_t dimension, std::uint32_t size, double area);

    /// Takes the point unless it is too close to one taken before; true if it was taken. After 200 refusals in a row
    /// the next is taken in any case, so that every loop ends. Cost: O(1) expected.
    bool add(const std::array<double, 3>& point);

    bool full() const { return coordinates_.size() == std::size_t{size_} * dimension_; }
    /// The rows taken, `dimension` numbers each.
    std::vector<double> take() { return std::move(coordinates_); }

private:
    using Cell = std::array<std::int64_t, 3>;
    Cell cell_of(const std::array<double, 3>& point) const;
    std::size_t bucket_of(const Cell& cell) const;
    bool is_close_to_any(const std::array<double, 3>& point) const;

    std::uint32_t dimension_;
    std::uint32_t size_;
    double least_distance_;
    int refusals_ = 0;
    std::vector<double> coordinates_;
    std::vector<std::uint32_t> first_in_bucket_;  ///< hash of the grid cell -> last point taken there
    std::vector<std::uint32_t> next_in_bucket_;   ///< by point
};

}  // namespace plateau
