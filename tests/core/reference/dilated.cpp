#include "reference/dilated.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace plateau::reference {

namespace {

using Real = long double;
using Row = std::vector<Real>;

Real dot(const Row& a, const Row& b) {
    Real sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

// The least squares solution over the chosen columns, by reflections and back substitution: normal equations would
// square how ill-posed near contradictions are.
Row least_squares(const std::vector<Row>& columns, const std::vector<int>& chosen, const Row& right) {
    const std::size_t n = chosen.size();
    std::vector<Row> matrix;  // by column, the right side last
    for (const int column : chosen) matrix.push_back(columns[static_cast<std::size_t>(column)]);
    matrix.push_back(right);
    const std::size_t rows = right.size();
    for (std::size_t i = 0; i < std::min(n, rows); ++i) {
        Row mirror(rows, 0);
        for (std::size_t row = i; row < rows; ++row) mirror[row] = matrix[i][row];
        const Real length = std::sqrt(dot(mirror, mirror));
        mirror[i] += mirror[i] < 0 ? -length : length;
        const Real squared = dot(mirror, mirror);
        if (squared == 0) continue;
        for (std::size_t j = i; j <= n; ++j) {
            const Real twice = 2 * dot(mirror, matrix[j]) / squared;
            for (std::size_t row = i; row < rows; ++row) matrix[j][row] -= twice * mirror[row];
        }
    }
    Row solution(n, 0);
    for (std::size_t i = std::min(n, rows); i-- > 0;) {
        Real rest = matrix[n][i];
        for (std::size_t j = i + 1; j < n; ++j) rest -= matrix[j][i] * solution[j];
        solution[i] = matrix[i][i] == 0 ? 0 : rest / matrix[i][i];
    }
    return solution;
}

// What non-negative multiples of the columns leave of `right` at least (Lawson and Hanson).
Row residual_of_nonnegative(const std::vector<Row>& columns, const Row& right) {
    constexpr Real kTolerance = 1e-15L;
    std::vector<int> chosen;
    Row multiples;
    Row residual = right;
    for (int round = 0; round < 500; ++round) {
        int best = -1;
        Real largest = kTolerance;
        for (std::size_t j = 0; j < columns.size(); ++j) {
            if (std::count(chosen.begin(), chosen.end(), static_cast<int>(j)) > 0) continue;
            const Real gain = dot(columns[j], residual);
            if (gain > largest) {
                largest = gain;
                best = static_cast<int>(j);
            }
        }
        if (best < 0) return residual;
        chosen.push_back(best);
        multiples.push_back(0);
        for (;;) {
            const Row wanted = least_squares(columns, chosen, right);
            Real share = 1;
            for (std::size_t i = 0; i < wanted.size(); ++i) {
                if (wanted[i] <= 0) share = std::min(share, multiples[i] / (multiples[i] - wanted[i]));
            }
            if (std::isnan(share)) share = 0;
            for (std::size_t i = 0; i < wanted.size(); ++i) multiples[i] += share * (wanted[i] - multiples[i]);
            if (share == 1) break;
            for (std::size_t i = chosen.size(); i-- > 0;) {
                if (multiples[i] > 0 && wanted[i] > 0) continue;
                if (multiples[i] > kTolerance) continue;
                chosen.erase(chosen.begin() + static_cast<std::ptrdiff_t>(i));
                multiples.erase(multiples.begin() + static_cast<std::ptrdiff_t>(i));
            }
        }
        residual = right;
        for (std::size_t i = 0; i < chosen.size(); ++i) {
            for (std::size_t axis = 0; axis < right.size(); ++axis) {
                residual[axis] -= multiples[i] * columns[static_cast<std::size_t>(chosen[i])][axis];
            }
        }
    }
    return residual;
}

}  // namespace

namespace {

/// A landmark seen from a witness.
struct Site {
    Row place;
    Real power;
};

std::vector<Site> seen_from(const std::vector<double>& point, const std::vector<std::vector<double>>& sites,
                            const std::vector<double>& weights_squared) {
    std::vector<Site> seen;
    for (std::size_t i = 0; i < sites.size(); ++i) {
        Row place(point.size());
        for (std::size_t axis = 0; axis < point.size(); ++axis) {
            place[axis] = static_cast<Real>(sites[i][axis]) - static_cast<Real>(point[axis]);
        }
        const Real power = dot(place, place) - static_cast<Real>(weights_squared[i]);
        seen.push_back({place, power});
    }
    return seen;
}

/// The distance of the witness to the cell of a simplex (places among the sites), or infinity if it is more than
/// `limit`.
Real cell_distance(const std::vector<Site>& seen, const std::vector<int>& simplex, Real limit) {
    constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
    const std::size_t axes = seen[0].place.size();
    // Each constraint of unit length as a column (its direction, its offset in limits): the direction times y is at
    // least the offset.
    std::vector<Row> columns;
    for (const int vertex : simplex) {
        const Site& v = seen[static_cast<std::size_t>(vertex)];
        for (std::size_t other = 0; other < seen.size(); ++other) {
            if (std::count(simplex.begin(), simplex.end(), static_cast<int>(other)) > 0) continue;
            const Site& q = seen[other];
            Real length = 0;
            for (std::size_t axis = 0; axis < axes; ++axis) {
                length += (v.place[axis] - q.place[axis]) * (v.place[axis] - q.place[axis]);
            }
            length = std::sqrt(length);
            const Real offset = (v.power - q.power) / (2 * length) / limit;
            if (offset > 1) return kInfinity;
            if (offset < -1) continue;  // holds all around
            Row column(axes + 1);
            for (std::size_t axis = 0; axis < axes; ++axis) column[axis] = (v.place[axis] - q.place[axis]) / length;
            column[axes] = offset;
            columns.push_back(column);
        }
    }
    Row right(axes + 1, 0);
    right[axes] = 1;
    const Row residual = residual_of_nonnegative(columns, right);
    // The last entry is 1 / (1 + distance^2), and 0 where the cell is empty.
    const Real rest = residual[axes];
    if (rest < 0.1L) return kInfinity;
    Real squared = 0;
    for (std::size_t axis = 0; axis < axes; ++axis) squared += (residual[axis] / rest) * (residual[axis] / rest);
    return std::sqrt(squared) * limit;
}

}  // namespace

namespace {

DilatedState complex_of(const PointCloud& cloud, const DilatedSettings& settings, bool only_around_youngest) {
    const auto coordinates = [&](int index) {
        const auto point = cloud.point(static_cast<std::uint32_t>(index));
        return std::vector<double>(point.begin(), point.end());
    };
    std::vector<std::vector<double>> sites;
    for (const int landmark : settings.landmarks) sites.push_back(coordinates(landmark));
    std::set<std::vector<double>> witnesses;
    for (int i = 0; i < static_cast<int>(cloud.size()); ++i) witnesses.insert(coordinates(i));
    std::vector<std::vector<Site>> views;
    for (const auto& witness : witnesses) views.push_back(seen_from(witness, sites, settings.weights_squared));

    DilatedState state;
    const Real limit = static_cast<Real>(settings.zeta) + 2 * static_cast<Real>(settings.doubt);
    const auto is_witnessed = [&](const Simplex& simplex) {
        std::vector<int> indices;
        for (const int vertex : simplex) indices.push_back(vertex - 1);
        Real least = std::numeric_limits<Real>::infinity();
        for (const auto& seen : views) {
            least = std::min(least, cell_distance(seen, indices, limit));
            if (least <= static_cast<Real>(settings.zeta) - static_cast<Real>(settings.doubt)) return true;
        }
        if (std::fabs(least - static_cast<Real>(settings.zeta)) <= static_cast<Real>(settings.doubt))
            state.in_doubt = true;
        return least <= static_cast<Real>(settings.zeta);
    };
    const int count = static_cast<int>(settings.landmarks.size());
    for (int vertex = 1; vertex <= count; ++vertex) {
        if (only_around_youngest && vertex < count && !is_witnessed({vertex, count})) continue;
        if (is_witnessed({vertex})) state.complex[0].insert({vertex});
    }
    for (std::size_t k = 1; k <= cloud.dimension + 1; ++k) {
        for (const Simplex& simplex : state.complex[k - 1]) {
            for (int vertex = simplex.back() + 1; vertex <= count; ++vertex) {
                Simplex candidate = simplex;
                candidate.push_back(vertex);
                const auto faces = facets(candidate);
                const bool has_faces = std::all_of(faces.begin(), faces.end(), [&](const Simplex& face) {
                    return state.complex[k - 1].count(face) > 0;
                });
                if (has_faces && is_witnessed(candidate)) state.complex[k].insert(candidate);
            }
        }
    }
    return state;
}

}  // namespace

DilatedState dilated_complex(const PointCloud& cloud, const DilatedSettings& settings) {
    return complex_of(cloud, settings, false);
}

DilatedState dilated_complex_around_youngest(const PointCloud& cloud, const DilatedSettings& settings) {
    return complex_of(cloud, settings, true);
}

std::vector<double> distances_to_cell(const PointCloud& cloud, const DilatedSettings& settings, const Simplex& simplex,
                                      double limit) {
    const auto coordinates = [&](std::uint32_t index) {
        const auto point = cloud.point(index);
        return std::vector<double>(point.begin(), point.end());
    };
    std::vector<std::vector<double>> sites;
    for (const int landmark : settings.landmarks) sites.push_back(coordinates(static_cast<std::uint32_t>(landmark)));
    std::vector<int> places;
    for (const int vertex : simplex) places.push_back(vertex - 1);
    std::vector<double> distances;
    for (std::uint32_t witness = 0; witness < cloud.size(); ++witness) {
        const auto seen = seen_from(coordinates(witness), sites, settings.weights_squared);
        distances.push_back(static_cast<double>(cell_distance(seen, places, static_cast<Real>(limit))));
    }
    return distances;
}

double sliver_measure(const PointCloud& cloud, const std::vector<int>& landmarks, const Simplex& simplex,
                      bool normalized) {
    const std::size_t k = simplex.size() - 1;
    if (k < 2) return 1;
    std::vector<Row> points;
    for (const int vertex : simplex) {
        const auto point = cloud.point(static_cast<std::uint32_t>(landmarks[static_cast<std::size_t>(vertex - 1)]));
        points.emplace_back(point.begin(), point.end());
    }
    const auto between = [&](std::size_t a, std::size_t b) {
        Row difference(points[a].size());
        for (std::size_t axis = 0; axis < difference.size(); ++axis)
            difference[axis] = points[b][axis] - points[a][axis];
        return difference;
    };
    Real shortest = std::numeric_limits<Real>::infinity();
    for (std::size_t a = 0; a <= k; ++a) {
        for (std::size_t b = 0; b < a; ++b) shortest = std::min(shortest, std::sqrt(dot(between(a, b), between(a, b))));
    }
    std::vector<Row> gram(k, Row(k));
    for (std::size_t i = 0; i < k; ++i) {
        for (std::size_t j = 0; j < k; ++j) gram[i][j] = dot(between(0, i + 1), between(0, j + 1));
    }
    Real determinant = 1;
    for (std::size_t i = 0; i < k; ++i) {
        determinant *= gram[i][i];
        if (gram[i][i] == 0) return 0;
        for (std::size_t row = i + 1; row < k; ++row) {
            const Real factor = gram[row][i] / gram[i][i];
            for (std::size_t j = i; j < k; ++j) gram[row][j] -= factor * gram[i][j];
        }
    }
    const auto degree = static_cast<Real>(k);
    const Real scaled = std::sqrt(std::max<Real>(determinant, 0)) / std::pow(shortest, degree);
    const Real measure = normalized ? std::pow(scaled, 1 / degree) : scaled / std::tgamma(degree + 1);
    return static_cast<double>(measure);
}

}  // namespace plateau::reference
