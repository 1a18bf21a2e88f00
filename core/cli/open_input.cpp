#include "cli/open_input.h"

#include <unistd.h>

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
    return std::optional<OpenedInput>(
        {std::move(opened).value(), std::move(read.value().warnings), std::move(read.value().saved)});
}

}  // namespace plateau::cli
