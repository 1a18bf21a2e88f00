#include "reference/metrics.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace plateau::reference {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

using Numbers = std::vector<double>;

Numbers coordinates_of(const PointCloud& cloud, std::size_t point) {
    const auto begin = cloud.coordinates.begin() + static_cast<std::ptrdiff_t>(point * cloud.dimension);
    return {begin, begin + cloud.dimension};
}

Table table_by(const PointCloud& cloud, const std::function<double(const Numbers&, const Numbers&)>& distance) {
    const std::size_t n = cloud.coordinates.size() / cloud.dimension;
    Table table(n, Numbers(n));
    for (std::size_t a = 0; a < n; ++a) {
        for (std::size_t b = 0; b < n; ++b) table[a][b] = distance(coordinates_of(cloud, a), coordinates_of(cloud, b));
    }
    return table;
}

double squared(const Numbers& a, const Numbers& b) {
    double sum = 0;
    for (std::size_t axis = 0; axis < a.size(); ++axis) sum = sum + (b[axis] - a[axis]) * (b[axis] - a[axis]);
    return sum;
}

/// A cosine squared with its sign, as a fraction of integers.
struct Fraction {
    long long top = 0;
    long long bottom = 1;
};

bool less(const Fraction& a, const Fraction& b) {
    return static_cast<__int128>(a.top) * b.bottom < static_cast<__int128>(b.top) * a.bottom;
}

Fraction cosine_squared(const Numbers& a, const Numbers& b, bool lines) {
    long long dot = 0;
    long long length_a = 0;
    long long length_b = 0;
    for (std::size_t axis = 0; axis < a.size(); ++axis) {
        const auto x = static_cast<long long>(a[axis]);
        const auto y = static_cast<long long>(b[axis]);
        dot += x * y;
        length_a += x * x;
        length_b += y * y;
    }
    return {(dot < 0 && !lines ? -1 : 1) * dot * dot, length_a * length_b};
}

}  // namespace

Table euclidean_table(const PointCloud& cloud) {
    return table_by(cloud, squared);
}

Table sum_table(const PointCloud& cloud) {
    return table_by(cloud, [](const Numbers& a, const Numbers& b) {
        double sum = 0;
        for (std::size_t axis = 0; axis < a.size(); ++axis) {
            sum = sum + (a[axis] > b[axis] ? a[axis] - b[axis] : b[axis] - a[axis]);
        }
        return sum;
    });
}

Table maximum_table(const PointCloud& cloud) {
    return table_by(cloud, [](const Numbers& a, const Numbers& b) {
        double largest = 0;
        for (std::size_t axis = 0; axis < a.size(); ++axis) {
            largest = std::max({largest, a[axis] - b[axis], b[axis] - a[axis]});
        }
        return largest;
    });
}

Table periodic_table(const PointCloud& cloud, const std::vector<double>& box) {
    return table_by(cloud, [&](const Numbers& a, const Numbers& b) {
        double sum = 0;
        for (std::size_t axis = 0; axis < a.size(); ++axis) {
            const double straight = a[axis] - b[axis];
            double least = straight * straight;
            for (const double shift : {-box[axis], box[axis]}) {
                least = std::min(least, (straight + shift) * (straight + shift));
            }
            sum = sum + least;
        }
        return sum;
    });
}

Table angle_ranks(const PointCloud& cloud, bool lines) {
    const std::size_t n = cloud.coordinates.size() / cloud.dimension;
    std::vector<Fraction> all;
    for (std::size_t a = 0; a < n; ++a) {
        for (std::size_t b = 0; b < n; ++b) {
            all.push_back(cosine_squared(coordinates_of(cloud, a), coordinates_of(cloud, b), lines));
        }
    }
    std::sort(all.begin(), all.end(), [](const Fraction& a, const Fraction& b) { return less(b, a); });
    all.erase(std::unique(all.begin(), all.end(),
                          [](const Fraction& a, const Fraction& b) { return !less(a, b) && !less(b, a); }),
              all.end());
    // The largest cosine, 1, comes first: every point is with itself.
    return table_by(cloud, [&](const Numbers& a, const Numbers& b) {
        const Fraction own = cosine_squared(a, b, lines);
        std::size_t rank = 0;
        while (less(own, all[rank])) ++rank;
        return static_cast<double>(rank);
    });
}

Table angle_table(const PointCloud& cloud, bool lines) {
    return table_by(cloud, [&](const Numbers& a, const Numbers& b) {
        long double dot = 0;
        long double length_a = 0;
        long double length_b = 0;
        for (std::size_t axis = 0; axis < a.size(); ++axis) {
            dot += static_cast<long double>(a[axis]) * b[axis];
            length_a += static_cast<long double>(a[axis]) * a[axis];
            length_b += static_cast<long double>(b[axis]) * b[axis];
        }
        if (lines) dot = std::abs(dot);
        return static_cast<double>(std::atan2(std::sqrt(std::max(length_a * length_b - dot * dot, 0.0L)), dot));
    });
}

Table path_table(const PointCloud& cloud, int neighbors) {
    const std::size_t n = cloud.coordinates.size() / cloud.dimension;
    Table edge(n, Numbers(n, kInfinity));
    for (std::size_t a = 0; a < n; ++a) {
        std::vector<std::pair<double, std::size_t>> others;
        for (std::size_t b = 0; b < n; ++b) {
            if (a != b) others.emplace_back(squared(coordinates_of(cloud, a), coordinates_of(cloud, b)), b);
        }
        std::sort(others.begin(), others.end());
        for (std::size_t k = 0; k < others.size() && k < static_cast<std::size_t>(neighbors); ++k) {
            const auto& [length_squared, b] = others[k];
            edge[a][b] = edge[b][a] = std::sqrt(length_squared);
        }
    }
    Table table(n, Numbers(n, kInfinity));
    for (std::size_t from = 0; from < n; ++from) {
        Numbers& row = table[from];
        row[from] = 0;
        for (bool changed = true; changed;) {
            changed = false;
            for (std::size_t a = 0; a < n; ++a) {
                for (std::size_t b = 0; b < n; ++b) {
                    if (!(row[a] + edge[a][b] < row[b])) continue;
                    row[b] = row[a] + edge[a][b];
                    changed = true;
                }
            }
        }
    }
    return table;
}

TableOrder farthest_order(const Table& table, int first) {
    TableOrder order;
    Numbers nearest(table.size(), kInfinity);
    auto next = static_cast<std::size_t>(first);
    do {
        order.landmarks.push_back(static_cast<int>(next));
        for (std::size_t w = 0; w < table.size(); ++w) nearest[w] = std::min(nearest[w], table[next][w]);
        const auto farthest = std::max_element(nearest.begin(), nearest.end());
        next = static_cast<std::size_t>(farthest - nearest.begin());
        order.epsilon.push_back(*farthest);
    } while (order.epsilon.back() > 0);
    return order;
}

std::vector<std::vector<int>> lists_of(const Table& table, const TableOrder& order, int step) {
    std::vector<std::vector<int>> lists(table.size());
    for (std::size_t w = 0; w < table.size(); ++w) {
        std::vector<std::pair<double, int>> ranked;
        for (int s = 1; s <= step; ++s) {
            const auto landmark = static_cast<std::size_t>(order.landmarks[static_cast<std::size_t>(s - 1)]);
            ranked.emplace_back(table[landmark][w], s);
        }
        std::sort(ranked.begin(), ranked.end());
        for (const auto& entry : ranked) lists[w].push_back(entry.second);
    }
    return lists;
}

}  // namespace plateau::reference
