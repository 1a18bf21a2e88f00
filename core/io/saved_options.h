#pragma once

#include <optional>
#include <vector>

#include "base/result.h"
#include "io/saved_run.h"
#include "session/session.h"

namespace plateau {

/// Everything that decides what is computed and where it ends, in one order; numbers with all their digits. What a run
/// may take of the memory is the machine's affair.
std::vector<SavedRun::Option> saved_options(const RunOptions& options);

/// The other way round. Error: InvalidOption for a name or a value that this version does not know.
Result<RunOptions> options_of(const SavedRun& saved);

/// Whether the steps that the saved run had reached are those of this one, by their hash. Nothing before the run has
/// come as far.
std::optional<bool> agrees(const SavedRun& saved, const Session& session);

}  // namespace plateau
