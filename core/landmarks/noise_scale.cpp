#include "landmarks/noise_scale.h"

#include <algorithm>
#include <cmath>

namespace plateau {

namespace {

/// The order of the numbers around the middle does not count, so any algorithm gives the same.
double median_root(std::vector<double>& squares) {
    const auto middle = squares.begin() + static_cast<std::ptrdiff_t>(squares.size() / 2);
    std::nth_element(squares.begin(), middle, squares.end());
    if (squares.size() % 2 == 1) return std::sqrt(*middle);
    return (std::sqrt(*std::max_element(squares.begin(), middle)) + std::sqrt(*middle)) / 2;
}

}  // namespace

bool NoiseScale::advance(const Deadline& deadline) {
    constexpr std::size_t kWitnessesAtOnce = 64;
    const std::size_t count = lists_->size();
    distances_squared_.reserve(count);
    do {
        const std::size_t end = std::min(count, distances_squared_.size() + kWitnessesAtOnce);
        for (std::size_t w = distances_squared_.size(); w < end; ++w) {
            distances_squared_.push_back(lists_->nearest_other_squared(static_cast<WitnessId>(w)));
        }
    } while (distances_squared_.size() < count && !deadline.passed());
    if (distances_squared_.size() < count) return false;
    epsilon_ = median_root(distances_squared_);
    distances_squared_ = {};
    return true;
}

}  // namespace plateau
