#include "io/fields.h"

#include <string>

#include "io/text.h"

namespace plateau {

std::size_t comment_mark(std::string_view line) {
    if (line.starts_with("//")) return 2;
    return line.starts_with("#") || line.starts_with(";") ? 1 : 0;
}

std::optional<Error> split_fields(std::string_view line, std::uint64_t line_number,
                                  std::vector<std::string_view>& fields) {
    const bool commas = line.find(',') != std::string_view::npos;
    const bool semicolons = line.find(';') != std::string_view::npos;
    if (commas && semicolons) {
        return Error{ErrorCode::MalformedInput,
                     "Line " + std::to_string(line_number) +
                         " has commas and semicolons: write decimals with a point and use one separator."};
    }
    if (!commas && !semicolons) {
        split_at_blanks(line, fields);
        return std::nullopt;
    }
    fields.clear();
    const char separator = commas ? ',' : ';';
    while (!line.empty()) {
        const std::size_t end = line.find(separator);
        fields.push_back(trimmed(line.substr(0, end)));
        if (end == std::string_view::npos) break;
        line.remove_prefix(end + 1);
    }
    return std::nullopt;
}

Error not_a_number(std::string_view field, std::uint64_t line_number) {
    const std::string what = field.empty() ? "an empty field" : in_quotes(field);
    return {ErrorCode::MalformedInput,
            "Line " + std::to_string(line_number) + " has " + what + " where a number should be."};
}

}  // namespace plateau
