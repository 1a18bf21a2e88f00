#pragma once

#include <optional>
#include <string>

#include "base/result.h"
#include "cli/arguments.h"
#include "io/saved_run.h"

namespace plateau::cli {

/// The options of the session, except where the command line names others. With another family or metric go those
/// that belong to it: nu, the last Betti number, the box, the neighbors.
Result<RunOptions> continued(const SavedRun& saved, const RunArguments& arguments);

/// What to say of a run whose options are those of the session, if it is not the one that was saved.
std::optional<std::string> disagreement(const SavedRun& saved, const Session& session);

/// The bytes of --session. What an opened session showed stays, as far as the command line does not say otherwise.
std::string saved_session(const Session& session, const std::optional<SavedRun>& opened, std::optional<Step> at);

}  // namespace plateau::cli
