#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/words.h"
#include "io/session_file.h"
#include "io/text.h"

namespace plateau {
namespace {

constexpr std::string_view kVersion = "1";

/// A 64-bit number of 16 hexadecimal digits.
std::optional<std::uint64_t> parse_hash(std::string_view text) {
    constexpr std::size_t kDigits = 16;
    if (text.size() != kDigits) return std::nullopt;
    std::uint64_t hash = 0;
    for (const char c : text) {
        const std::size_t digit = std::string_view("0123456789abcdef").find(c);
        if (digit == std::string_view::npos) return std::nullopt;
        hash = hash << 4 | digit;
    }
    return hash;
}

class HeaderParser {
public:
    explicit HeaderParser(std::string_view bytes) : bytes_(bytes), lines_(bytes) {}

    Result<SessionHeader> parsed() {
        lines_.next();  // the mark, which was looked at
        for (auto line = lines_.next(); line; line = lines_.next()) {
            if (*line == "data") return complete();
            split_at_blanks(*line, fields_);
            if (!read_entry()) {
                return malformed("Line " + std::to_string(lines_.line_number()) + " of the session is " +
                                 in_quotes(*line) + ", which means nothing there.");
            }
        }
        return malformed("The header of this session has no end.");
    }

private:
    static Error malformed(std::string sentence) { return {ErrorCode::MalformedInput, std::move(sentence)}; }

    bool read_entry() {
        const std::string_view name = fields_.empty() ? std::string_view{} : fields_[0];
        if (name == "option" && fields_.size() == 3) {
            header_.saved.options.push_back({std::string(fields_[1]), std::string(fields_[2])});
            return true;
        }
        if (name == "reached" && fields_.size() == 3) {
            const auto hash = parse_hash(fields_[2]);
            header_.saved.hash = hash.value_or(0);
            return hash && read_step(fields_[1], header_.saved.reached);
        }
        if (name == "shown" && fields_.size() == 2) return read_step(fields_[1], header_.saved.shown);
        if (name == "view" && fields_.size() == 2) return read_count(fields_[1], view_size_);
        if (name == "points" && fields_.size() == 4) {
            header_.has_distances = false;
            return read_count(fields_[1], header_.count) && read_count(fields_[2], header_.dimension) &&
                   read_precision(fields_[3]);
        }
        if (name == "distances" && fields_.size() == 3) {
            header_.has_distances = true;
            header_.dimension = 0;
            return read_count(fields_[1], header_.count) && read_precision(fields_[2]);
        }
        return false;
    }

    static bool read_count(std::string_view field, std::uint64_t& number) {
        const auto parsed = parse_count(field);
        number = parsed.value_or(0);
        return parsed.has_value();
    }

    static bool read_step(std::string_view field, std::uint32_t& step) {
        std::uint64_t number = 0;
        if (!read_count(field, number) || number > std::numeric_limits<std::uint32_t>::max()) return false;
        step = static_cast<std::uint32_t>(number);
        return true;
    }

    bool read_precision(std::string_view field) {
        header_.single_precision = field == "single";
        return field == "single" || field == "double";
    }

    /// The view and the place of the numbers, which must be as many as the header says.
    Result<SessionHeader> complete() {
        const std::size_t begin = lines_.position();
        if (header_.count == 0) return malformed("The session holds no points.");
        if (!header_.has_distances && header_.dimension < 2) {
            return Error{ErrorCode::UnsupportedDimension, "The points of the session need at least 2 coordinates."};
        }
        if (bytes_.size() - begin < view_size_) return malformed("The session ends before its numbers.");
        header_.saved.view = std::string(bytes_.substr(begin, static_cast<std::size_t>(view_size_)));
        header_.data_at = begin + static_cast<std::size_t>(view_size_);

        const std::size_t size = header_.single_precision ? sizeof(float) : sizeof(double);
        const std::uint64_t there = (bytes_.size() - header_.data_at) / size;
        const bool is_whole = (bytes_.size() - header_.data_at) % size == 0;
        // What a header says can overflow when it is multiplied.
        constexpr std::uint64_t kMost = std::numeric_limits<std::uint32_t>::max();
        const bool fits = header_.count <= kMost && header_.dimension <= kMost;
        const std::uint64_t promised = !fits                   ? 0
                                       : header_.has_distances ? DistanceMatrix::entry_count(header_.count)
                                                               : header_.count * header_.dimension;
        if (!fits || !is_whole || promised != there) {
            return malformed("The session promises " + (fits ? grouped(promised) : std::string("more")) +
                             " numbers, but " + grouped(there) + (is_whole ? " are there." : " and a part are there."));
        }
        return std::move(header_);
    }

    std::string_view bytes_;
    LineScanner lines_;
    SessionHeader header_;
    std::uint64_t view_size_ = 0;
    std::vector<std::string_view> fields_;
};

}  // namespace

bool begins_as_session(std::string_view bytes) {
    return bytes.starts_with(kSessionMark);
}

Result<SessionHeader> parse_session_header(std::string_view bytes) {
    const std::string_view version = trimmed(LineScanner(bytes).next().value_or("").substr(kSessionMark.size()));
    if (version != kVersion) {
        return Error{ErrorCode::UnknownFormat, "This is a session of format " + in_quotes(version) +
                                                   "; this version of Plateau reads format " + std::string(kVersion) +
                                                   "."};
    }
    return HeaderParser(bytes).parsed();
}

}  // namespace plateau
