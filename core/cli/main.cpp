#include <cstdio>
#include <type_traits>
#include <variant>

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
    const auto code = std::visit(
        [](const auto& asked) -> plateau::Result<int> {
            using Asked = std::decay_t<decltype(asked)>;
            if constexpr (std::is_same_v<Asked, RunArguments>) return run(asked);
            if constexpr (std::is_same_v<Asked, InspectArguments>) return inspect(asked);
            if constexpr (std::is_same_v<Asked, SampleArguments>) return sample(asked);
            return kDone;
        },
        arguments.value());
    return code ? code.value() : report(code.error());
}
