#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "io/exact_text.h"
#include "io/fields.h"
#include "io/format_reader.h"
#include "io/text.h"

namespace plateau {
namespace {

constexpr std::size_t kMaxColumns = 4096;

class TableReader : public FormatReader {
public:
    TableReader(std::string_view bytes, std::string_view extension, RowSink& sink)
        : lines_(bytes), is_xyz_(extension == "xyz"), sink_(sink) {}

    Result<ReadStatus> advance(std::uint32_t rows) override {
        for (std::uint32_t k = 0; k < rows; ++k) {
            const auto line = lines_.next();
            if (!line) return ReadStatus::Done;
            if (auto error = read_line(trimmed(*line))) return std::move(*error);
        }
        return ReadStatus::More;
    }

private:
    std::optional<Error> read_line(std::string_view line) {
        if (line.empty()) return std::nullopt;
        if (const std::size_t mark = comment_mark(line)) {
            // Some programs write the names of the columns as a comment ("//X Y Z R G B").
            if (width_ == 0 && !has_header_ && !split(line.substr(mark))) take_names();
            return std::nullopt;
        }
        if (auto error = split(line)) return error;
        if (width_ == 0) {
            if (!has_header_ && is_header()) {
                has_header_ = true;
                take_names();
                return std::nullopt;
            }
            // A second line of words is no table, and not a question of columns.
            if (is_header()) return not_a_number(fields_.front(), lines_.line_number());
            width_ = static_cast<std::uint32_t>(fields_.size());
            first_row_line_ = lines_.line_number();
            if (auto error = choose_columns()) return error;
        }
        if (fields_.size() != width_) {
            return Error{ErrorCode::RaggedRows,
                         "Line " + std::to_string(lines_.line_number()) + " has " + std::to_string(fields_.size()) +
                             (fields_.size() == 1 ? " column, but line " : " columns, but line ") +
                             std::to_string(first_row_line_) + " has " + std::to_string(width_) + "."};
        }
        return sink_.add_fields(fields_, lines_.line_number());
    }

    std::optional<Error> split(std::string_view line) {
        if (auto error = split_fields(line, lines_.line_number(), fields_)) return error;
        if (fields_.size() > kMaxColumns) {
            return Error{ErrorCode::MalformedInput, "Line " + std::to_string(lines_.line_number()) + " has " +
                                                        std::to_string(fields_.size()) +
                                                        " columns: more than 4096 are no table of points."};
        }
        return std::nullopt;
    }

    /// The first line is one of names if none of the fields that count is a number.
    bool is_header() const {
        for (const std::string_view field : fields_) {
            if (parse_field(field).kind != FieldKind::NotNumber) return false;
        }
        return true;
    }

    /// Keeps the fields as the names of the columns if two of them are x and y.
    void take_names() {
        std::vector<std::string> names;
        bool has_x = false;
        bool has_y = false;
        for (std::string_view field : fields_) {
            if (field.size() >= 2 && field.front() == '"' && field.back() == '"') {
                field = field.substr(1, field.size() - 2);
            }
            names.push_back(lower_case(trimmed(field)));
            has_x = has_x || names.back() == "x";
            has_y = has_y || names.back() == "y";
        }
        if (has_x && has_y) names_ = std::move(names);
    }

    std::optional<std::uint32_t> column_named(std::string_view name) const {
        for (std::size_t k = 0; k < names_.size(); ++k) {
            if (names_[k] == name) return static_cast<std::uint32_t>(k);
        }
        return std::nullopt;
    }

    std::optional<Error> choose_columns() {
        if (sink_.columns_asked()) return sink_.choose(width_, {});
        std::vector<std::uint32_t> columns;
        if (names_.size() == width_) {
            const auto x = column_named("x");
            const auto y = column_named("y");
            const auto z = column_named("z");
            if (x && y) columns = {*x, *y};
            if (x && y && z) columns.push_back(*z);
        }
        const bool by_name = !columns.empty();
        if (columns.empty() && width_ == 1) {
            return Error{ErrorCode::UnsupportedDimension, "Line " + std::to_string(lines_.line_number()) +
                                                              " has one column; points need two or three coordinates."};
        }
        if (columns.empty() && width_ > 3 && !is_xyz_ && !sink_.takes_any_dimension()) {
            return Error{ErrorCode::UnsupportedDimension,
                         std::to_string(width_) + " columns: choose the coordinates with --columns 1,2,3"};
        }
        if (columns.empty()) {
            const std::uint32_t count = is_xyz_ ? std::min(width_, 3u) : width_;
            for (std::uint32_t k = 0; k < count; ++k) columns.push_back(k);
        }
        if (columns.size() < width_) {
            sink_.warn("Took columns " + counted(columns) + " of " + std::to_string(width_) + " as coordinates" +
                       (by_name ? ", by their names." : "." + all_columns()));
        } else if (width_ > 3) {
            sink_.warn_of_dimension(width_);
        }
        return sink_.choose(width_, columns);
    }

    /// From 1, as --columns takes them.
    static std::string counted(std::vector<std::uint32_t> columns) {
        for (std::uint32_t& column : columns) ++column;
        return joined(columns, ",");
    }

    /// A file of four or five numbers a point may as well be one of points in R^4 or R^5.
    std::string all_columns() const {
        if (width_ > 5) return "";
        std::vector<std::uint32_t> all;
        for (std::uint32_t k = 0; k < width_; ++k) {
            if (parse_field(fields_[k]).kind != FieldKind::Number) return "";
            all.push_back(k);
        }
        return " Take points of R^" + std::to_string(width_) + " with --columns " + counted(all) + ".";
    }

    LineScanner lines_;
    bool is_xyz_;
    RowSink& sink_;
    std::vector<std::string_view> fields_;
    std::vector<std::string> names_;  ///< lower case, of a header or a comment with x and y; empty if there is none
    bool has_header_ = false;
    std::uint32_t width_ = 0;  ///< columns; 0 before the first row
    std::uint64_t first_row_line_ = 0;
};

}  // namespace

std::unique_ptr<FormatReader> make_table_reader(std::string_view bytes, std::string_view extension, RowSink& sink) {
    return std::make_unique<TableReader>(bytes, extension, sink);
}

}  // namespace plateau
