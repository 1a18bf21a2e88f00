#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"

namespace plateau::cli {

/// All bytes of a file, or of standard input for "-". Stops at once when the user interrupts: ask interrupted().
Result<std::string> read_file(const std::string& path);

/// Why the path cannot be written, if that can be told without touching it: before a long run rather than after.
std::optional<Error> check_writable(const std::string& path);

/// Replaces the file, or writes to standard output for "-". A reader who has closed the pipe is no error.
std::optional<Error> write_file(const std::string& path, std::string_view text);

/// Catches the first Ctrl-C; the second one ends the process as usual. A closed pipe no longer ends it.
void catch_signals();
bool interrupted();

}  // namespace plateau::cli
