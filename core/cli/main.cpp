#include <cstdio>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/files.h"

namespace {

int report(const plateau::Error& error) {
    std::fprintf(stderr, "plateau: %s\n", error.message.c_str());
    return plateau::cli::kBadInput;
}

}  // namespace

int main(int count, char** values) {
    using namespace plateau::cli;
    catch_signals();
    const auto arguments = parse_arguments(count, values);
    if (!arguments) return report(arguments.error());
    if (const auto* request = std::get_if<TextRequest>(&arguments.value())) {
        const auto error = write_file("-", request->text);
        return error ? report(*error) : kDone;
    }
    const auto* run_arguments = std::get_if<RunArguments>(&arguments.value());
    const auto code =
        run_arguments != nullptr ? run(*run_arguments) : sample(*std::get_if<SampleArguments>(&arguments.value()));
    return code ? code.value() : report(code.error());
}
