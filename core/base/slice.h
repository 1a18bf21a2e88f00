#pragma once

#include <cstdint>

#include "base/deadline.h"

namespace plateau {

/// How much of a long loop may be done before it returns to its caller, to be gone on with later: some units of work in
/// any case, then as many as the deadline leaves. Most loops end within the first units, and no clock is read.
class Slice {
public:
    static constexpr std::uint32_t kUnits = 512;

    explicit Slice(const Deadline& deadline) : deadline_(&deadline) {}

    /// Asked before each unit of work: whether the loop has to return without it.
    bool used_up() {
        if (left_ == 0 && !over_) {
            over_ = deadline_->passed();
            left_ = kUnits;
        }
        if (over_) return true;
        --left_;
        return false;
    }

private:
    const Deadline* deadline_;
    std::uint32_t left_ = kUnits;
    bool over_ = false;
};

}  // namespace plateau
