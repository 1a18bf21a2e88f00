#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/format_reader.h"
#include "io/lzf.h"
#include "io/pcd_header.h"
#include "io/text.h"

namespace plateau {
namespace {

/// Where the values of a column lie in binary data.
struct Column {
    std::uint64_t start = 0;
    std::uint64_t stride = 0;
    NumberType type = NumberType::Float32;
};

class PcdReader : public FormatReader {
public:
    PcdReader(std::string_view bytes, RowSink& sink) : bytes_(bytes), sink_(sink), lines_(std::string_view{}) {}

    Result<ReadStatus> advance(std::uint32_t rows) override {
        if (!has_header_) {
            if (auto error = read_header()) return std::move(*error);
            return ReadStatus::More;
        }
        if (decoder_ && !is_expanded_) {
            if (auto error = expand()) return std::move(*error);
            return ReadStatus::More;
        }
        for (std::uint32_t k = 0; k < rows; ++k) {
            if (row_ == header_.points) return finish();
            auto error = header_.encoding == PcdEncoding::Ascii ? read_line() : read_row();
            if (error) return std::move(*error);
        }
        return ReadStatus::More;
    }

private:
    std::optional<Error> read_header() {
        auto header = parse_pcd_header(bytes_);
        if (!header) return header.error();
        header_ = std::move(header).value();
        has_header_ = true;
        if (auto error = choose_columns()) return error;
        const std::string_view rest = bytes_.substr(header_.size);
        switch (header_.encoding) {
            case PcdEncoding::Ascii:
                lines_ = LineScanner(rest);
                return std::nullopt;
            case PcdEncoding::Binary:
                return place_rows(rest);
            case PcdEncoding::Compressed:
                break;
        }
        return start_expanding(rest);
    }

    /// Columns are the values of a point; the single-valued fields x, y and, if there is one, z are the coordinates.
    std::optional<Error> choose_columns() {
        std::array<std::optional<std::uint32_t>, 3> axes;
        std::uint32_t column = 0;
        for (const PcdField& field : header_.fields) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const bool named = field.name == std::string_view("xyz").substr(axis, 1);
                if (named && field.count == 1 && !axes[axis]) axes[axis] = column;
            }
            column += field.count;
        }
        if (!sink_.columns_asked() && (!axes[0] || !axes[1])) {
            return Error{ErrorCode::MalformedInput, "The points of this PCD file have no fields x and y."};
        }
        std::vector<std::uint32_t> suggested;
        for (const auto& axis : axes) {
            if (axis) suggested.push_back(*axis);
        }
        return sink_.choose(column, suggested);
    }

    /// Binary: points one after the other, each with all of its values.
    std::optional<Error> place_rows(std::string_view rest) {
        const std::uint64_t row_size = header_.row_size();
        if (rest.size() / row_size < header_.points) return file_ends_early(rest.size() / row_size);
        std::uint64_t offset = 0;
        for (const PcdField& field : header_.fields) {
            for (std::uint32_t k = 0; k < field.count; ++k) {
                columns_.push_back({offset, row_size, field.type});
                offset += byte_size(field.type);
            }
        }
        data_ = rest;
        sink_.reserve(header_.points);
        const auto used = static_cast<std::size_t>(header_.points * row_size);
        has_more_ = !trimmed(rest.substr(used)).empty();
        return std::nullopt;
    }

    /// Compressed: two sizes, then fields one after the other, each with the values of all points.
    std::optional<Error> start_expanding(std::string_view rest) {
        constexpr std::size_t kSizes = 8;
        if (rest.size() < kSizes) return file_ends_early(0);
        const auto size_at = [&](std::size_t at) {
            return static_cast<std::uint64_t>(
                decode_number(rest.data() + at, NumberType::Uint32, ByteOrder::LittleEndian));
        };
        const std::uint64_t compressed = size_at(0);
        const std::uint64_t expanded = size_at(4);
        rest.remove_prefix(kSizes);
        if (rest.size() < compressed) {
            return Error{ErrorCode::MalformedInput, "The compressed data of this PCD file should take " +
                                                        std::to_string(compressed) + " bytes, but only " +
                                                        std::to_string(rest.size()) + " are there."};
        }
        const std::uint64_t row_size = header_.row_size();
        if (expanded % row_size != 0 || expanded / row_size != header_.points) {
            return Error{ErrorCode::MalformedInput, "The compressed data of this PCD file hold " +
                                                        std::to_string(expanded) +
                                                        " bytes, which is not what its header says of " +
                                                        std::to_string(header_.points) + " points."};
        }
        // Checked before memory is asked for: a short file cannot ask for much.
        if (expanded / kMaxLzfExpansion > compressed) return broken();
        const auto length = static_cast<std::size_t>(compressed);
        decoder_.emplace(rest.substr(0, length), static_cast<std::size_t>(expanded));
        has_more_ = !trimmed(rest.substr(length)).empty();
        std::uint64_t offset = 0;
        for (const PcdField& field : header_.fields) {
            const std::uint64_t stride = std::uint64_t{byte_size(field.type)} * field.count;
            for (std::uint32_t k = 0; k < field.count; ++k) {
                columns_.push_back({offset + std::uint64_t{byte_size(field.type)} * k, stride, field.type});
            }
            offset += stride * header_.points;
        }
        return std::nullopt;
    }

    std::optional<Error> expand() {
        constexpr std::size_t kBytesAtOnce = 65536;
        switch (decoder_->advance(kBytesAtOnce)) {
            case LzfDecoder::Status::More:
                return std::nullopt;
            case LzfDecoder::Status::Broken:
                return broken();
            case LzfDecoder::Status::Done:
                break;
        }
        is_expanded_ = true;
        data_ = decoder_->output();
        sink_.reserve(header_.points);
        return std::nullopt;
    }

    /// One point of an ascii file, or nothing if the line is empty.
    std::optional<Error> read_line() {
        const auto line = lines_.next();
        if (!line) return file_ends_early(row_);
        split_at_blanks(*line, fields_);
        if (fields_.empty()) return std::nullopt;
        ++row_;
        const std::uint64_t number = header_.lines + lines_.line_number();
        if (fields_.size() != header_.columns()) {
            return Error{ErrorCode::RaggedRows, "Line " + std::to_string(number) + " has " +
                                                    std::to_string(fields_.size()) +
                                                    " numbers, which is not what the PCD header says of a point."};
        }
        const auto columns = sink_.columns();
        if (std::any_of(columns.begin(), columns.end(),
                        [&](std::uint32_t column) { return is_nan(fields_[column]); })) {
            ++missing_;
            return std::nullopt;
        }
        return sink_.add_fields(fields_, number);
    }

    std::optional<Error> read_row() {
        const std::span<double> point = sink_.point();
        const auto columns = sink_.columns();
        bool is_missing = false;
        for (std::size_t axis = 0; axis < columns.size(); ++axis) {
            const Column& column = columns_[columns[axis]];
            const auto at = static_cast<std::size_t>(column.start + row_ * column.stride);
            point[axis] = decode_number(data_.data() + at, column.type, ByteOrder::LittleEndian);
            is_missing = is_missing || std::isnan(point[axis]);
        }
        ++row_;
        if (!is_missing) return sink_.add_point(point, "Point", row_);
        ++missing_;
        return std::nullopt;
    }

    Result<ReadStatus> finish() {
        if (missing_ > 0 && missing_ == header_.points) {
            return Error{ErrorCode::EmptyInput,
                         "None of the " + std::to_string(missing_) + " points of this PCD file has coordinates."};
        }
        if (missing_ > 0) {
            sink_.warn("Left out " + std::to_string(missing_) + " of " + std::to_string(header_.points) +
                       " points, which have no coordinates (NaN).");
        }
        if (header_.encoding == PcdEncoding::Ascii) {
            has_more_ = !trimmed(bytes_.substr(header_.size + lines_.position())).empty();
        }
        if (has_more_) {
            sink_.warn("The PCD header promises " + std::to_string(header_.points) +
                       " points; what follows them was left out.");
        }
        return ReadStatus::Done;
    }

    Error file_ends_early(std::uint64_t points) const {
        return {ErrorCode::MalformedInput, "The PCD header promises " + std::to_string(header_.points) +
                                               " points, but the file ends after " + std::to_string(points) + "."};
    }

    static Error broken() { return {ErrorCode::MalformedInput, "The compressed data of this PCD file are damaged."}; }

    std::string_view bytes_;
    RowSink& sink_;
    bool has_header_ = false;
    PcdHeader header_;
    std::uint64_t row_ = 0;      ///< points that were read
    std::uint64_t missing_ = 0;  ///< of them without coordinates
    bool has_more_ = false;      ///< something follows the last point
    LineScanner lines_;          ///< ascii: the lines behind the header
    std::vector<std::string_view> fields_;
    std::optional<LzfDecoder> decoder_;  ///< compressed only
    bool is_expanded_ = false;
    std::string_view data_;        ///< binary: what columns_ lead into
    std::vector<Column> columns_;  ///< binary: one a value of a point
};

}  // namespace

std::unique_ptr<FormatReader> make_pcd_reader(std::string_view bytes, RowSink& sink) {
    return std::make_unique<PcdReader>(bytes, sink);
}

}  // namespace plateau
