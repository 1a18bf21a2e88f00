#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plateau {

/// Walks the lines of a text; a line ends at \n, \r\n or \r, and the last one may have no end.
class LineScanner {
public:
    explicit LineScanner(std::string_view text) : text_(text) {}

    /// The next line without its end; nothing after the last.
    std::optional<std::string_view> next();
    /// 1-based number of the line that next() returned last.
    std::uint64_t line_number() const { return line_number_; }
    /// Offset of the first byte that next() has not returned.
    std::size_t position() const { return position_; }

private:
    std::string_view text_;
    std::size_t position_ = 0;
    std::uint64_t line_number_ = 0;
};

/// What a field of a text holds.
enum class FieldKind : std::uint8_t {
    Number,
    NotFinite,  ///< nan, inf, or beyond the range of double
    NotNumber,
};

struct ParsedField {
    FieldKind kind = FieldKind::NotNumber;
    double value = 0;
};

/// Reads a decimal number that fills the whole field, correctly rounded.
ParsedField parse_field(std::string_view field);

/// "nan" in any case and with any sign, also as "nan(ind)": a number that is missing, unlike one out of range.
bool is_nan(std::string_view field);

/// A non-negative integer that fills the whole field and fits.
std::optional<std::uint64_t> parse_count(std::string_view field);

/// Fields between blanks and tabs, into `fields`.
void split_at_blanks(std::string_view line, std::vector<std::string_view>& fields);

/// The first line that is neither empty nor a comment after "#", without blanks at its ends; empty if there is none.
std::string_view first_content_line(std::string_view text);

/// Without blanks, tabs and other control characters at both ends.
std::string_view trimmed(std::string_view text);

std::string lower_case(std::string_view text);

/// The field in quotation marks, cut and made printable: fit for a message whatever the file holds.
std::string in_quotes(std::string_view field);

}  // namespace plateau
