#include "landmarks/landmark_lists.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace plateau {

namespace {

constexpr std::uint32_t kLeafSize = 8;
constexpr std::uint32_t kNone = 0xFFFFFFFFu;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Rounding is monotone, so this never exceeds the rounded distance to a point in the box: pruning loses nothing.
double box_distance_squared(const std::array<double, 3>& low, const std::array<double, 3>& high,
                            const std::array<double, 3>& p) {
    double sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        double gap = 0;
        if (p[axis] < low[axis]) gap = low[axis] - p[axis];
        if (p[axis] > high[axis]) gap = p[axis] - high[axis];
        sum += gap * gap;
    }
    return sum;
}

double point_distance_squared(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    const double dx = a[0] - b[0];
    const double dy = a[1] - b[1];
    const double dz = a[2] - b[2];
    return dx * dx + dy * dy + dz * dz;
}

}  // namespace

LandmarkLists::LandmarkLists(const PointCloud& cloud, std::uint32_t kappa) : cloud_(&cloud), kappa_(kappa) {
    input_index_.resize(cloud.size());
    std::iota(input_index_.begin(), input_index_.end(), 0u);
    pending_.push_back({0, cloud.size(), kNone});
}

bool LandmarkLists::prepare(const Deadline& deadline) {
    for (bool first = true; !pending_.empty(); first = false) {
        if (!first && deadline.passed()) return false;
        const PendingRange range = pending_.back();
        pending_.pop_back();
        const auto index = static_cast<std::uint32_t>(nodes_.size());
        if (range.parent != kNone) nodes_[range.parent].right = index;

        Node node{{kInfinity, kInfinity, kInfinity},
                  {-kInfinity, -kInfinity, -kInfinity},
                  kInfinity,
                  kInfinity,
                  kNone,
                  range.begin,
                  range.end,
                  0};
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            const auto point = cloud_->point(input_index_[i]);
            for (std::uint32_t axis = 0; axis < 3; ++axis) {
                const double coordinate = axis < cloud_->dimension ? point[axis] : 0.0;
                node.low[axis] = std::min(node.low[axis], coordinate);
                node.high[axis] = std::max(node.high[axis], coordinate);
            }
        }
        nodes_.push_back(node);

        if (range.end - range.begin <= kLeafSize) {
            // nth_element leaves its halves in a library's own order.
            std::sort(input_index_.begin() + range.begin, input_index_.begin() + range.end);
            continue;
        }
        std::uint32_t widest = 0;
        for (std::uint32_t axis = 1; axis < cloud_->dimension; ++axis) {
            if (node.high[axis] - node.low[axis] > node.high[widest] - node.low[widest]) widest = axis;
        }
        split(range.begin, range.end, widest);
        const std::uint32_t middle = range.begin + (range.end - range.begin) / 2;
        pending_.push_back({middle, range.end, index});
        pending_.push_back({range.begin, middle, kNone});
    }
    if (witness_of_.empty()) {
        const std::uint32_t n = size();
        witness_of_.resize(n);
        points_.resize(n);
        for (WitnessId w = 0; w < n; ++w) {
            witness_of_[input_index_[w]] = w;
            const auto point = cloud_->point(input_index_[w]);
            points_[w] = {point[0], point[1], cloud_->dimension > 2 ? point[2] : 0.0};
        }
        distances_.assign(static_cast<std::size_t>(n) * kappa_, kInfinity);
        steps_.assign(static_cast<std::size_t>(n) * kappa_, 0);
    }
    return true;
}

void LandmarkLists::split(std::uint32_t begin, std::uint32_t end, std::uint32_t axis) {
    const auto first = input_index_.begin();
    std::nth_element(first + begin, first + begin + (end - begin) / 2, first + end,
                     [&](std::uint32_t a, std::uint32_t b) {
                         const double xa = cloud_->point(a)[axis];
                         const double xb = cloud_->point(b)[axis];
                         return xa < xb || (xa == xb && a < b);
                     });
}

std::span<const ListEntry> LandmarkLists::insert(std::uint32_t input_index, std::uint32_t step) {
    entries_.clear();
    visit(0, points_[witness_of_[input_index]], step);
    return entries_;
}

bool LandmarkLists::visit(std::uint32_t node_index, const Point& p, std::uint32_t step) {
    Node& node = nodes_[node_index];
    if (box_distance_squared(node.low, node.high, p) >= node.largest_last) return false;
    if (node.right == 0) {
        const std::size_t before = entries_.size();
        visit_leaf(node, p, step);
        return entries_.size() > before;
    }
    const bool changed_left = visit(node_index + 1, p, step);
    const bool changed_right = visit(node.right, p, step);
    if (!changed_left && !changed_right) return false;
    const Node& left = nodes_[node_index + 1];
    const Node& right = nodes_[node.right];
    node.largest_last = std::max(left.largest_last, right.largest_last);
    const bool left_wins = left.largest_first > right.largest_first ||
                           (left.largest_first == right.largest_first && left.farthest < right.farthest);
    node.largest_first = left_wins ? left.largest_first : right.largest_first;
    node.farthest = left_wins ? left.farthest : right.farthest;
    return true;
}

void LandmarkLists::visit_leaf(Node& node, const Point& p, std::uint32_t step) {
    node.largest_first = -1;
    node.largest_last = -1;
    for (WitnessId w = node.begin; w < node.end; ++w) {
        double* distances = distances_.data() + static_cast<std::size_t>(w) * kappa_;
        const double distance = point_distance_squared(points_[w], p);
        if (distance < distances[kappa_ - 1]) {
            std::uint32_t* steps = steps_.data() + static_cast<std::size_t>(w) * kappa_;
            std::uint32_t rank = kappa_ - 1;
            const std::uint32_t dropped = steps[rank];
            for (; rank > 0 && distances[rank - 1] > distance; --rank) {
                distances[rank] = distances[rank - 1];
                steps[rank] = steps[rank - 1];
            }
            distances[rank] = distance;
            steps[rank] = step;
            entries_.push_back({w, rank, dropped});
        }
        const bool farther = distances[0] > node.largest_first ||
                             (distances[0] == node.largest_first && input_index_[w] < node.farthest);
        if (farther) {
            node.largest_first = distances[0];
            node.farthest = input_index_[w];
        }
        node.largest_last = std::max(node.largest_last, distances[kappa_ - 1]);
    }
}

double LandmarkLists::nearest_other_squared(WitnessId witness) const {
    double nearest = kInfinity;
    search(0, witness, nearest);
    return nearest;
}

void LandmarkLists::search(std::uint32_t node_index, WitnessId witness, double& nearest) const {
    const Node& node = nodes_[node_index];
    const Point& p = points_[witness];
    if (box_distance_squared(node.low, node.high, p) >= nearest) return;
    if (node.right == 0) {
        for (WitnessId other = node.begin; other < node.end; ++other) {
            if (other != witness) nearest = std::min(nearest, point_distance_squared(points_[other], p));
        }
        return;
    }
    // The half that holds the witness first: it bounds the search in the other.
    const bool in_right = witness >= nodes_[node.right].begin;
    search(in_right ? node.right : node_index + 1, witness, nearest);
    search(in_right ? node_index + 1 : node.right, witness, nearest);
}

}  // namespace plateau
