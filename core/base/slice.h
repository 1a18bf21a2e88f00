#pragma once

#include <algorithm>
#include <cstdint>

#include "base/deadline.h"

namespace plateau {

/// How much of a long loop may be done before it returns to its caller, to be gone on with later: some units of work in
/// any case, then as many as the deadline leaves. Most loops end within the first units, and no clock is read.
class Slice {
public:
    static constexpr std::uint32_t kUnits = 512;

    explicit Slice(const Deadline& deadline) : deadline_(&deadline) {}

    /// Asked before each piece of work, of so many units, at most kUnits: whether the loop has to return without it.
    bool used_up(std::uint32_t units = 1) {
        if (left_ < units && !over_) {
            over_ = deadline_->passed();
            left_ = kUnits;
        }
        if (over_) return true;
        left_ -= units;
        return false;
    }

    /// What a piece of work took beyond the units that were asked for.
    void charge(std::uint32_t units) { left_ -= std::min(left_, units); }

private:
    const Deadline* deadline_;
    std::uint32_t left_ = kUnits;
    bool over_ = false;
};

}  // namespace plateau
