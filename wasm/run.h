#pragma once

#include <emscripten/val.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/cloud_reader.h"
#include "session/session.h"

namespace plateau {

/// One run as JavaScript sees it: a source and options in; slices of work, copies of the record and files out.
/// The plain objects that go out are described in plateau-module.d.ts. Expected failures are values; nothing throws.
class Run {
public:
    /// `source` and `options`: CloudSource and RunOptions of web/src/worker/protocol.ts. Faults in them show in open().
    Run(const emscripten::val& source, const emscripten::val& options);

    /// Reads on for about `budget_ms`: {kind: 'reading'}, then once {kind: 'opened', opened}, or {kind: 'failed'}.
    emscripten::val open(double budget_ms);
    /// Computes for about `budget_ms` or `max_steps` steps, whichever ends first, at least one unit, which can be a
    /// part of a long step: {kind: 'progress'}.
    emscripten::val run(double budget_ms, std::uint32_t max_steps);
    /// Lifts the stop at the noise; run() goes on after it: {kind: 'lifted'}.
    emscripten::val run_past_noise();
    /// What was appended since the last call: whole steps with about `max_simplices` simplices at most, at least one
    /// step if there is one. Its state is final only once everything was handed out.
    emscripten::val delta(std::uint32_t max_simplices);
    emscripten::val plateaus() const;
    /// {kind: 'file', bytes}; what the arguments are is in exports.h.
    emscripten::val export_with_view(const std::string& format, const emscripten::val& step,
                                     const emscripten::val& view) const;
    emscripten::val export_file(const std::string& format, const emscripten::val& step) const;
    /// Why the simplex of these landmarks (steps) is there at the step, or why not: {kind: 'inspection', inspection}.
    emscripten::val inspect(const emscripten::val& step, const emscripten::val& vertices) const;
    /// 16 hexadecimal digits over all complete steps. Cost: the steps since the last call, or the last delta.
    std::string hash() const;

private:
    std::optional<Error> take_options_of(SavedRun saved);
    emscripten::val opened_with(PointCloud cloud, const std::vector<std::string>& warnings);

    RunOptions options_;
    std::optional<Error> error_;
    std::optional<CloudReader> reader_;
    std::optional<PointCloud> sample_;
    std::optional<Session> session_;
    bool takes_new_options_ = false;  ///< instead of those of a session file
    std::optional<SavedRun> saved_;   ///< the session file whose options the run has
    std::optional<bool> agrees_;      ///< with that file, once the run has come as far
    Step handed_out_ = 0;             ///< steps that delta() has given away
};

/// The built-in shapes: [{name, dimension, defaultSize, lookFor}].
emscripten::val sample_list();

}  // namespace plateau
