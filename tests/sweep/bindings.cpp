// The sweep as a module of its own: the page's module carries no tests.
#include <emscripten/bind.h>

#include <cstdio>
#include <string>

#include "sweep/predicate_sweep.h"

namespace {

emscripten::val sweep(std::uint32_t rounds) {
    const auto outcome = plateau::sweep::sweep_predicates(rounds);
    emscripten::val result = emscripten::val::object();
    result.set("calls", outcome.calls);
    result.set("mismatches", outcome.mismatches);
    return result;
}

std::string grid_hash(std::uint32_t edge, double spacing) {
    const auto hash = plateau::sweep::grid_delaunay_hash(edge, spacing);
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
    return text;
}

}  // namespace

EMSCRIPTEN_BINDINGS(predicate_sweep) {
    emscripten::function("sweep", &sweep);
    emscripten::function("gridHash", &grid_hash);
}
