#include "inspect/dilated_sightings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "dilated/cell_distance.h"

namespace plateau {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Landmarks near the simplex are those that cut its cell: with them in the pool few programs need a look at all.
void fill_pool(CellDistance& cell, const WeightedLandmarks& landmarks, std::span<const Step> simplex) {
    constexpr std::size_t kPool = 48;
    std::vector<std::pair<double, Step>> others;
    for (Step landmark = 1; landmark <= landmarks.size(); ++landmark) {
        double nearest = kInfinity;
        for (const Step vertex : simplex) {
            nearest = std::min(nearest, landmarks.distance_squared(landmark, landmarks.point(vertex)));
        }
        others.emplace_back(nearest, landmark);
    }
    std::sort(others.begin(), others.end());
    for (std::size_t i = 0; i < std::min(kPool, others.size()); ++i) cell.consider(others[i].second);
}

// The witnesses by the power of the vertex that they see worst: those that can be near the cell come first.
std::vector<std::pair<double, std::uint32_t>> by_largest_power(const PointCloud& witnesses,
                                                               const WeightedLandmarks& landmarks,
                                                               std::span<const Step> simplex) {
    std::vector<std::pair<double, std::uint32_t>> order;
    for (std::uint32_t witness = 0; witness < witnesses.size(); ++witness) {
        double largest = -kInfinity;
        for (const Step vertex : simplex) {
            largest = std::max(largest, landmarks.power(vertex, witnesses.point(witness).data()));
        }
        order.emplace_back(largest, witness);
    }
    std::sort(order.begin(), order.end());
    return order;
}

}  // namespace

Sightings dilated_sightings(const PointCloud& witnesses, const WeightedLandmarks& landmarks,
                            std::span<const Step> simplex, double zeta) {
    CellDistance cell(landmarks);
    cell.begin(simplex);
    fill_pool(cell, landmarks, simplex);
    Sightings found;
    std::pair<double, std::uint32_t> best{kInfinity, 0};
    for (const auto& [power, witness] : by_largest_power(witnesses, landmarks, simplex)) {
        const double* x = witnesses.point(witness).data();
        // Above rounding, so that equal distances are both exact.
        const double far = std::max(zeta, std::sqrt(best.first) * (1 + 0x1p-40));
        const double squared = cell.from(x, far, far);
        if (std::isnan(squared)) continue;  // not known
        if (squared <= zeta * zeta) found.witnesses.push_back({witness, 0, std::sqrt(squared)});
        best = std::min(best, {squared, witness});
    }
    if (best.first < kInfinity) found.best = Sighting{best.second, 0, std::sqrt(best.first)};
    found.witness_count = static_cast<std::uint32_t>(found.witnesses.size());
    std::sort(found.witnesses.begin(), found.witnesses.end(), [](const Sighting& a, const Sighting& b) {
        return a.distance < b.distance || (a.distance == b.distance && a.witness < b.witness);
    });
    if (found.witnesses.size() > kMaxSightings) found.witnesses.resize(kMaxSightings);
    return found;
}

}  // namespace plateau
