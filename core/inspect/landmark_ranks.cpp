#include "inspect/landmark_ranks.h"

#include <algorithm>
#include <utility>

namespace plateau {

TreeRanks::TreeRanks(const PointCloud& witnesses, const PointCloud& landmarks)
    : witnesses_(&witnesses), landmarks_(&landmarks), tree_(landmarks) {
    tree_.prepare(Deadline::never());
}

TreeRanks::Farthest TreeRanks::farthest(std::uint32_t witness, std::span<const Step> simplex) const {
    Farthest farthest;
    for (const Step vertex : simplex) {
        const double squared = distance_squared(landmarks_->point(vertex - 1), witnesses_->point(witness));
        const bool is_farther =
            squared > farthest.distance_squared || (squared == farthest.distance_squared && vertex > farthest.landmark);
        if (is_farther) farthest = {squared, vertex};
    }
    return farthest;
}

double TreeRanks::reach(std::uint32_t witness, std::span<const Step> simplex) const {
    return farthest(witness, simplex).distance_squared;
}

// Landmarks before `of` in the order of (distance, step), until there are `limit` of them.
template <class Axes>
void TreeRanks::count(std::uint32_t node_index, const double* witness, const Farthest& of, std::uint32_t limit,
                      Axes axes, std::uint32_t& nearer) const {
    if (nearer >= limit || tree_.box_distance_squared(node_index, witness, axes) > of.distance_squared) return;
    const KdTree::Node& node = tree_.node(node_index);
    if (tree_.box_reach_squared(node_index, witness, axes) < of.distance_squared) {
        nearer += node.end - node.begin;
        return;
    }
    if (node.right != 0) {
        count(node_index + 1, witness, of, limit, axes, nearer);
        count(node.right, witness, of, limit, axes, nearer);
        return;
    }
    for (std::uint32_t position = node.begin; position < node.end; ++position) {
        const double squared = tree_.point_distance_squared(position, witness, axes);
        const Step landmark = tree_.input_index(position) + 1;
        if (squared < of.distance_squared || (squared == of.distance_squared && landmark < of.landmark)) ++nearer;
    }
}

std::uint32_t TreeRanks::rank(std::uint32_t witness, const Farthest& of, std::uint32_t limit) const {
    std::uint32_t nearer = 0;
    tree_.with_axes([&](auto axes) { count(0, witnesses_->point(witness).data(), of, limit, axes, nearer); });
    return nearer + 1;
}

std::uint32_t TreeRanks::rank(std::uint32_t witness, Step landmark, std::uint32_t limit) const {
    return rank(witness, farthest(witness, {&landmark, 1}), limit);
}

std::uint32_t TreeRanks::largest_rank(std::uint32_t witness, std::span<const Step> simplex, std::uint32_t limit) const {
    return rank(witness, farthest(witness, simplex), limit);
}

Result<ListRanks> ListRanks::of(const PointCloud& cloud, const MetricOptions& metric,
                                std::span<const std::uint32_t> landmarks) {
    const std::uint32_t horizon = std::min(kHorizon, static_cast<std::uint32_t>(landmarks.size()));
    LandmarkLists lists(make_distance_rows(cloud, metric), cloud.size(), horizon);
    lists.prepare(Deadline::never());
    if (auto failure = lists.failure()) return std::move(*failure);
    for (std::uint32_t i = 0; i < landmarks.size(); ++i) lists.insert(landmarks[i], i + 1);
    return ListRanks(std::move(lists), horizon);
}

std::uint32_t ListRanks::rank(std::uint32_t witness, Step landmark, std::uint32_t limit) const {
    const auto list = lists_.list(witness);
    for (std::uint32_t place = 0; place < limit; ++place) {
        if (list[place] == landmark) return place + 1;
    }
    return limit + 1;
}

std::uint32_t ListRanks::largest_rank(std::uint32_t witness, std::span<const Step> simplex, std::uint32_t limit) const {
    std::uint32_t largest = 0;
    for (const Step vertex : simplex) largest = std::max(largest, rank(witness, vertex, limit));
    return largest;
}

}  // namespace plateau
