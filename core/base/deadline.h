#pragma once

#include <chrono>
#include <limits>

namespace plateau {

/// A moment after which sliced work returns to its caller. The only clock of the core.
class Deadline {
public:
    /// `milliseconds` from now; infinity never passes.
    explicit Deadline(double milliseconds) : budget_ms_(milliseconds) {}
    static Deadline never() { return Deadline(std::numeric_limits<double>::infinity()); }
    bool passed() const { return elapsed_ms() >= budget_ms_; }
    double elapsed_ms() const {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
    }

private:
    double budget_ms_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace plateau
