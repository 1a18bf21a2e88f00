#include "reference/witness.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace plateau::reference {
namespace {

/// Summed in axis order, in double.
double distance_between(const PointCloud& cloud, std::size_t a, std::size_t b) {
    double sum = 0;
    for (std::size_t axis = 0; axis < cloud.dimension; ++axis) {
        const double along =
            cloud.coordinates[a * cloud.dimension + axis] - cloud.coordinates[b * cloud.dimension + axis];
        sum = sum + along * along;
    }
    return sum;
}

}  // namespace

FarthestOrder farthest_point_order(const PointCloud& cloud, int first, int max_steps) {
    const std::size_t n = cloud.coordinates.size() / cloud.dimension;
    FarthestOrder order;
    std::vector<double> nearest(n, std::numeric_limits<double>::infinity());  // squared, to the landmarks so far
    std::size_t next = static_cast<std::size_t>(first);
    do {
        order.landmarks.push_back(static_cast<int>(next));
        const std::size_t landmark = next;
        double epsilon_squared = -1;
        for (std::size_t w = 0; w < n; ++w) {
            nearest[w] = std::min(nearest[w], distance_between(cloud, w, landmark));
            if (nearest[w] > epsilon_squared) {
                epsilon_squared = nearest[w];
                next = w;
            }
        }
        order.epsilon_squared.push_back(epsilon_squared);
    } while (order.epsilon_squared.back() > 0 && static_cast<int>(order.landmarks.size()) < max_steps);
    return order;
}

std::vector<std::vector<int>> landmark_lists(const PointCloud& cloud, const FarthestOrder& order, int step) {
    const std::size_t n = cloud.coordinates.size() / cloud.dimension;
    std::vector<std::vector<int>> lists(n);
    for (std::size_t w = 0; w < n; ++w) {
        std::vector<std::pair<double, int>> ranked;
        for (int s = 1; s <= step; ++s) {
            const int landmark = order.landmarks[static_cast<std::size_t>(s - 1)];
            ranked.emplace_back(distance_between(cloud, w, static_cast<std::size_t>(landmark)), s);
        }
        std::sort(ranked.begin(), ranked.end());
        for (const auto& entry : ranked) lists[w].push_back(entry.second);
    }
    return lists;
}

Complex witness_complex(const std::vector<std::vector<int>>& lists, const std::vector<int>& nu, int max_dimension) {
    Complex result;
    for (int k = 0; k <= max_dimension && k < static_cast<int>(nu.size()); ++k) {
        const auto dimension = static_cast<std::size_t>(k);
        std::set<Simplex> witnessed;
        for (const std::vector<int>& list : lists) {
            const auto m = std::min<std::ptrdiff_t>(nu[dimension], static_cast<std::ptrdiff_t>(list.size()));
            Simplex nearest(list.begin(), list.begin() + m);
            std::sort(nearest.begin(), nearest.end());
            for (const Simplex& simplex : subsets(nearest, k + 1)) witnessed.insert(simplex);
        }
        for (const Simplex& simplex : witnessed) {
            bool faces_present = true;
            for (const Simplex& facet : facets(simplex)) {
                faces_present = faces_present && result[dimension - 1].count(facet) > 0;
            }
            if (faces_present) result[dimension].insert(simplex);
        }
    }
    return result;
}

}  // namespace plateau::reference
