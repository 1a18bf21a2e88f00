#include <emscripten/bind.h>

#include "plane.h"
#include "run.h"

// The table of what JavaScript can call; what it means is in run.h and plane.h, its types in plateau-module.d.ts.
EMSCRIPTEN_BINDINGS(plateau) {
    emscripten::function("sampleShapes", &plateau::sample_list);
    emscripten::function("planePicture", &plateau::plane_picture_of);
    emscripten::function("planeWhy", &plateau::plane_why_of);
    emscripten::class_<plateau::Run>("Run")
        .constructor<const emscripten::val&, const emscripten::val&>()
        .function("open", &plateau::Run::open)
        .function("run", &plateau::Run::run)
        .function("runPastNoise", &plateau::Run::run_past_noise)
        .function("delta", &plateau::Run::delta)
        .function("plateaus", &plateau::Run::plateaus)
        .function("exportFile", &plateau::Run::export_file)
        .function("exportFile", &plateau::Run::export_with_view)
        .function("inspect", &plateau::Run::inspect)
        .function("hash", &plateau::Run::hash);
}
