#include "metrics/geodesic_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plateau {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::uint32_t kNone = 0xFFFFFFFFu;

}  // namespace

GeodesicRows::GeodesicRows(const PointCloud& cloud, std::uint32_t neighbors)
    : neighbors_(std::min(neighbors, cloud.size() - 1)), tree_(cloud) {}

bool GeodesicRows::prepare(const Deadline& deadline) {
    constexpr std::uint32_t kWitnessesAtOnce = 64;
    if (!first_edge_.empty()) return true;
    if (!tree_.prepare(deadline)) return false;
    const std::uint32_t n = tree_.size();
    std::vector<KdTree::Neighbor> found;
    while (nearest_.size() < static_cast<std::size_t>(n) * neighbors_) {
        for (std::uint32_t k = 0; k < kWitnessesAtOnce; ++k) {
            const auto witness = static_cast<std::uint32_t>(nearest_.size() / neighbors_);
            if (witness == n) break;
            tree_.nearest_others(tree_.position(witness), neighbors_, found);
            for (const auto& [squared, other] : found) nearest_.push_back({other, std::sqrt(squared)});
        }
        if (deadline.passed()) return false;
    }
    join();
    look_for_pieces();
    return true;
}

bool GeodesicRows::chose(std::uint32_t witness, std::uint32_t other) const {
    for (const Edge& edge : chosen(witness)) {
        if (edge.to == other) return true;
    }
    return false;
}

// Every edge once at each of its ends.
void GeodesicRows::join() {
    const std::uint32_t n = tree_.size();
    const auto visit = [&](const auto& use) {
        for (std::uint32_t witness = 0; witness < n; ++witness) {
            for (const Edge& edge : chosen(witness)) {
                use(witness, edge.to, edge.length);
                if (!chose(edge.to, witness)) use(edge.to, witness, edge.length);
            }
        }
    };
    first_edge_.assign(std::size_t{n} + 1, 0);
    visit([&](std::uint32_t from, std::uint32_t, double) { ++first_edge_[from + 1]; });
    for (std::uint32_t witness = 0; witness < n; ++witness) first_edge_[witness + 1] += first_edge_[witness];
    edges_.resize(first_edge_.back());
    std::vector<std::size_t> next = first_edge_;
    visit([&](std::uint32_t from, std::uint32_t to, double length) { edges_[next[from]++] = {to, length}; });
    nearest_ = {};
}

void GeodesicRows::look_for_pieces() {
    const std::uint32_t n = tree_.size();
    std::vector<std::uint32_t> piece(n, kNone);
    std::vector<std::uint32_t> size, first, stack;
    for (std::uint32_t start = 0; start < n; ++start) {
        if (piece[start] != kNone) continue;
        const auto number = static_cast<std::uint32_t>(size.size());
        size.push_back(0);
        first.push_back(start);
        piece[start] = number;
        stack.push_back(start);
        while (!stack.empty()) {
            const std::uint32_t witness = stack.back();
            stack.pop_back();
            ++size[number];
            for (std::size_t e = first_edge_[witness]; e < first_edge_[witness + 1]; ++e) {
                const std::uint32_t other = edges_[e].to;
                if (piece[other] != kNone) continue;
                piece[other] = number;
                stack.push_back(other);
            }
        }
    }
    if (size.size() == 1) return;
    const auto smallest = std::min_element(size.begin(), size.end()) - size.begin();
    const auto at = static_cast<std::size_t>(smallest);
    failure_ = Error{ErrorCode::InvalidOption,
                     "The graph of the " + std::to_string(neighbors_) + " nearest neighbors falls into " +
                         std::to_string(size.size()) + " pieces, the smallest of " + std::to_string(size[at]) +
                         (size[at] == 1 ? " point" : " points") + " around point " + std::to_string(first[at] + 1) +
                         ": take more neighbors, or each piece by itself."};
}

void GeodesicRows::fill(std::uint32_t witness, const Limits& limits, std::span<double> row) {
    std::fill(row.begin(), row.end(), kInfinity);
    row[witness] = 0;
    heap_.assign(1, {0, witness});
    while (!heap_.empty()) {
        std::pop_heap(heap_.begin(), heap_.end());
        const auto [distance, from] = heap_.back();
        heap_.pop_back();
        if (distance > row[from] || !(distance < limits[from])) continue;
        for (std::size_t e = first_edge_[from]; e < first_edge_[from + 1]; ++e) {
            const auto [to, length] = edges_[e];
            const double through = distance + length;
            if (!(through < row[to]) || !(through < limits[to])) continue;
            row[to] = through;
            heap_.push_back({through, to});
            std::push_heap(heap_.begin(), heap_.end());
        }
    }
}

double GeodesicRows::nearest_other(std::uint32_t witness, std::span<double>) {
    double nearest = kInfinity;
    for (std::size_t e = first_edge_[witness]; e < first_edge_[witness + 1]; ++e) {
        nearest = std::min(nearest, edges_[e].length);
    }
    return nearest;
}

std::uint64_t GeodesicRows::memory() const {
    return (edges_.capacity() + nearest_.capacity()) * sizeof(Edge) + first_edge_.capacity() * sizeof(std::size_t);
}

}  // namespace plateau
