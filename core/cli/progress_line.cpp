#include "cli/progress_line.h"

#include <unistd.h>

#include <cstdio>

namespace plateau::cli {

ProgressLine::ProgressLine(bool forced)
    : on_terminal_(isatty(STDERR_FILENO) != 0), enabled_(on_terminal_ || forced), last_(Clock::now()) {}

void ProgressLine::show(const Progress& progress) {
    if (!enabled_) return;
    const auto now = Clock::now();
    const auto interval = on_terminal_ ? std::chrono::milliseconds(100) : std::chrono::milliseconds(1000);
    if (now - last_ < interval) return;
    last_ = now;
    if (on_terminal_) std::fputs("\r", stderr);
    if (progress.state == RunState::Preparing) {
        std::fputs("preparing", stderr);
    } else {
        std::fprintf(stderr, "step %u of %u, epsilon %.3g", progress.steps_done, progress.steps_planned,
                     progress.epsilon);
    }
    std::fputs(on_terminal_ ? "\x1b[K" : "\n", stderr);
    std::fflush(stderr);
    drawn_ = true;
}

void ProgressLine::clear() {
    if (drawn_ && on_terminal_) std::fputs("\r\x1b[K", stderr);
    drawn_ = false;
}

}  // namespace plateau::cli
