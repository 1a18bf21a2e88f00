#pragma once

#include <emscripten/val.h>

#include <string>

#include "base/result.h"
#include "io/saved_run.h"
#include "session/session.h"

namespace plateau::marshal {

/// The bytes of a file that a run can give away. `format`: ExportFormat of web/src/worker/protocol.ts; `step`: 1-based,
/// or undefined for the default; `view`: of format 'session', what the page wants to find again, or undefined.
/// Errors: InvalidOption.
Result<std::string> exported(const Session& session, const std::string& format, const emscripten::val& step,
                             const emscripten::val& view);

/// SavedSession of web/src/worker/protocol.ts.
emscripten::val session_of(const SavedRun& saved, const RunOptions& options);

}  // namespace plateau::marshal
