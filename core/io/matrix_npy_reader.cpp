#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "io/matrix_sink.h"
#include "io/npy_header.h"

namespace plateau {
namespace {

Error malformed(std::string sentence) {
    return {ErrorCode::MalformedInput, std::move(sentence)};
}

/// n of n (n - 1) / 2, if there is one.
std::optional<std::uint64_t> witnesses_of(std::uint64_t distances) {
    auto n = static_cast<std::uint64_t>(std::sqrt(2.0 * static_cast<double>(distances)));
    while (n > 1 && (n - 1) > distances / (n - 1)) --n;
    while (n * (n - 1) / 2 < distances) ++n;
    if (n * (n - 1) / 2 != distances) return std::nullopt;
    return n;
}

class MatrixNpyReader : public FormatReader {
public:
    MatrixNpyReader(std::string_view bytes, MatrixSink& sink) : bytes_(bytes), sink_(sink) {}

    Result<ReadStatus> advance(std::uint32_t rows) override {
        constexpr std::uint32_t kNumbersARow = 64;
        constexpr std::uint32_t kTriplesARow = 64;
        if (!has_header_) {
            if (auto error = read_header()) return std::move(*error);
            return ReadStatus::More;
        }
        for (std::uint64_t numbers = 0; numbers < std::uint64_t{rows} * kNumbersARow; numbers += 1 + size_) {
            if (row_ == size_) return sink_.check_triangles(rows * kTriplesARow);
            if (auto error = is_condensed_ ? read_condensed_row() : read_square_row()) return std::move(*error);
            ++row_;
        }
        return ReadStatus::More;
    }

private:
    std::optional<Error> read_header() {
        auto header = parse_npy_header(bytes_);
        if (!header) return header.error();
        header_ = std::move(header).value();
        has_header_ = true;
        data_ = bytes_.substr(header_.size);
        const auto& shape = header_.shape;
        std::optional<std::uint64_t> n;
        if (shape.size() == 2 && shape[0] == shape[1]) n = shape[0];
        const std::uint64_t values = data_.size() / byte_size(header_.type);
        is_condensed_ = shape.size() == 1;
        // Before it is multiplied: what a header says can overflow.
        if (is_condensed_ && shape[0] <= values) n = shape[0] == 0 ? 0 : witnesses_of(shape[0]);
        if (shape.size() == 2 && shape[0] != shape[1]) {
            return Error{ErrorCode::RaggedRows, "This NumPy array has " + std::to_string(shape[0]) + " rows and " +
                                                    std::to_string(shape[1]) +
                                                    " columns; a distance matrix is square."};
        }
        if (shape.empty() || shape.size() > 2) {
            return malformed("This NumPy array has " + std::to_string(shape.size()) +
                             " dimensions; a distance matrix has 2, or 1 where it is condensed.");
        }
        const bool cut_off = is_condensed_ ? shape[0] > values : *n > 0 && values / *n < *n;
        if (cut_off) {
            return malformed("The header of this NumPy file promises more values than the " + std::to_string(values) +
                             " that are there.");
        }
        if (!n) {
            return malformed("This NumPy array has " + std::to_string(shape[0]) +
                             " values; a condensed distance matrix of n points has n (n - 1) / 2.");
        }
        if (data_.size() > (is_condensed_ ? shape[0] : *n * *n) * byte_size(header_.type)) {
            sink_.warn("Took the first array of this NumPy file; what follows it was left out.");
        }
        const bool fits_single = byte_size(header_.type) < 4 || header_.type == NumberType::Float32;
        if (auto error = sink_.begin(*n, fits_single)) return error;
        size_ = static_cast<std::uint32_t>(*n);
        return std::nullopt;
    }

    double value(std::uint64_t place) const {
        const auto at = static_cast<std::size_t>(place * byte_size(header_.type));
        return decode_number(data_.data() + at, header_.type, header_.order);
    }

    std::optional<Error> read_square_row() {
        for (std::uint32_t column = 0; column < size_; ++column) {
            const std::uint64_t place =
                header_.by_columns ? std::uint64_t{column} * size_ + row_ : std::uint64_t{row_} * size_ + column;
            if (auto error = sink_.set_square(row_, column, value(place), {row_ + 1ull, column + 1ull})) return error;
        }
        return std::nullopt;
    }

    /// What is above the diagonal, row after row.
    std::optional<Error> read_condensed_row() {
        for (std::uint32_t column = row_ + 1; column < size_; ++column) {
            if (auto error = sink_.set_once(row_, column, value(next_++), {row_ + 1ull, column + 1ull})) return error;
        }
        return std::nullopt;
    }

    std::string_view bytes_;
    MatrixSink& sink_;
    bool has_header_ = false;
    NpyHeader header_;
    std::string_view data_;  ///< the values
    bool is_condensed_ = false;
    std::uint32_t size_ = 0;  ///< witnesses
    std::uint32_t row_ = 0;   ///< rows that were read
    std::uint64_t next_ = 0;  ///< condensed: values that were read
};

}  // namespace

std::unique_ptr<FormatReader> make_matrix_npy_reader(std::string_view bytes, MatrixSink& sink) {
    return std::make_unique<MatrixNpyReader>(bytes, sink);
}

}  // namespace plateau
