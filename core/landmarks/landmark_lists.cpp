#include "landmarks/landmark_lists.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace plateau {

namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFFu;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

LandmarkLists::LandmarkLists(const PointCloud& cloud, std::uint32_t kappa)
    : size_(cloud.size()), kappa_(kappa), tree_(cloud) {}

LandmarkLists::LandmarkLists(std::unique_ptr<DistanceRows> rows, std::uint32_t witnesses, std::uint32_t kappa)
    : size_(witnesses), kappa_(kappa), rows_(std::move(rows)), row_(witnesses) {}

bool LandmarkLists::prepare(const Deadline& deadline) {
    const bool ready = tree_ ? tree_->prepare(deadline) : rows_->prepare(deadline);
    if (ready && extremes_.empty()) {
        extremes_.assign(tree_ ? tree_->node_count() : 1, {kInfinity, kInfinity, kNone});
        comparable_.assign(static_cast<std::size_t>(size_) * kappa_, kInfinity);
        steps_.assign(static_cast<std::size_t>(size_) * kappa_, 0);
    }
    return ready;
}

double LandmarkLists::distance(double comparable) const {
    return tree_ ? std::sqrt(comparable) : rows_->distance(comparable);
}

std::span<const ListEntry> LandmarkLists::insert(std::uint32_t input_index, std::uint32_t step) {
    entries_.clear();
    if (tree_) {
        const double* p = tree_->point(tree_->position(input_index));
        tree_->with_axes([&](auto axes) { visit(0, p, step, axes); });
    } else {
        rows_->fill(input_index, Limits(comparable_.data() + kappa_ - 1, kappa_), row_);
        visit_leaf(
            0, size_, extremes_.front(), step, [&](WitnessId w) { return row_[w]; }, [](WitnessId w) { return w; });
    }
    return entries_;
}

template <class Axes>
bool LandmarkLists::visit(std::uint32_t node_index, const double* p, std::uint32_t step, Axes axes) {
    Extremes& extremes = extremes_[node_index];
    if (tree_->box_distance_squared(node_index, p, axes) >= extremes.largest_last) return false;
    const KdTree::Node& node = tree_->node(node_index);
    if (node.right == 0) {
        const std::size_t before = entries_.size();
        visit_leaf(
            node.begin, node.end, extremes, step,
            [&](WitnessId w) { return tree_->point_distance_squared(w, p, axes); },
            [&](WitnessId w) { return tree_->input_index(w); });
        return entries_.size() > before;
    }
    const bool changed_left = visit(node_index + 1, p, step, axes);
    const bool changed_right = visit(node.right, p, step, axes);
    if (!changed_left && !changed_right) return false;
    const Extremes& left = extremes_[node_index + 1];
    const Extremes& right = extremes_[node.right];
    extremes.largest_last = std::max(left.largest_last, right.largest_last);
    const bool left_wins = left.largest_first > right.largest_first ||
                           (left.largest_first == right.largest_first && left.farthest < right.farthest);
    extremes.largest_first = left_wins ? left.largest_first : right.largest_first;
    extremes.farthest = left_wins ? left.farthest : right.farthest;
    return true;
}

template <class Comparable, class InputIndex>
void LandmarkLists::visit_leaf(WitnessId begin, WitnessId end, Extremes& extremes, std::uint32_t step,
                               const Comparable& comparable, const InputIndex& index_of) {
    extremes = {-1, -1, kNone};
    for (WitnessId w = begin; w < end; ++w) {
        double* distances = comparable_.data() + static_cast<std::size_t>(w) * kappa_;
        const double distance = comparable(w);
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
        const bool farther = distances[0] > extremes.largest_first ||
                             (distances[0] == extremes.largest_first && index_of(w) < extremes.farthest);
        if (farther) {
            extremes.largest_first = distances[0];
            extremes.farthest = index_of(w);
        }
        extremes.largest_last = std::max(extremes.largest_last, distances[kappa_ - 1]);
    }
}

double LandmarkLists::nearest_other_comparable(WitnessId witness) const {
    if (tree_) return tree_->nearest_other_squared(witness);
    return rows_->nearest_other(witness, row_);
}

std::uint64_t LandmarkLists::memory() const {
    // Of the tree what is certain in three dimensions, and what every further axis adds to points and boxes.
    constexpr std::uint64_t kBytesPerPoint = 40;
    constexpr std::uint64_t kBytesPerAxis = 22;
    std::uint64_t bytes = std::uint64_t{size_} * kappa_ * (sizeof(double) + sizeof(std::uint32_t));
    if (!tree_) return bytes + rows_->memory() + row_.capacity() * sizeof(double);
    const std::uint64_t more_axes = std::max(tree_->dimension(), 3u) - 3;
    return bytes + size_ * (kBytesPerPoint + kBytesPerAxis * more_axes);
}

}  // namespace plateau
