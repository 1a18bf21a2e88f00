#pragma once

#include <cmath>
#include <cstdint>

namespace plateau {

inline constexpr double kTwoPi = 6.283185307179586;

/// Sine and cosine of one angle.
struct SineCosine {
    double sine = 0;
    double cosine = 1;
};

/// Sine and cosine of 2 pi `turns` from + - * alone, the same bits on every machine; the standard library's differ by
/// an ulp from one to the next. Absolute error below 1e-15, exact at quarter turns. Precondition: |turns| < 2^48.
inline SineCosine sine_cosine_of_turns(double turns) {
    const double quarters = std::floor(turns * 4 + 0.5);
    const double x = (turns - quarters * 0.25) * kTwoPi;  // the difference is exact; |x| <= pi / 4
    const double y = x * x;
    // Taylor series; the first term left out is below 2e-19.
    double sine = 1.0 / 355687428096000;
    sine = sine * y - 1.0 / 1307674368000;
    sine = sine * y + 1.0 / 6227020800;
    sine = sine * y - 1.0 / 39916800;
    sine = sine * y + 1.0 / 362880;
    sine = sine * y - 1.0 / 5040;
    sine = sine * y + 1.0 / 120;
    sine = sine * y - 1.0 / 6;
    sine = x + x * (y * sine);
    double cosine = 1.0 / 20922789888000;
    cosine = cosine * y - 1.0 / 87178291200;
    cosine = cosine * y + 1.0 / 479001600;
    cosine = cosine * y - 1.0 / 3628800;
    cosine = cosine * y + 1.0 / 40320;
    cosine = cosine * y - 1.0 / 720;
    cosine = cosine * y + 1.0 / 24;
    cosine = cosine * y - 1.0 / 2;
    cosine = 1 + y * cosine;
    switch (static_cast<std::int64_t>(quarters) & 3) {
        case 0:
            return {sine, cosine};
        case 1:
            return {cosine, -sine};
        case 2:
            return {-sine, -cosine};
        default:
            return {-cosine, sine};
    }
}

/// The angle from 0 to pi / 2 whose sine has this square, 0 to 1, from + - * / and square roots alone. Relative error
/// below 1e-15; exactly 0 for 0.
inline double angle_of_squared_sine(double squared) {
    // Tangents of half the angle, a quarter, an eighth: at most tan(pi / 16).
    double tangent = std::sqrt(squared) / (1 + std::sqrt(1 - squared));
    tangent = tangent / (1 + std::sqrt(1 + tangent * tangent));
    tangent = tangent / (1 + std::sqrt(1 + tangent * tangent));
    const double y = tangent * tangent;
    // Taylor series of the arc tangent; the first term left out is below 1e-17 of the first.
    double sum = 0;
    for (int odd = 23; odd >= 3; odd -= 2) sum = (1.0 / odd - sum) * y;
    return 8 * (tangent - tangent * sum);
}

}  // namespace plateau
