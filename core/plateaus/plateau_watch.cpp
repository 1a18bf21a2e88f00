#include "plateaus/plateau_watch.h"

#include <algorithm>

namespace plateau {

double exponential(double x) {
    int doublings = 0;
    for (; x > 0.0625; x /= 2) ++doublings;
    double sum = 1;
    for (int term = 12; term >= 1; --term) sum = 1 + sum * x / term;
    for (; doublings > 0; --doublings) sum *= sum;
    return sum;
}

PlateauWatch::PlateauWatch(double min_length) : min_ratio_(exponential(min_length)) {}

bool PlateauWatch::follow(const Timeline& timeline) {
    const Step step = timeline.step_count;
    if (step == 1) return false;
    // A plateau reaches to the epsilon of the step behind it, whether or not that step goes on with it.
    const double epsilon = timeline.epsilon(step);
    bool notices = false;
    if (!told_ && timeline.betti_at(first_)[0] > 0 && epsilon > 0) {
        notices = timeline.epsilon(first_) >= min_ratio_ * epsilon;
        told_ = notices;
    }
    const auto betti = timeline.betti_at(step);
    const auto before = timeline.betti_at(step - 1);
    const bool goes_on = timeline.shown_family[step - 2] == timeline.shown_family[step - 1] &&
                         std::equal(betti.begin(), betti.end(), before.begin());
    if (!goes_on) {
        first_ = step;
        told_ = false;
    }
    return notices;
}

}  // namespace plateau
