#include "plateaus/plateaus.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace plateau {

double Plateau::length() const {
    return std::log(ratio);
}

std::vector<Plateau> find_plateaus(const Timeline& timeline) {
    const Step count = timeline.step_count;
    double last_positive = 0;
    for (Step step = count; step > 0 && last_positive == 0; --step) last_positive = timeline.epsilon(step);
    const auto epsilon_plus = [&](Step step) {
        const double epsilon = step <= count ? timeline.epsilon(step) : 0;
        return epsilon > 0 ? epsilon : last_positive;
    };

    std::vector<Plateau> plateaus;
    for (Step first = 1, last = 0; first <= count; first = last + 1) {
        const auto betti = timeline.betti_at(first);
        const Family family = timeline.shown_family[first - 1];
        for (last = first; last < count; ++last) {
            const auto next = timeline.betti_at(last + 1);
            if (timeline.shown_family[last] != family || !std::equal(betti.begin(), betti.end(), next.begin())) break;
        }
        if (betti[0] == 0) continue;  // the complex is empty
        const double low = epsilon_plus(last + 1);
        const double ratio = low > 0 ? epsilon_plus(first) / low : 1;
        plateaus.push_back({first,
                            last,
                            timeline.epsilon(first),
                            timeline.epsilon(last),
                            ratio,
                            family,
                            {betti.begin(), betti.end()}});
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
