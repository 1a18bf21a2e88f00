#include "io/text.h"

#include <charconv>
#include <cmath>
#include <system_error>

#include <fast_float/fast_float.h>

namespace plateau {
namespace {

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

}  // namespace

std::optional<std::string_view> LineScanner::next() {
    if (position_ >= text_.size()) return std::nullopt;
    ++line_number_;
    const std::size_t begin = position_;
    std::size_t end = begin;
    while (end < text_.size() && text_[end] != '\n' && text_[end] != '\r') ++end;
    position_ = end;
    if (position_ < text_.size()) {
        const bool pair = text_[end] == '\r' && end + 1 < text_.size() && text_[end + 1] == '\n';
        position_ += pair ? 2 : 1;
    }
    return text_.substr(begin, end - begin);
}

ParsedField parse_field(std::string_view field) {
    bool has_digit = false;
    bool only_decimal = !field.empty();
    for (const char c : field) {
        has_digit = has_digit || is_digit(c);
        only_decimal = only_decimal && (is_digit(c) || c == '+' || c == '-' || c == '.' || c == 'e' || c == 'E');
    }
    if (!only_decimal || !has_digit) {
        std::string name = lower_case(field.substr(0, 10));
        if (!name.empty() && (name[0] == '+' || name[0] == '-')) name.erase(0, 1);
        if (name == "nan" || name == "inf" || name == "infinity") return {FieldKind::NotFinite, 0};
        return {};
    }
    // Not std::from_chars, which one of our standard libraries lacks for double; and it takes no plus sign.
    const char* const first = field.data() + (field[0] == '+' ? 1 : 0);
    const char* const last = field.data() + field.size();
    double value = 0;
    const auto [end, failure] = fast_float::from_chars(first, last, value);
    const bool signed_twice = first != field.data() && first != last && *first == '-';
    if (failure == std::errc::invalid_argument || end != last || signed_twice) return {};
    return {std::isfinite(value) ? FieldKind::Number : FieldKind::NotFinite, value};
}

bool is_nan(std::string_view field) {
    if (!field.empty() && (field[0] == '+' || field[0] == '-')) field.remove_prefix(1);
    const bool whole = field.size() == 3 || (field.size() > 3 && field[3] == '(' && field.back() == ')');
    return whole && lower_case(field.substr(0, 3)) == "nan";
}

std::optional<std::uint64_t> parse_count(std::string_view field) {
    std::uint64_t count = 0;
    const auto [end, failure] = std::from_chars(field.data(), field.data() + field.size(), count);
    if (failure != std::errc{} || end != field.data() + field.size()) return std::nullopt;
    return count;
}

void split_at_blanks(std::string_view line, std::vector<std::string_view>& fields) {
    fields.clear();
    std::size_t at = 0;
    while (true) {
        while (at < line.size() && is_blank(line[at])) ++at;
        if (at == line.size()) return;
        const std::size_t begin = at;
        while (at < line.size() && !is_blank(line[at])) ++at;
        fields.push_back(line.substr(begin, at - begin));
    }
}

std::string_view first_content_line(std::string_view text) {
    LineScanner lines(text);
    while (const auto line = lines.next()) {
        const std::string_view content = trimmed(*line);
        if (!content.empty() && content[0] != '#') return content;
    }
    return {};
}

std::string_view trimmed(std::string_view text) {
    const auto blank = [](char c) { return static_cast<unsigned char>(c) <= ' '; };
    while (!text.empty() && blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && blank(text.back())) text.remove_suffix(1);
    return text;
}

std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return lower;
}

std::string in_quotes(std::string_view field) {
    constexpr std::size_t kLongest = 24;
    std::string text = "\"";
    for (const char c : field.substr(0, kLongest)) text += c >= ' ' && c <= '~' ? c : '?';
    return text + (field.size() > kLongest ? "...\"" : "\"");
}

}  // namespace plateau
