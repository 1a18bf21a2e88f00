#pragma once

#include "base/result.h"
#include "cli/arguments.h"

namespace plateau::cli {

inline constexpr int kDone = 0;
inline constexpr int kBadInput = 2;
inline constexpr int kInterrupted = 130;

/// Reads, runs and writes; returns the exit code. An error is reported by the caller.
Result<int> run(const RunArguments& arguments);

/// Prints why the simplex is there, or why not, in one line.
Result<int> inspect(const InspectArguments& arguments);

/// Prints the sample on standard output.
Result<int> sample(const SampleArguments& arguments);

}  // namespace plateau::cli
