#include <array>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/format_reader.h"
#include "io/npy_header.h"

namespace plateau {
namespace {

std::string shape_text(const std::vector<std::uint64_t>& shape) {
    constexpr std::size_t kMostShown = 4;
    std::string text = "(";
    for (std::size_t k = 0; k < shape.size() && k < kMostShown; ++k) {
        text += (k > 0 ? ", " : "") + std::to_string(shape[k]);
    }
    if (shape.size() > kMostShown) return text + ", ...)";
    return text + (shape.size() == 1 ? ",)" : ")");
}

class NpyReader : public FormatReader {
public:
    NpyReader(std::string_view bytes, RowSink& sink) : bytes_(bytes), sink_(sink) {}

    Result<ReadStatus> advance(std::uint32_t rows) override {
        if (!has_header_) {
            if (auto error = read_header()) return std::move(*error);
            return ReadStatus::More;
        }
        for (std::uint32_t k = 0; k < rows; ++k) {
            if (row_ == row_count()) return ReadStatus::Done;
            if (auto error = read_row()) return std::move(*error);
        }
        return ReadStatus::More;
    }

private:
    std::uint64_t row_count() const { return header_.shape[0]; }
    std::uint64_t column_count() const { return header_.shape[1]; }

    std::optional<Error> read_header() {
        auto header = parse_npy_header(bytes_);
        if (!header) return header.error();
        header_ = std::move(header).value();
        has_header_ = true;
        if (auto error = choose_columns()) return error;
        data_ = bytes_.substr(header_.size);
        // Division, because the product of what a header says can overflow.
        const std::uint64_t values = data_.size() / byte_size(header_.type);
        if (values / column_count() < row_count()) {
            return Error{ErrorCode::MalformedInput, "The header of this NumPy file promises " +
                                                        shape_text(header_.shape) + " values, but only " +
                                                        std::to_string(values) + " are there."};
        }
        if (data_.size() > row_count() * column_count() * byte_size(header_.type)) {
            sink_.warn("Took the first array of this NumPy file; what follows it was left out.");
        }
        sink_.reserve(row_count());
        return std::nullopt;
    }

    std::optional<Error> choose_columns() {
        if (header_.shape.size() != 2) {
            return Error{ErrorCode::MalformedInput, "This NumPy array has shape " + shape_text(header_.shape) +
                                                        "; points are rows of an array of shape (n, 2) or (n, 3)."};
        }
        constexpr std::uint64_t kMaxColumns = std::numeric_limits<std::uint32_t>::max();
        if (column_count() < 2 || column_count() > kMaxColumns) {
            return Error{ErrorCode::MalformedInput, "This NumPy array has shape " + shape_text(header_.shape) +
                                                        "; points need two or three columns."};
        }
        const auto columns = static_cast<std::uint32_t>(column_count());
        if (columns > 3 && !sink_.columns_asked() && sink_.takes_any_dimension()) {
            std::vector<std::uint32_t> all(columns);
            std::iota(all.begin(), all.end(), 0u);
            sink_.warn_of_dimension(columns);
            return sink_.choose(columns, all);
        }
        if (columns > 3 && !sink_.columns_asked()) {
            return Error{ErrorCode::UnsupportedDimension,
                         std::to_string(columns) + " columns: choose the coordinates with --columns 1,2,3"};
        }
        constexpr std::array<std::uint32_t, 3> kFirst = {0, 1, 2};
        return sink_.choose(columns, std::span(kFirst).first(columns > 2 ? 3 : 2));
    }

    std::optional<Error> read_row() {
        const std::span<double> point = sink_.point();
        const auto columns = sink_.columns();
        for (std::size_t axis = 0; axis < columns.size(); ++axis) {
            const std::uint64_t place =
                header_.by_columns ? columns[axis] * row_count() + row_ : row_ * column_count() + columns[axis];
            const auto at = static_cast<std::size_t>(place * byte_size(header_.type));
            point[axis] = decode_number(data_.data() + at, header_.type, header_.order);
        }
        ++row_;
        return sink_.add_point(point, "Row", row_);
    }

    std::string_view bytes_;
    RowSink& sink_;
    bool has_header_ = false;
    NpyHeader header_;
    std::string_view data_;  ///< the values
    std::uint64_t row_ = 0;  ///< rows that were read
};

}  // namespace

std::unique_ptr<FormatReader> make_npy_reader(std::string_view bytes, RowSink& sink) {
    return std::make_unique<NpyReader>(bytes, sink);
}

}  // namespace plateau
