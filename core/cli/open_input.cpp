#include "cli/open_input.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "cli/files.h"
#include "cli/saved_session.h"
#include "io/cloud_reader.h"

namespace plateau::cli {
namespace {

/// Bytes that a run may take on this machine: four fifths of its memory.
std::uint64_t usable_memory() {
    const long pages = sysconf(_SC_PHYS_PAGES);
    const long page_size = sysconf(_SC_PAGESIZE);
    if (pages <= 0 || page_size <= 0) return RunOptions{}.memory_limit;
    return static_cast<std::uint64_t>(pages) / 5 * 4 * static_cast<std::uint64_t>(page_size);
}

/// An option that the command line names and that would do nothing in this run.
std::optional<Error> objection_to_unused(const RunArguments& arguments, const RunOptions& used) {
    const Family family = *used.family;
    const auto is_one_of = [](const std::string& name, const auto& names) {
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    constexpr std::array<std::string_view, 3> kOfPumping = {"omega-bar", "zeta2", "sliver"};
    constexpr std::array<std::string_view, 3> kOfDilated = {"dilation", "pump", "theory"};
    for (const std::string& name : arguments.named) {
        const bool is_of_pumping = is_one_of(name, kOfPumping);
        std::string what;
        if (family != Family::Dilated && (is_of_pumping || is_one_of(name, kOfDilated))) {
            what = "family dilated; add --family dilated.";
        } else if ((is_of_pumping || name == "pumps") && !used.dilated.pumps) {
            what = "--pump, which chooses weights.";
        } else if (name == "rho" && family != Family::Surface && family != Family::Auto) {
            what = "families surface and auto.";
        } else if (name == "field" && is_within_delaunay(family)) {
            what = "families witness and dilated.";
        } else if (name == "nth" && used.min_length == 0) {
            what = "plateaus of a --min-length above 0.";
        } else {
            continue;
        }
        return Error{ErrorCode::InvalidOption, "--" + name + " is for " + what};
    }
    return std::nullopt;
}

}  // namespace

Result<std::optional<OpenedInput>> open_input(const RunArguments& arguments) {
    auto bytes = read_file(arguments.input);
    if (!bytes) return bytes.error();
    RunOptions options = arguments.options;
    options.memory_limit = arguments.memory_limit.value_or(usable_memory());
    const bool is_matrix = options.metric.metric == Metric::Matrix;
    CloudReader reader(std::move(bytes).value(), arguments.input,
                       {.columns = arguments.columns,
                        .as = is_matrix ? ReadAs::Distances : ReadAs::PointsOfAnyDimension,
                        .memory_limit = options.memory_limit});
    while (!interrupted() && !reader.advance(kSliceMs)) {
    }
    if (interrupted()) return std::optional<OpenedInput>();
    auto read = reader.take();
    if (!read) {
        const std::string name = arguments.input == "-" ? "standard input" : arguments.input;
        return Error{read.error().code, name + ": " + read.error().message};
    }
    const std::optional<SavedRun>& saved = read.value().saved;
    if (saved) {
        const std::uint64_t memory_limit = options.memory_limit;
        auto known = continued(*saved, arguments);
        if (!known) return known.error();
        options = std::move(known).value();
        options.memory_limit = memory_limit;
    }

    auto opened = Session::open(std::move(read.value().cloud), options);
    if (!opened) return opened.error();
    if (auto objection = objection_to_unused(arguments, opened.value().options())) return std::move(*objection);
    return std::optional<OpenedInput>(
        {std::move(opened).value(), std::move(read.value().warnings), std::move(read.value().saved)});
}

}  // namespace plateau::cli
