#include "io/ply_header.h"

#include <algorithm>
#include <array>

#include "io/text.h"

namespace plateau {
namespace {

struct TypeName {
    std::string_view name;
    NumberType type;
};
constexpr std::array<TypeName, 16> kTypeNames = {{
    {"char", NumberType::Int8},
    {"int8", NumberType::Int8},
    {"uchar", NumberType::Uint8},
    {"uint8", NumberType::Uint8},
    {"short", NumberType::Int16},
    {"int16", NumberType::Int16},
    {"ushort", NumberType::Uint16},
    {"uint16", NumberType::Uint16},
    {"int", NumberType::Int32},
    {"int32", NumberType::Int32},
    {"uint", NumberType::Uint32},
    {"uint32", NumberType::Uint32},
    {"float", NumberType::Float32},
    {"float32", NumberType::Float32},
    {"double", NumberType::Float64},
    {"float64", NumberType::Float64},
}};

std::optional<NumberType> type_named(std::string_view name) {
    for (const TypeName& known : kTypeNames) {
        if (known.name == name) return known.type;
    }
    return std::nullopt;
}

using Fields = std::vector<std::string_view>;

/// Each returns whether the line is well formed.
bool read_format(const Fields& fields, PlyHeader& header) {
    if (fields.size() != 3 || fields[2] != "1.0") return false;
    if (fields[1] == "ascii")
        header.encoding = PlyEncoding::Ascii;
    else if (fields[1] == "binary_little_endian")
        header.encoding = PlyEncoding::LittleEndian;
    else if (fields[1] == "binary_big_endian")
        header.encoding = PlyEncoding::BigEndian;
    else
        return false;
    return true;
}

bool read_element(const Fields& fields, PlyHeader& header) {
    if (fields.size() != 3) return false;
    const auto count = parse_count(fields[2]);
    if (!count) return false;
    PlyElement element;
    element.name = std::string(fields[1]);
    element.count = *count;
    header.elements.push_back(std::move(element));
    return true;
}

bool read_property(const Fields& fields, PlyHeader& header) {
    if (header.elements.empty()) return false;
    const bool is_list = fields.size() == 5 && fields[1] == "list";
    if (!is_list && fields.size() != 3) return false;
    const auto type = type_named(is_list ? fields[3] : fields[1]);
    if (!type) return false;
    PlyProperty property;
    property.name = std::string(fields.back());
    property.type = *type;
    if (is_list) {
        property.list_count_type = type_named(fields[2]);
        if (!property.list_count_type || *property.list_count_type >= NumberType::Float32) return false;
    }
    header.elements.back().properties.push_back(std::move(property));
    return true;
}

}  // namespace

bool PlyElement::has_list() const {
    return std::any_of(properties.begin(), properties.end(),
                       [](const PlyProperty& property) { return property.list_count_type.has_value(); });
}

std::uint64_t PlyElement::row_size() const {
    std::uint64_t size = 0;
    for (const PlyProperty& property : properties) size += byte_size(property.type);
    return size;
}

Result<PlyHeader> parse_ply_header(std::string_view bytes) {
    PlyHeader header;
    LineScanner lines(bytes);
    Fields fields;
    bool has_format = false;
    bool ends_in_cr = false;
    const auto offset_of = [&](std::string_view line) { return static_cast<std::size_t>(line.data() - bytes.data()); };
    const auto malformed = [&](const std::string& what) {
        return Error{ErrorCode::MalformedInput, "Line " + std::to_string(lines.line_number()) + " " + what};
    };
    while (const auto line = lines.next()) {
        split_at_blanks(*line, fields);
        const std::string_view keyword = fields.empty() ? std::string_view{} : fields[0];
        if (lines.line_number() == 1) {
            if (keyword != "ply") return malformed("should be the word ply.");
            ends_in_cr = lines.position() == line->size() + 1 && bytes[line->size()] == '\r';
            continue;
        }
        if (keyword == "comment" || keyword == "obj_info" || keyword.empty()) continue;
        if (keyword == "end_header") {
            if (!has_format) return malformed("ends a PLY header that has no line \"format\".");
            header.size = lines.position();
            // In a file whose lines end in \r alone the first data byte may happen to be \n.
            if (ends_in_cr && lines.position() - offset_of(*line) == line->size() + 2) --header.size;
            header.lines = lines.line_number();
            return header;
        }
        bool good = false;
        if (keyword == "format") {
            good = has_format = read_format(fields, header);
        } else if (keyword == "element") {
            good = read_element(fields, header);
        } else if (keyword == "property") {
            good = read_property(fields, header);
        }
        if (!good) return malformed("of the PLY header is not understood: " + in_quotes(*line) + ".");
    }
    return malformed("is the last, but the PLY header has no end_header.");
}

}  // namespace plateau
