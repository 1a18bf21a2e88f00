#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "io/fields.h"
#include "io/matrix_sink.h"
#include "io/text.h"

namespace plateau {
namespace {

using Fields = std::vector<std::string_view>;

bool is_number(std::string_view field) {
    return parse_field(field).kind != FieldKind::NotNumber;
}

bool is_zero(std::string_view field) {
    const ParsedField parsed = parse_field(field);
    return parsed.kind == FieldKind::Number && parsed.value == 0;
}

bool is_content(std::string_view line) {
    return !line.empty() && comment_mark(line) == 0;
}

/// The last line with content; empty if there is none.
std::string_view last_content_line(std::string_view text) {
    while (!text.empty()) {
        const std::size_t end = text.find_last_of("\n\r");
        const std::string_view line = trimmed(end == std::string_view::npos ? text : text.substr(end + 1));
        if (is_content(line)) return line;
        if (end == std::string_view::npos) break;
        text = text.substr(0, end);
    }
    return {};
}

class MatrixTableReader : public FormatReader {
public:
    MatrixTableReader(std::string_view bytes, MatrixSink& sink) : bytes_(bytes), lines_(bytes), sink_(sink) {}

    Result<ReadStatus> advance(std::uint32_t rows) override {
        constexpr std::uint32_t kNumbersARow = 16;
        constexpr std::uint32_t kTriplesARow = 64;
        if (is_read_) return sink_.check_triangles(rows * kTriplesARow);
        if (!is_planned_) {
            if (auto error = plan()) return std::move(*error);
            is_planned_ = true;
        }
        for (std::uint64_t numbers = 0; numbers < std::uint64_t{rows} * kNumbersARow; numbers += 1 + fields_.size()) {
            const auto line = next_content();
            if (!line) {
                if (row_ < row_count()) return too_few_rows();
                is_read_ = true;
                break;
            }
            if (auto error = read_row(*line)) return std::move(*error);
        }
        return ReadStatus::More;
    }

private:
    std::uint32_t row_count() const { return is_triangle_ && !has_diagonal_ ? size_ - std::min(size_, 1u) : size_; }

    std::optional<std::string_view> next_content() {
        while (const auto line = lines_.next()) {
            const std::string_view content = trimmed(*line);
            if (is_content(content)) return content;
        }
        return std::nullopt;
    }

    std::optional<Error> split(std::string_view line) {
        if (auto error = split_fields(line, lines_.line_number(), fields_)) return error;
        if (has_labels_ && !fields_.empty()) fields_.erase(fields_.begin());
        return std::nullopt;
    }

    /// Looks at the first rows and the last one: names, labels, shape, size. Memory is asked for before it is taken.
    std::optional<Error> plan() {
        const auto first = next_content();
        if (!first) return std::nullopt;
        if (auto error = split(*first)) return error;
        std::optional<std::string_view> row = first;
        // Names without a number, or behind an empty corner. A name and numbers are a labelled row.
        const bool corner = fields_.front().empty();
        if (!is_number(fields_.front()) && (corner || fields_.size() < 2 || !is_number(fields_[1]))) {
            row = next_content();
            if (!row) return std::nullopt;
            if (auto error = split(*row)) return error;
        }
        has_labels_ = corner || !is_number(fields_.front());
        const std::string_view label = fields_.front();
        if (auto error = split(*row)) return error;
        if (fields_.empty()) return not_a_number(label, lines_.line_number());
        first_row_line_ = lines_.line_number();
        const LineScanner at_second_row = lines_;
        is_triangle_ = fields_.size() == 1;
        std::uint64_t n = fields_.size();
        if (is_triangle_) {
            has_diagonal_ = begins_with_diagonal();
            if (auto error = split(last_content_line(bytes_))) return error;
            n = fields_.size() + (has_diagonal_ ? 0 : 1);
        }
        lines_ = at_second_row;
        return start(*row, n);
    }

    std::optional<Error> start(std::string_view row, std::uint64_t n) {
        if (auto error = sink_.begin(n, false)) return error;
        size_ = static_cast<std::uint32_t>(n);
        return read_row(row);
    }

    /// Whether most of the first rows end with a distance of 0, beginning with the first.
    bool begins_with_diagonal() {
        constexpr int kRowsToLookAt = 64;
        if (!is_zero(fields_.front())) return false;
        int rows = 1;
        int zeros = 1;
        while (rows < kRowsToLookAt) {
            const auto line = next_content();
            if (!line || split(*line) || fields_.empty()) break;
            ++rows;
            if (is_zero(fields_.back())) ++zeros;
        }
        return 2 * zeros > rows;
    }

    std::optional<Error> read_row(std::string_view line) {
        if (auto error = split(line)) return error;
        const std::uint64_t number = lines_.line_number();
        if (row_ == row_count()) {
            return Error{ErrorCode::RaggedRows,
                         "Line " + std::to_string(number) + " is one row more than there are " +
                             (is_triangle_ ? "distances in the last row." : "columns: a matrix is square.")};
        }
        const std::uint32_t width = is_triangle_ ? row_ + 1 : size_;
        if (fields_.size() != width) return wrong_width(number, width);
        for (std::uint32_t column = 0; column < width; ++column) {
            const EntryPlace place{row_ + 1ull, column + 1ull, number};
            const std::string_view field = fields_[column];
            const ParsedField parsed = parse_field(field);
            if (parsed.kind == FieldKind::NotNumber) {
                return Error{ErrorCode::MalformedInput, text_of(place) + ": " +
                                                            (field.empty() ? "an empty field" : in_quotes(field)) +
                                                            " where a distance should be."};
            }
            const double value =
                parsed.kind == FieldKind::Number ? parsed.value : std::numeric_limits<double>::quiet_NaN();
            if (auto error = set(column, value, place)) return error;
        }
        ++row_;
        return std::nullopt;
    }

    std::optional<Error> set(std::uint32_t column, double value, const EntryPlace& place) {
        if (!is_triangle_) return sink_.set_square(row_, column, value, place);
        if (!has_diagonal_) return sink_.set_once(row_ + 1, column, value, place);
        if (row_ == column) return sink_.check_diagonal(value, place);
        return sink_.set_once(row_, column, value, place);
    }

    Error wrong_width(std::uint64_t number, std::uint32_t width) const {
        const std::string shape = is_triangle_ ? ": below a diagonal the rows have 1, 2, 3, ... numbers."
                                               : ", as many as line " + std::to_string(first_row_line_) +
                                                     ": a matrix is square, or what is below its diagonal.";
        return {ErrorCode::RaggedRows, "Line " + std::to_string(number) + " has " + std::to_string(fields_.size()) +
                                           (fields_.size() == 1 ? " distance" : " distances") + " instead of " +
                                           std::to_string(width) + shape};
    }

    Error too_few_rows() const {
        return {ErrorCode::RaggedRows, "The matrix ends after row " + std::to_string(row_) + " of " +
                                           std::to_string(row_count()) + ": it is not square."};
    }

    std::string_view bytes_;
    LineScanner lines_;
    MatrixSink& sink_;
    Fields fields_;
    bool is_planned_ = false;
    bool is_read_ = false;
    bool has_labels_ = false;
    bool is_triangle_ = false;
    bool has_diagonal_ = false;  ///< of a triangle
    std::uint32_t size_ = 0;     ///< witnesses
    std::uint32_t row_ = 0;      ///< rows that were read
    std::uint64_t first_row_line_ = 0;
};

}  // namespace

std::unique_ptr<FormatReader> make_matrix_table_reader(std::string_view bytes, MatrixSink& sink) {
    return std::make_unique<MatrixTableReader>(bytes, sink);
}

}  // namespace plateau
