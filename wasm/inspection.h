#pragma once

#include <emscripten/val.h>

#include "inspect/inspection.h"

namespace plateau::marshal {

/// Inspection of web/src/worker/inspection.ts, which names landmarks by numbers from `first_landmark` on: 1 where they
/// are steps, 0 where they are places in an array.
emscripten::val inspection_of(const Inspection& inspection, Step first_landmark);

}  // namespace plateau::marshal
