#include "io/matrix_sink.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/words.h"

namespace plateau {

namespace {

/// Relative to the larger one: what differs by less differs by rounding, in single precision at the worst.
constexpr double kRounding = 1e-6;

Error malformed(std::string sentence) {
    return {ErrorCode::MalformedInput, std::move(sentence)};
}

}  // namespace

std::string text_of(const EntryPlace& place) {
    const std::string entry = "row " + std::to_string(place.row) + ", column " + std::to_string(place.column);
    if (place.line == 0) return "R" + entry.substr(1);
    return "Line " + std::to_string(place.line) + ", " + entry;
}

std::optional<Error> MatrixSink::check_options(const ReadOptions& options) {
    if (options.columns.empty()) return std::nullopt;
    return Error{ErrorCode::InvalidOption, "A distance matrix has no columns to choose from: every one counts."};
}

std::optional<Error> MatrixSink::begin(std::uint64_t n, bool single_precision) {
    const std::string sizes = grouped(n) + " x " + grouped(n);
    // Beyond this even the number of bytes overflows.
    constexpr std::uint64_t kMostWitnesses = std::numeric_limits<std::uint32_t>::max() - 1;
    if (n > kMostWitnesses) return Error{ErrorCode::OutOfMemory, sizes + " distances are more than fits."};
    const std::uint64_t count = DistanceMatrix::entry_count(n);
    const std::uint64_t bytes = count * (single_precision ? sizeof(float) : sizeof(double));
    if (bytes > memory_limit_ || bytes + file_bytes_ > memory_limit_) {
        return Error{ErrorCode::OutOfMemory, sizes + " distances and their file need " +
                                                 in_megabytes(bytes + file_bytes_) + ", but only " +
                                                 in_megabytes(memory_limit_) + " may be used: take fewer points" +
                                                 (single_precision ? "." : ", or a .npy array of single precision.")};
    }
    matrix_.size = static_cast<std::uint32_t>(n);
    if (single_precision) {
        matrix_.narrow.resize(static_cast<std::size_t>(count));
    } else {
        matrix_.entries.resize(static_cast<std::size_t>(count));
    }
    return std::nullopt;
}

std::optional<Error> MatrixSink::check_distance(double value, const EntryPlace& place) const {
    if (value >= 0 && value <= kMaxCoordinate) return std::nullopt;
    if (!std::isfinite(value)) {
        return Error{ErrorCode::NotANumber, text_of(place) + ": the distance is not a finite number."};
    }
    if (value < 0) return malformed(text_of(place) + ": the distance is negative, " + short_number(value) + ".");
    return Error{ErrorCode::NotANumber, text_of(place) + ": the distance is beyond 1e150; scale the matrix down."};
}

std::optional<Error> MatrixSink::check_diagonal(double value, const EntryPlace& place) const {
    if (auto error = check_distance(value, place)) return error;
    if (value == 0) return std::nullopt;
    return malformed(text_of(place) + ": the distance of a point to itself must be 0; got " + short_number(value) +
                     ".");
}

void MatrixSink::set_entry(std::size_t place, double value) {
    // A zero without its sign: bits count where runs are compared.
    if (matrix_.narrow.empty()) {
        matrix_.entries[place] = value + 0.0;
    } else {
        matrix_.narrow[place] = static_cast<float>(value + 0.0);
    }
}

std::optional<Error> MatrixSink::set_once(std::uint32_t a, std::uint32_t b, double value, const EntryPlace& place) {
    if (auto error = check_distance(value, place)) return error;
    set_entry(a > b ? DistanceMatrix::place(a, b) : DistanceMatrix::place(b, a), value);
    return std::nullopt;
}

std::optional<Error> MatrixSink::set_square(std::uint32_t row, std::uint32_t column, double value,
                                            const EntryPlace& place) {
    if (row == column) return check_diagonal(value, place);
    if (column > row) return set_once(row, column, value, place);
    if (auto error = check_distance(value, place)) return error;
    const std::size_t at = DistanceMatrix::place(row, column);
    const double mirrored = matrix_.entry(at);
    if (value == mirrored) return std::nullopt;
    if (std::abs(value - mirrored) > kRounding * std::max(value, mirrored)) {
        return malformed(text_of(place) + " has " + short_number(value) + ", but row " + std::to_string(column + 1) +
                         ", column " + std::to_string(row + 1) + " has " + short_number(mirrored) +
                         ": the matrix is not symmetric.");
    }
    if (rounded_++ == 0) first_rounded_ = place;
    set_entry(at, value);
    return std::nullopt;
}

std::uint64_t MatrixSink::triples_to_see() const {
    if (draws_triples()) return kDrawnTriples;
    const std::uint64_t n = matrix_.size;
    return n < 3 ? 0 : n * (n - 1) * (n - 2) / 6;
}

void MatrixSink::go_to_next_triple() {
    const std::uint32_t n = matrix_.size;
    auto& [a, b, c] = triple_;
    if (draws_triples()) {
        do {
            for (std::uint32_t& witness : triple_) witness = static_cast<std::uint32_t>(random_.next_bits() % n);
        } while (a == b || b == c || a == c);
        std::sort(triple_.begin(), triple_.end());
    } else if (triples_seen_ == 0) {
        triple_ = {0, 1, 2};
    } else if (++c == n) {
        if (++b == n - 1) b = ++a + 1;
        c = b + 1;
    }
}

void MatrixSink::check_triple() {
    const auto& [a, b, c] = triple_;
    const struct {
        double length;
        std::uint32_t from, by, to;
    } sides[] = {
        {matrix_.distance(a, b), a, c, b}, {matrix_.distance(a, c), a, b, c}, {matrix_.distance(b, c), b, a, c}};
    for (const auto& [length, from, by, to] : sides) {
        const double first = matrix_.distance(from, by);
        const double second = matrix_.distance(by, to);
        if (!(length - (first + second) > kRounding * length)) continue;
        if (triples_failing_++ > 0) return;
        const auto name = [](std::uint32_t witness) { return std::to_string(witness + 1); };
        first_failing_ = "from point " + name(from) + " to point " + name(to) + " it is " + short_number(length) +
                         ", but by way of point " + name(by) + " " + short_number(first) + " + " + short_number(second);
        return;  // no two sides of a triangle can be too long
    }
}

ReadStatus MatrixSink::check_triangles(std::uint32_t triples) {
    const std::uint64_t all = triples_to_see();
    for (std::uint32_t k = 0; k < triples && triples_seen_ < all; ++k) {
        go_to_next_triple();
        check_triple();
        ++triples_seen_;
    }
    return triples_seen_ < all ? ReadStatus::More : ReadStatus::Done;
}

Result<ReadCloud> MatrixSink::finished() {
    const std::uint32_t n = matrix_.size;
    if (n == 0) return Error{ErrorCode::EmptyInput, "The file holds no distances."};
    if (n == 1) {
        return Error{ErrorCode::TooFewPoints, "The file is of one point; a shape needs at least two different ones."};
    }
    const auto is_zero = [](double distance) { return distance == 0; };
    if (std::all_of(matrix_.entries.begin(), matrix_.entries.end(), is_zero) &&
        std::all_of(matrix_.narrow.begin(), matrix_.narrow.end(), is_zero)) {
        return Error{ErrorCode::TooFewPoints, "All distances between the " + std::to_string(n) +
                                                  " points are 0; a shape needs at least two different ones."};
    }
    if (rounded_ > 0) {
        warn(grouped(rounded_) + (rounded_ == 1 ? " distance differs" : " distances differ") +
             " by rounding from the mirror image (" + text_of(first_rounded_) +
             (rounded_ == 1 ? ")" : " is the first)") + "; what is below the diagonal was taken.");
    }
    if (triples_failing_ > 0) {
        warn("The triangle inequality fails in " + grouped(triples_failing_) + " of " + grouped(triples_seen_) +
             (draws_triples() ? " triples that were drawn: " : " triples: ") + first_failing_ +
             (triples_failing_ == 1 ? "." : ", for one.") + " The distances are taken as they are.");
    }
    ReadCloud read;
    read.cloud.distances = std::move(matrix_);
    read.warnings = std::move(warnings_);
    read.columns_in_file = n;
    return read;
}

}  // namespace plateau
