#pragma once

#include <optional>
#include <string_view>

#include "session/engine.h"
#include "session/session.h"

namespace plateau {

/// Fills in the defaults that depend on the dimension of the cloud and checks every option against it.
/// In the plane `auto` means `delaunay`; max_dimension is filled in for family witness only. Errors: InvalidOption with
/// a sentence that names the option.
Result<RunOptions> resolved(RunOptions options, const PointCloud& cloud);

/// The sequences nu to follow, one a track, for resolved options.
EngineOptions engine_options(const RunOptions& resolved, std::uint32_t dimension);

}  // namespace plateau
