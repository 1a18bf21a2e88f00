#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "cli/arguments.h"
#include "io/saved_run.h"
#include "session/session.h"

namespace plateau::cli {

/// Long enough to work, short enough that Ctrl-C feels immediate.
inline constexpr double kSliceMs = 50;

struct OpenedInput {
    Session session;
    std::vector<std::string> notes;  ///< what the reader has to say
    std::optional<SavedRun> saved;   ///< when the input is a session file
};

/// Reads the input and opens its run, by the options of the arguments and those of a session file. Nothing if the user
/// interrupts.
Result<std::optional<OpenedInput>> open_input(const RunArguments& arguments);

}  // namespace plateau::cli
