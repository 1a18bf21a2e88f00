#pragma once

#include <emscripten/val.h>

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "session/session.h"

/// What JavaScript hands in, checked: a conversion of embind would wrap or cut a number that does not fit.
namespace plateau::marshal {

/// Neither undefined nor null.
bool given(const emscripten::val& value);

/// A whole number from 0 to 2^32 - 1. Error: InvalidOption, beginning with `name`.
Result<std::uint32_t> count_of(const emscripten::val& value, const std::string& name);
Result<std::vector<std::uint32_t>> counts_of(const emscripten::val& array, const std::string& name);

/// RunOptions of web/src/worker/protocol.ts; what is absent keeps its default.
Result<RunOptions> run_options_of(const emscripten::val& source);

/// The cloud of a source of kind 'sample'.
Result<PointCloud> sample_of(const emscripten::val& source);

}  // namespace plateau::marshal
