#include "io/npy_header.h"

#include <array>
#include <optional>
#include <string>

#include "io/text.h"

namespace plateau {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view kMagic = "\x93NUMPY"sv;
constexpr std::size_t kMaxExtents = 32;  // NumPy's own limit was 32 for long

/// Walks the literal of a Python dictionary, the only one that NumPy writes: strings, truth values, tuples of integers.
class Literal {
public:
    explicit Literal(std::string_view text) : text_(text) {}

    /// Passes over the sign, if it comes next.
    bool take(char sign) {
        skip_blanks();
        if (at_ == text_.size() || text_[at_] != sign) return false;
        ++at_;
        return true;
    }

    bool at_end() {
        skip_blanks();
        return at_ == text_.size();
    }

    std::optional<std::string_view> string() {
        const char quote = take('\'') ? '\'' : '"';
        if (quote == '"' && !take('"')) return std::nullopt;
        const std::size_t end = text_.find(quote, at_);
        if (end == std::string_view::npos) return std::nullopt;
        const std::string_view value = text_.substr(at_, end - at_);
        at_ = end + 1;
        return value;
    }

    std::optional<bool> truth() {
        skip_blanks();
        for (const auto& [word, value] : {std::pair{"True"sv, true}, std::pair{"False"sv, false}}) {
            if (!text_.substr(at_).starts_with(word)) continue;
            at_ += word.size();
            return value;
        }
        return std::nullopt;
    }

    std::optional<std::vector<std::uint64_t>> tuple() {
        std::vector<std::uint64_t> values;
        if (!take('(')) return std::nullopt;
        while (!take(')')) {
            if (!values.empty() && !take(',')) return std::nullopt;
            if (!values.empty() && take(')')) break;
            skip_blanks();
            const std::size_t begin = at_;
            while (at_ < text_.size() && text_[at_] >= '0' && text_[at_] <= '9') ++at_;
            const auto value = parse_count(text_.substr(begin, at_ - begin));
            if (!value || values.size() == kMaxExtents) return std::nullopt;
            values.push_back(*value);
            take('L');  // Python 2 wrote 3L
        }
        return values;
    }

private:
    void skip_blanks() {
        while (at_ < text_.size() && static_cast<unsigned char>(text_[at_]) <= ' ') ++at_;
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

struct TypeName {
    std::string_view name;
    NumberType type;
};
constexpr std::array<TypeName, 10> kTypeNames = {{
    {"i1", NumberType::Int8},
    {"u1", NumberType::Uint8},
    {"i2", NumberType::Int16},
    {"u2", NumberType::Uint16},
    {"i4", NumberType::Int32},
    {"u4", NumberType::Uint32},
    {"i8", NumberType::Int64},
    {"u8", NumberType::Uint64},
    {"f4", NumberType::Float32},
    {"f8", NumberType::Float64},
}};

/// Sets type and order by a description such as "<f8"; whether it is known.
bool set_type(std::string_view description, NpyHeader& header) {
    if (description.empty()) return false;
    const char order = description[0];
    if (order != '<' && order != '>' && order != '|' && order != '=') return false;
    header.order = order == '>' ? ByteOrder::BigEndian : ByteOrder::LittleEndian;
    for (const TypeName& known : kTypeNames) {
        if (known.name != description.substr(1)) continue;
        header.type = known.type;
        return true;
    }
    return false;
}

Error malformed(std::string sentence) {
    return {ErrorCode::MalformedInput, std::move(sentence)};
}

/// The dictionary, without its place in the file.
Result<NpyHeader> parse_dictionary(std::string_view text) {
    NpyHeader header;
    Literal literal(text);
    std::optional<std::string_view> description;
    std::optional<bool> by_columns;
    std::optional<std::vector<std::uint64_t>> shape;
    const auto not_understood = [&] {
        return malformed("The header of this NumPy file is not understood: " + in_quotes(trimmed(text)) + ".");
    };
    if (!literal.take('{')) return not_understood();
    while (!literal.take('}')) {
        const auto key = literal.string();
        if (!key || !literal.take(':')) return not_understood();
        bool good = false;
        if (*key == "descr") {
            if (literal.take('[')) {
                return Error{ErrorCode::UnknownFormat,
                             "This NumPy array has named fields; save the coordinates as a plain array of shape "
                             "(n, 3), for instance with numpy.lib.recfunctions.structured_to_unstructured."};
            }
            good = (description = literal.string()).has_value();
        } else if (*key == "fortran_order") {
            good = (by_columns = literal.truth()).has_value();
        } else if (*key == "shape") {
            good = (shape = literal.tuple()).has_value();
        }
        if (!good) return not_understood();
        if (!literal.take(',')) {
            if (!literal.take('}')) return not_understood();
            break;
        }
    }
    if (!literal.at_end() || !description || !by_columns || !shape) return not_understood();
    if (!set_type(*description, header)) {
        return Error{ErrorCode::UnknownFormat, "This NumPy array holds values of type " + in_quotes(*description) +
                                                   "; save it as real numbers, for instance with .astype(float)."};
    }
    header.by_columns = *by_columns;
    header.shape = std::move(*shape);
    return header;
}

}  // namespace

bool begins_as_npy(std::string_view bytes) {
    return bytes.starts_with(kMagic);
}

Result<NpyHeader> parse_npy_header(std::string_view bytes) {
    if (!begins_as_npy(bytes)) return malformed("This is no NumPy array: it does not begin as one.");
    const Error cut_off = malformed("This NumPy file ends within its header.");
    const std::size_t version_at = kMagic.size();
    if (bytes.size() < version_at + 2) return cut_off;
    const int version = static_cast<unsigned char>(bytes[version_at]);
    if (version < 1 || version > 3) {
        return malformed("This NumPy file is of version " + std::to_string(version) +
                         ", of which nothing is known here; versions 1 to 3 are read.");
    }
    const NumberType length_type = version == 1 ? NumberType::Uint16 : NumberType::Uint32;
    const std::size_t text_at = version_at + 2 + byte_size(length_type);
    if (bytes.size() < text_at) return cut_off;
    const auto length =
        static_cast<std::uint64_t>(decode_number(bytes.data() + version_at + 2, length_type, ByteOrder::LittleEndian));
    if (bytes.size() - text_at < length) return cut_off;
    auto header = parse_dictionary(bytes.substr(text_at, static_cast<std::size_t>(length)));
    if (header) header.value().size = text_at + static_cast<std::size_t>(length);
    return header;
}

}  // namespace plateau
