#include "dilated/witness_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plateau {

namespace {

constexpr double kAboveRounding = 1 + 0x1p-40;

}  // namespace

// Whether a witness is farther than the limit from the cell by a single constraint: that the vertex that it sees worst
// is no farther than the best of its list. The distance to the bisector is (difference of powers) / (2 |v - q|).
bool WitnessSearch::is_far(WitnessId witness, double limit) const {
    const double* x = point(witness);
    double largest = -std::numeric_limits<double>::infinity();
    Step worst = 0;
    for (const Step vertex : simplex_) {
        const double power = landmarks_->power(vertex, x);
        if (power > largest) {
            largest = power;
            worst = vertex;
        }
    }
    const auto list = lists_->list(witness);
    const auto distances = lists_->comparable_distances(witness);
    for (std::size_t rank = 0; rank < list.size() && list[rank] != 0; ++rank) {
        if (cell_.has_vertex(list[rank])) continue;
        const double excess = largest - (distances[rank] - landmarks_->weight_squared(list[rank]));
        if (!(excess > 0)) continue;
        const double apart_squared = landmarks_->distance_squared(worst, landmarks_->point(list[rank]));
        if (excess * excess > 4 * apart_squared * limit * limit * kAboveRounding) return true;
    }
    return false;
}

// A watch if the witness is within zeta; `excluded` if it is beyond `far`.
std::optional<Watch> WitnessSearch::examine(WitnessId witness, double zeta, double far, bool& excluded) {
    for (const Step landmark : lists_->list(witness)) {
        if (landmark != 0) cell_.consider(landmark);
    }
    const double distance_squared = cell_.from(point(witness), zeta, far);
    excluded = distance_squared > far * far * kAboveRounding;
    if (!(distance_squared <= zeta * zeta)) return std::nullopt;
    Watch watch{witness, distance_squared, cell_.power(), {}};
    std::copy_n(cell_.nearest_point(), landmarks_->dimension(), watch.nearest.begin());
    return watch;
}

std::optional<Watch> WitnessSearch::look_at(std::span<const Step> simplex, double zeta, WitnessId witness) {
    simplex_ = simplex;
    cell_.begin(simplex);
    bool excluded = false;
    return examine(witness, zeta, zeta, excluded);
}

std::optional<Watch> WitnessSearch::find(std::span<const Step> simplex, double zeta, const double* hint) {
    simplex_ = simplex;
    cell_.begin(simplex);
    looked_at_ = 0;
    // Simplices are asked for in turn that share witnesses; that saves the way down the tree.
    bool excluded = false;
    for (std::size_t i = 0; i < std::min(successes_, successful_.size()); ++i) {
        if (is_far(successful_[i], zeta)) continue;
        if (const auto watch = examine(successful_[i], zeta, zeta, excluded)) return watch;
    }
    const auto watch = descend(zeta, hint);
    if (watch) successful_[successes_++ % successful_.size()] = watch->witness;
    return watch;
}

std::optional<Watch> WitnessSearch::descend(double zeta, const double* hint) {
    const KdTree& tree = balls_.tree();
    const auto axes = static_cast<std::size_t>(tree.dimension());
    pending_.assign(1, 0);
    while (!pending_.empty()) {
        const std::uint32_t index = pending_.back();
        pending_.pop_back();
        const KdTree::Node& node = tree.node(index);
        ++looked_at_;
        const double far = zeta + balls_.radius(index);
        if (is_far(balls_.middle(index), far)) continue;
        bool excluded = false;
        if (const auto watch = examine(balls_.middle(index), zeta, far, excluded)) return watch;
        if (excluded) continue;
        if (node.right == 0) {
            looked_at_ += node.end - node.begin;
            for (WitnessId witness = node.begin; witness < node.end; ++witness) {
                if (witness == balls_.middle(index) || is_far(witness, zeta)) continue;
                if (const auto watch = examine(witness, zeta, zeta, excluded)) return watch;
            }
            continue;
        }
        const bool right_first =
            tree.box_distance_squared(node.right, hint, axes) < tree.box_distance_squared(index + 1, hint, axes);
        pending_.push_back(right_first ? index + 1 : node.right);
        pending_.push_back(right_first ? node.right : index + 1);
    }
    return std::nullopt;
}

// A point c within zeta of the witness has its two landmarks of least power among those of power at most
// (d_2 + zeta)^2, d_2 the distance of the witness to its second nearest landmark. `slack`: zeta, or more for a ball.
double WitnessSearch::list_reach(WitnessId witness, double slack) const {
    const double second = std::sqrt(lists_->comparable_distances(witness)[1]) + slack;
    return slack + std::sqrt(second * second + landmarks_->largest_weight_squared());
}

double WitnessSearch::reach(double zeta) {
    const KdTree& tree = balls_.tree();
    double reach = 0;
    pending_.assign(1, 0);
    while (!pending_.empty()) {
        const std::uint32_t index = pending_.back();
        pending_.pop_back();
        const KdTree::Node& node = tree.node(index);
        const double radius = balls_.radius(index);
        const auto distance = [&](WitnessId witness) {
            return std::sqrt(landmarks_->distance_squared(landmarks_->size(), point(witness)));
        };
        const WitnessId middle = balls_.middle(index);
        const double away = distance(middle);
        // Nearer than the middle by the radius at most, and the second landmark is farther by as much at most.
        const double ball_reach = list_reach(middle, zeta + radius);
        if (away > ball_reach * kAboveRounding || (away + ball_reach) * kAboveRounding <= reach) continue;
        if (node.right != 0) {
            pending_.push_back(node.right);
            pending_.push_back(index + 1);
            continue;
        }
        for (WitnessId witness = node.begin; witness < node.end; ++witness) {
            const double own = list_reach(witness, zeta) * kAboveRounding;
            if (const double from_p = distance(witness); from_p <= own) reach = std::max(reach, from_p + own);
        }
    }
    return reach;
}

}  // namespace plateau
