#include "landmarks/noise_scale.h"

#include <algorithm>

namespace plateau {

namespace {

/// The order of the numbers around the middle does not count, so any algorithm gives the same.
double median_distance(std::vector<double>& comparable, const LandmarkLists& lists) {
    const auto middle = comparable.begin() + static_cast<std::ptrdiff_t>(comparable.size() / 2);
    std::nth_element(comparable.begin(), middle, comparable.end());
    if (comparable.size() % 2 == 1) return lists.distance(*middle);
    return (lists.distance(*std::max_element(comparable.begin(), middle)) + lists.distance(*middle)) / 2;
}

}  // namespace

bool NoiseScale::advance(const Deadline& deadline) {
    constexpr std::size_t kWitnessesAtOnce = 64;
    const std::size_t count = lists_->size();
    comparable_.reserve(count);
    do {
        const std::size_t end = std::min(count, comparable_.size() + kWitnessesAtOnce);
        for (std::size_t w = comparable_.size(); w < end; ++w) {
            comparable_.push_back(lists_->nearest_other_comparable(static_cast<WitnessId>(w)));
        }
    } while (comparable_.size() < count && !deadline.passed());
    if (comparable_.size() < count) return false;
    epsilon_ = median_distance(comparable_, *lists_);
    comparable_ = {};
    return true;
}

}  // namespace plateau
