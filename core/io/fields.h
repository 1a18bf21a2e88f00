#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace plateau {

/// Length of the mark that makes the line of a table a comment, 0 if it is none.
std::size_t comment_mark(std::string_view line);

/// Splits the line of a table: at blanks, or at commas or semicolons with any blanks around; one separator at the end
/// of the line counts for nothing. Error: MalformedInput for a line with commas and semicolons.
std::optional<Error> split_fields(std::string_view line, std::uint64_t line_number,
                                  std::vector<std::string_view>& fields);

/// What to say of a field that is no number.
Error not_a_number(std::string_view field, std::uint64_t line_number);

}  // namespace plateau
