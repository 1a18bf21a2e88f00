#pragma once

#include <emscripten/val.h>

namespace plateau {

/// {kind: 'planePicture', picture}, or {kind: 'failed'}. `scene`: PlaneScene of web/src/worker/inspection.ts.
emscripten::val plane_picture_of(const emscripten::val& scene);
/// {kind: 'inspection', inspection}, or {kind: 'failed'}. `vertices`: places in the array of landmarks.
emscripten::val plane_why_of(const emscripten::val& scene, const emscripten::val& vertices);

}  // namespace plateau
