#include "io/pcd_header.h"

#include <limits>
#include <optional>

#include "io/text.h"

namespace plateau {
namespace {

constexpr std::uint64_t kMaxColumns = 4096;

using Fields = std::vector<std::string_view>;

std::optional<NumberType> type_of(std::string_view letter, std::uint64_t size) {
    if (letter == "F") {
        if (size == 4) return NumberType::Float32;
        if (size == 8) return NumberType::Float64;
        return std::nullopt;
    }
    const bool has_sign = letter == "I";
    if (!has_sign && letter != "U") return std::nullopt;
    switch (size) {
        case 1:
            return has_sign ? NumberType::Int8 : NumberType::Uint8;
        case 2:
            return has_sign ? NumberType::Int16 : NumberType::Uint16;
        case 4:
            return has_sign ? NumberType::Int32 : NumberType::Uint32;
        case 8:
            return has_sign ? NumberType::Int64 : NumberType::Uint64;
        default:
            return std::nullopt;
    }
}

std::optional<PcdEncoding> encoding_named(std::string_view name) {
    if (name == "ascii") return PcdEncoding::Ascii;
    if (name == "binary") return PcdEncoding::Binary;
    if (name == "binary_compressed") return PcdEncoding::Compressed;
    return std::nullopt;
}

bool is_known_version(std::string_view version) {
    if (version.starts_with("0")) version.remove_prefix(1);
    return version == ".7" || version == ".6" || version == ".5";
}

/// The entries of the header as they stand, before they are held against each other.
struct Entries {
    std::vector<std::string> names;
    std::vector<std::uint64_t> sizes;
    std::vector<std::string> types;
    std::vector<std::uint64_t> counts;
    std::optional<std::uint64_t> width;
    std::optional<std::uint64_t> height;
    std::optional<std::uint64_t> points;
};

bool read_counts(const Fields& words, std::vector<std::uint64_t>& counts) {
    counts.clear();
    for (std::size_t k = 1; k < words.size(); ++k) {
        const auto count = parse_count(words[k]);
        if (!count) return false;
        counts.push_back(*count);
    }
    return true;
}

bool read_count(const Fields& words, std::optional<std::uint64_t>& count) {
    if (words.size() != 2) return false;
    count = parse_count(words[1]);
    return count.has_value();
}

/// Whether the line is an entry of a PCD header, and well formed.
bool read_entry(const Fields& words, Entries& entries) {
    const std::string_view keyword = words[0];
    if (keyword == "VERSION") return words.size() == 2 && is_known_version(words[1]);
    if (keyword == "FIELDS" || keyword == "COLUMNS") {
        entries.names.assign(words.begin() + 1, words.end());
        return true;
    }
    if (keyword == "TYPE") {
        entries.types.assign(words.begin() + 1, words.end());
        return true;
    }
    if (keyword == "SIZE") return read_counts(words, entries.sizes);
    if (keyword == "COUNT") return read_counts(words, entries.counts);
    if (keyword == "WIDTH") return read_count(words, entries.width);
    if (keyword == "HEIGHT") return read_count(words, entries.height);
    if (keyword == "POINTS") return read_count(words, entries.points);
    return keyword == "VIEWPOINT";
}

Error malformed(std::string sentence) {
    return {ErrorCode::MalformedInput, std::move(sentence)};
}

std::optional<Error> settle_fields(const Entries& entries, PcdHeader& header) {
    const std::size_t size = entries.names.size();
    if (size == 0) return malformed("The PCD header names no FIELDS.");
    const std::size_t counts = entries.counts.empty() ? size : entries.counts.size();
    if (entries.sizes.size() != size || entries.types.size() != size || counts != size) {
        return malformed("The PCD header needs one SIZE, TYPE and COUNT for each of its " + std::to_string(size) +
                         " FIELDS.");
    }
    std::uint64_t columns = 0;
    for (std::size_t k = 0; k < size; ++k) {
        const auto type = type_of(entries.types[k], entries.sizes[k]);
        if (!type) {
            return malformed("The PCD header gives field " + in_quotes(entries.names[k]) + " the unknown TYPE " +
                             in_quotes(entries.types[k]) + " of SIZE " + std::to_string(entries.sizes[k]) + ".");
        }
        const std::uint64_t count = entries.counts.empty() ? 1 : entries.counts[k];
        if (count > kMaxColumns - columns) {
            return malformed("The PCD header promises more than 4096 values a point: these are no points.");
        }
        columns += count;
        header.fields.push_back({entries.names[k], *type, static_cast<std::uint32_t>(count)});
    }
    return std::nullopt;
}

std::optional<Error> settle_points(const Entries& entries, PcdHeader& header) {
    if (entries.width && entries.height) {
        const std::uint64_t width = *entries.width;
        const std::uint64_t height = *entries.height;
        const bool fits = height == 0 || width <= std::numeric_limits<std::uint64_t>::max() / height;
        if (!fits || (entries.points && *entries.points != width * height)) {
            return malformed("The PCD header contradicts itself: WIDTH " + std::to_string(width) + " times HEIGHT " +
                             std::to_string(height) + " is not " +
                             (entries.points ? "POINTS " + std::to_string(*entries.points) : "a number of points") +
                             ".");
        }
        header.points = width * height;
        return std::nullopt;
    }
    if (!entries.points) return malformed("The PCD header does not say how many POINTS there are.");
    header.points = *entries.points;
    return std::nullopt;
}

}  // namespace

std::uint32_t PcdHeader::columns() const {
    std::uint32_t columns = 0;
    for (const PcdField& field : fields) columns += field.count;
    return columns;
}

std::uint64_t PcdHeader::row_size() const {
    std::uint64_t bytes = 0;
    for (const PcdField& field : fields) bytes += std::uint64_t{byte_size(field.type)} * field.count;
    return bytes;
}

bool begins_as_pcd(std::string_view bytes) {
    if (bytes.starts_with("# .PCD")) return true;
    const std::string_view line = first_content_line(bytes);
    return line.starts_with("VERSION 0.") || line.starts_with("VERSION .");
}

Result<PcdHeader> parse_pcd_header(std::string_view bytes) {
    PcdHeader header;
    Entries entries;
    LineScanner lines(bytes);
    Fields words;
    while (const auto line = lines.next()) {
        split_at_blanks(*line, words);
        if (words.empty() || words[0].starts_with("#")) continue;
        const bool last = words[0] == "DATA";
        const auto encoding = last && words.size() == 2 ? encoding_named(words[1]) : std::nullopt;
        if (last ? !encoding.has_value() : !read_entry(words, entries)) {
            return malformed("Line " + std::to_string(lines.line_number()) +
                             " of the PCD header is not understood: " + in_quotes(*line) + ".");
        }
        if (!last) continue;
        if (auto error = settle_fields(entries, header)) return std::move(*error);
        if (auto error = settle_points(entries, header)) return std::move(*error);
        header.encoding = *encoding;
        header.size = lines.position();
        header.lines = lines.line_number();
        return header;
    }
    return malformed("The PCD header has no line DATA.");
}

}  // namespace plateau
