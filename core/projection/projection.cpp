#include "projection/projection.h"

// Vectors of the processor's size would add up in an order of their own.
#define EIGEN_DONT_VECTORIZE

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

namespace plateau {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::uint32_t kMostPivots = 400;
constexpr double kMostOperations = 4e8;
constexpr std::size_t kMostKeptDistances = 16'000'000;
constexpr double kNothing = 1e-12;   // of the largest eigenvalue
constexpr double kRounding = 1e-24;  // of the squares that were summed

struct Axes {
    MatrixXd directions;  // one a column, length 1
    VectorXd spread;      // their eigenvalues, falling, all positive
    std::vector<double> shares;
};

// Products are summed in blocks of the size of the caches, which must not be those of the machine.
void settle_blocks() {
    Eigen::setCpuCacheSizes(1 << 15, 1 << 18, 1 << 21);
}

// The leading eigenvectors of a symmetric matrix whose entries are sums of squares as large as `squares`.
Axes leading_axes(const MatrixXd& symmetric, double squares) {
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solved(symmetric);
    const VectorXd& values = solved.eigenvalues();  // rising
    const Index size = values.size();
    const double all = values.cwiseAbs().sum();
    const double least = std::max(kNothing * values[size - 1], kRounding * squares);
    Index count = 0;
    while (count < std::min<Index>(size, kMostAxes) && values[size - 1 - count] > least) ++count;
    Axes axes{MatrixXd(size, count), VectorXd(count), {}};
    for (Index k = 0; k < count; ++k) {
        VectorXd direction = solved.eigenvectors().col(size - 1 - k);
        // A direction and its opposite are the same axis; the largest entry points ahead.
        Index largest = 0;
        direction.cwiseAbs().maxCoeff(&largest);
        if (direction[largest] < 0) direction = -direction;
        axes.directions.col(k) = direction;
        axes.spread[k] = values[size - 1 - k];
        axes.shares.push_back(all > 0 ? values[size - 1 - k] / all : 0);
    }
    return axes;
}

// The squared distances of some pivots, farthest first, to all witnesses.
struct Pivots {
    std::vector<std::uint32_t> witness;
    MatrixXd squared;  // a row a pivot
};

Pivots choose_pivots(std::uint32_t count, std::uint32_t most, const DistanceRow& row) {
    Pivots pivots{{}, MatrixXd(most, count)};
    std::vector<double> distances(count);
    std::vector<double> nearest(count, std::numeric_limits<double>::infinity());
    std::uint32_t next = 0;
    while (pivots.witness.size() < most) {
        const auto place = static_cast<Index>(pivots.witness.size());
        pivots.witness.push_back(next);
        row(next, distances);
        for (std::uint32_t w = 0; w < count; ++w) {
            pivots.squared(place, w) = distances[w] * distances[w];
            nearest[w] = std::min(nearest[w], distances[w]);
        }
        next = static_cast<std::uint32_t>(std::max_element(nearest.begin(), nearest.end()) - nearest.begin());
        if (nearest[next] == 0) break;  // the others are duplicates
    }
    pivots.squared.conservativeResize(static_cast<Index>(pivots.witness.size()), Eigen::NoChange);
    return pivots;
}

}  // namespace

Projection principal_axes(const PointCloud& cloud) {
    settle_blocks();
    const std::uint32_t n = cloud.size();
    const auto d = static_cast<Index>(cloud.dimension);
    const auto row = [&](std::uint32_t index) { return Eigen::Map<const VectorXd>(cloud.point(index).data(), d); };
    const double rows = std::max(1.0, kMostOperations / static_cast<double>(d * d));
    const auto every = static_cast<std::uint32_t>(std::max(1.0, std::ceil(n / rows)));

    VectorXd mean = VectorXd::Zero(d);
    for (std::uint32_t i = 0; i < n; ++i) mean += row(i) / n;
    MatrixXd covariance = MatrixXd::Zero(d, d);
    double squares = 0;
    for (std::uint32_t i = 0; i < n; i += every) {
        const VectorXd away = row(i) - mean;
        covariance.selfadjointView<Eigen::Lower>().rankUpdate(away);
        squares += row(i).squaredNorm();
    }
    const Axes axes = leading_axes(covariance.selfadjointView<Eigen::Lower>(), squares);
    Projection projection{static_cast<std::uint32_t>(axes.spread.size()), {}, axes.shares};
    projection.coordinates.reserve(static_cast<std::size_t>(n) * projection.axes);
    for (std::uint32_t i = 0; i < n; ++i) {
        const VectorXd along = axes.directions.transpose() * (row(i) - mean);
        for (const double value : along) projection.coordinates.push_back(static_cast<float>(value));
    }
    return projection;
}

Projection classical_scaling(std::uint32_t count, const DistanceRow& row) {
    settle_blocks();
    const auto affordable = static_cast<std::uint32_t>(std::max<std::size_t>(kMostKeptDistances / count, 16));
    const Pivots pivots = choose_pivots(count, std::min({count, kMostPivots, affordable}), row);
    const auto m = static_cast<Index>(pivots.witness.size());
    MatrixXd between(m, m);
    for (Index j = 0; j < m; ++j) between.col(j) = pivots.squared.col(pivots.witness[static_cast<std::size_t>(j)]);
    const VectorXd mean = between.rowwise().mean();
    // Doubly centered: the inner products of the pivots around their middle.
    MatrixXd products = between.colwise() - mean;
    products.rowwise() -= products.colwise().mean();
    products *= -0.5;
    const Axes axes = leading_axes((products + products.transpose()) / 2, between.sum());

    Projection projection{static_cast<std::uint32_t>(axes.spread.size()), {}, axes.shares};
    projection.coordinates.reserve(static_cast<std::size_t>(count) * projection.axes);
    const MatrixXd place = axes.spread.cwiseSqrt().cwiseInverse().asDiagonal() * axes.directions.transpose() * -0.5;
    for (std::uint32_t w = 0; w < count; ++w) {
        const VectorXd along = place * (pivots.squared.col(w) - mean);
        for (const double value : along) projection.coordinates.push_back(static_cast<float>(value));
    }
    return projection;
}

Projection projection_of(const PointCloud& cloud) {
    if (cloud.dimension > 0) return principal_axes(cloud);
    const DistanceMatrix& distances = cloud.distances;
    return classical_scaling(distances.size,
                             [&](std::uint32_t witness, std::span<double> row) { distances.row(witness, row); });
}

}  // namespace plateau
