#pragma once

#include <chrono>

#include "session/session.h"

namespace plateau::cli {

/// Reports progress on standard error: one line that is redrawn on a terminal, else a line now and then.
class ProgressLine {
public:
    /// `forced`: also where standard error is no terminal.
    explicit ProgressLine(bool forced);
    ~ProgressLine() { clear(); }
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    void show(const Progress& progress);
    /// Removes the line, so that other text can follow.
    void clear();

private:
    using Clock = std::chrono::steady_clock;
    bool on_terminal_;
    bool enabled_;
    bool drawn_ = false;
    Clock::time_point last_;
};

}  // namespace plateau::cli
