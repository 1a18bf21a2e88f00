#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "complex/simplex_table.h"

namespace plateau {

/// Family dilated is for R^d with d up to this.
inline constexpr std::size_t kMaxDilatedDimension = 5;

/// The landmarks of family dilated, by step: where they are, and omega(p)^2, the square of the weight [BGO].
/// The power of a landmark p at a point c is |c - p|^2 - omega(p)^2.
class WeightedLandmarks {
public:
    explicit WeightedLandmarks(std::uint32_t dimension) : dimension_(dimension) {}

    /// The landmark of the next step.
    void add(std::span<const double> point, double weight_squared) {
        coordinates_.insert(coordinates_.end(), point.begin(), point.end());
        weights_squared_.push_back(weight_squared);
        largest_weight_squared_ = std::max(largest_weight_squared_, weight_squared);
    }
    /// Gives the youngest landmark another weight.
    void reweigh(double weight_squared) {
        weights_squared_.back() = weight_squared;
        largest_weight_squared_ = std::max(largest_weight_squared_, weight_squared);
    }

    std::uint32_t dimension() const { return dimension_; }
    std::uint32_t size() const { return static_cast<std::uint32_t>(weights_squared_.size()); }
    const double* point(Step landmark) const {
        return coordinates_.data() + static_cast<std::size_t>(landmark - 1) * dimension_;
    }
    double weight_squared(Step landmark) const { return weights_squared_[landmark - 1]; }
    /// At least that of every landmark so far, and of any that was tried.
    double largest_weight_squared() const { return largest_weight_squared_; }
    std::uint64_t memory() const { return sizeof(double) * (coordinates_.capacity() + weights_squared_.capacity()); }

    double distance_squared(Step landmark, const double* c) const {
        const double* p = point(landmark);
        double sum = 0;
        for (std::size_t axis = 0; axis < dimension_; ++axis) {
            const double along = p[axis] - c[axis];
            sum += along * along;
        }
        return sum;
    }
    double power(Step landmark, const double* c) const {
        return distance_squared(landmark, c) - weight_squared(landmark);
    }

private:
    std::uint32_t dimension_;
    std::vector<double> coordinates_;
    std::vector<double> weights_squared_;
    double largest_weight_squared_ = 0;
};

}  // namespace plateau
