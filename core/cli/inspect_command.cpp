#include <cstdio>
#include <string>

#include "cli/commands.h"
#include "cli/files.h"
#include "cli/open_input.h"
#include "io/inspection_text.h"

namespace plateau::cli {

Result<int> inspect(const InspectArguments& arguments) {
    auto input = open_input(arguments.run);
    if (!input) return input.error();
    if (!input.value()) return kInterrupted;
    for (const std::string& note : input.value()->notes) std::fprintf(stderr, "plateau: %s\n", note.c_str());
    Session& session = input.value()->session;
    Progress progress = session.progress();
    while (progress.state == RunState::Preparing || progress.state == RunState::Running) {
        if (interrupted()) return kInterrupted;
        progress = session.run({.milliseconds = kSliceMs});
    }
    if (progress.stopped && progress.steps_done < arguments.step) return *progress.stopped;
    const auto inspection = session.inspect(arguments.step, arguments.simplex);
    if (!inspection) return inspection.error();
    if (auto error = write_file("-", inspection_text(inspection.value()) + "\n")) return std::move(*error);
    return kDone;
}

}  // namespace plateau::cli
