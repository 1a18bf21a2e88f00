#pragma once

#include <emscripten/val.h>

#include "timeline/timeline.h"

namespace plateau::marshal {

/// The last step of a delta that begins after step `done`: as many complete steps as hold about `max_simplices` new
/// edges, triangles and rows of the surface, at least one step if there is one. Cost: O(log steps).
Step delta_end(const Timeline& timeline, Step done, std::uint32_t max_simplices);

/// Copies what the steps after `done` up to `end` appended into the fields of Delta (protocol.ts) from `firstStep` on,
/// all but state and hash. Deaths and ends after `end` stay unsaid: a later delta tells them.
void add_record(emscripten::val& delta, const Timeline& timeline, Step done, Step end);

}  // namespace plateau::marshal
