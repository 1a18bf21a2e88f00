#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/result.h"
#include "cloud/samples.h"
#include "session/session.h"

namespace plateau::cli {

/// `plateau run`.
struct RunArguments {
    std::string input;  ///< a path; "-" is standard input
    RunOptions options;
    std::vector<std::uint32_t> columns;  ///< 1-based; empty: as the reader decides
    std::string betti;                   ///< a path, "-" for standard output, empty for none; likewise below
    std::string plateaus;
    std::string pumps;
    std::string mesh;
    std::uint32_t nth = 1;  ///< of the plateaus of at least the least length the one to stop at
    std::string complex;
    std::string report;
    std::string session;
    std::optional<Step> at;  ///< step of mesh, complex, report and session
    /// Options of the run that the command line names, without their dashes; a session file decides about the others.
    std::vector<std::string> named;
    std::optional<std::uint64_t> memory_limit;  ///< bytes; none: four fifths of the machine's
    bool hash = false;
    bool progress = false;  ///< also where standard error is no terminal

    /// Paths of all outputs.
    std::array<const std::string*, 7> outputs() const {
        return {&betti, &plateaus, &pumps, &mesh, &complex, &report, &session};
    }
};

/// `plateau inspect`.
struct InspectArguments {
    RunArguments run;  ///< input and options; no outputs
    Step step = 0;
    std::vector<Step> simplex;
};

/// `plateau sample`.
struct SampleArguments {
    std::string shape;
    SampleOptions options;
};

/// `--help` or `--version`: a text for standard output.
struct TextRequest {
    std::string text;
};

using Arguments = std::variant<RunArguments, InspectArguments, SampleArguments, TextRequest>;

/// Reads the command line. The error's message is one line.
Result<Arguments> parse_arguments(int count, const char* const* values);

}  // namespace plateau::cli
