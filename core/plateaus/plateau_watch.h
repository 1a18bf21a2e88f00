#pragma once

#include "timeline/timeline.h"

namespace plateau {

/// Notices, step by step, when a plateau has become as long as was asked for [BGO 6].
class PlateauWatch {
public:
    /// The shortest length that counts, as Plateau::length() has it; at least 0.
    explicit PlateauWatch(double min_length);

    /// Follows one more step of the record. True, once a plateau, at the first step at which the plateau of the steps
    /// before it is long enough; the step goes on with it, or is the first behind it.
    bool follow(const Timeline& timeline);

private:
    double min_ratio_;
    Step first_ = 1;  // of the steps with equal numbers that the last one belongs to
    bool told_ = false;
};

/// e^x for 0 <= x <= 50 from + * / alone, the same bits on every machine; relative error below 1e-12.
double exponential(double x);

}  // namespace plateau
