#include "plateaus/plateaus.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace plateau {

double Plateau::length() const {
    return std::log(ratio);
}

namespace {

/// epsilon+ of the steps: epsilon, or the last positive epsilon where it is 0 or not yet known.
class PositiveScale {
public:
    explicit PositiveScale(const Timeline& timeline) : timeline_(&timeline) {
        for (Step step = timeline.step_count; step > 0 && last_positive_ == 0; --step) {
            last_positive_ = timeline.epsilon(step);
        }
    }
    /// epsilon+(first) / epsilon+(last + 1), or 1.
    double ratio(Step first, Step last) const {
        const double low = at(last + 1);
        return low > 0 ? at(first) / low : 1;
    }

private:
    double at(Step step) const {
        const double epsilon = step <= timeline_->step_count ? timeline_->epsilon(step) : 0;
        return epsilon > 0 ? epsilon : last_positive_;
    }
    const Timeline* timeline_;
    double last_positive_ = 0;
};

bool alike(std::span<const std::uint32_t> a, std::span<const std::uint32_t> b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

/// The last step up to `end` that follows `first` without a change of what `same(a, b)` compares.
template <class Same>
Step end_of_run(Step first, Step end, const Same& same) {
    Step last = first;
    while (last < end && same(last, last + 1)) ++last;
    return last;
}

std::vector<std::uint32_t> torsion_of(const Plateau& plateau, const Timeline& timeline, const PositiveScale& scale) {
    if (timeline.other_betti.empty()) return {};
    const auto same = [&](Step a, Step b) { return alike(timeline.other_betti_at(a), timeline.other_betti_at(b)); };
    std::span<const std::uint32_t> longest;
    double longest_ratio = 0;
    for (Step first = plateau.first_step, last = 0; first <= plateau.last_step; first = last + 1) {
        last = end_of_run(first, plateau.last_step, same);
        const double ratio = scale.ratio(first, last);
        if (ratio <= longest_ratio) continue;
        longest_ratio = ratio;
        longest = timeline.other_betti_at(first);
    }
    if (alike(longest, plateau.betti)) return {};
    return {longest.begin(), longest.end()};
}

}  // namespace

std::vector<Plateau> find_plateaus(const Timeline& timeline) {
    const PositiveScale scale(timeline);
    const auto same = [&](Step a, Step b) {
        return timeline.shown_family[a - 1] == timeline.shown_family[b - 1] &&
               alike(timeline.betti_at(a), timeline.betti_at(b));
    };
    std::vector<Plateau> plateaus;
    for (Step first = 1, last = 0; first <= timeline.step_count; first = last + 1) {
        last = end_of_run(first, timeline.step_count, same);
        const auto betti = timeline.betti_at(first);
        if (betti[0] == 0) continue;  // the complex is empty
        Plateau& plateau = plateaus.emplace_back();
        plateau.first_step = first;
        plateau.last_step = last;
        plateau.epsilon_first = timeline.epsilon(first);
        plateau.epsilon_last = timeline.epsilon(last);
        plateau.ratio = scale.ratio(first, last);
        plateau.family = timeline.shown_family[first - 1];
        plateau.betti.assign(betti.begin(), betti.end());
        plateau.torsion = torsion_of(plateau, timeline, scale);
    }
    return plateaus;
}

std::vector<std::uint32_t> ranked(const std::vector<Plateau>& plateaus) {
    std::vector<std::uint32_t> order(plateaus.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return plateaus[a].ratio > plateaus[b].ratio || (plateaus[a].ratio == plateaus[b].ratio && a < b);
    });
    return order;
}

Step middle_step(const Timeline& timeline, const Plateau& plateau) {
    const double middle = std::sqrt(plateau.epsilon_first * plateau.epsilon_last);
    Step step = plateau.first_step;
    while (step < plateau.last_step && timeline.epsilon(step) > middle) ++step;
    return step;
}

}  // namespace plateau
