#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/random.h"
#include "base/result.h"
#include "cloud/distance_matrix.h"
#include "io/cloud_reader.h"
#include "io/format_reader.h"

namespace plateau {

/// Where an entry of a matrix stands in its file, all 1-based; line 0: the file has no lines.
struct EntryPlace {
    std::uint64_t row = 0;
    std::uint64_t column = 0;
    std::uint64_t line = 0;
};

/// Where the readers of distance matrices put their entries: checks them and keeps those below the diagonal.
class MatrixSink {
public:
    /// `file_bytes`: held while the matrix is read.
    MatrixSink(std::uint64_t memory_limit, std::uint64_t file_bytes)
        : memory_limit_(memory_limit), file_bytes_(file_bytes) {}

    /// No columns can be named; to be called before anything else.
    static std::optional<Error> check_options(const ReadOptions& options);

    /// Room for the distances between n witnesses, all 0 at first. Error: OutOfMemory, before anything is taken.
    std::optional<Error> begin(std::uint64_t n, bool single_precision);
    /// An entry of a square matrix, 0-based; rows come in their order. What is above the diagonal waits for its mirror
    /// image.
    std::optional<Error> set_square(std::uint32_t row, std::uint32_t column, double value, const EntryPlace& place);
    /// A distance that comes once. Precondition: a != b.
    std::optional<Error> set_once(std::uint32_t a, std::uint32_t b, double value, const EntryPlace& place);
    /// The distance of a witness to itself.
    std::optional<Error> check_diagonal(double value, const EntryPlace& place) const;
    void warn(std::string sentence) { warnings_.push_back(std::move(sentence)); }

    /// Holds some more triples against the triangle inequality; Done when it has seen enough of them.
    ReadStatus check_triangles(std::uint32_t triples);

    /// What was collected, or why it is no matrix of distances.
    Result<ReadCloud> finished();

private:
    static constexpr std::uint32_t kMostForAllTriples = 300;
    static constexpr std::uint64_t kDrawnTriples = 2'000'000;

    std::optional<Error> check_distance(double value, const EntryPlace& place) const;
    void set_entry(std::size_t place, double value);
    bool draws_triples() const { return matrix_.size > kMostForAllTriples; }
    std::uint64_t triples_to_see() const;
    void go_to_next_triple();
    void check_triple();

    std::uint64_t memory_limit_;
    std::uint64_t file_bytes_;
    DistanceMatrix matrix_;
    std::vector<std::string> warnings_;
    std::uint64_t rounded_ = 0;  // pairs of mirror images that differ by rounding
    EntryPlace first_rounded_;

    Random random_{1};
    std::array<std::uint32_t, 3> triple_{0, 1, 2};  // that is next
    std::uint64_t triples_seen_ = 0;
    std::uint64_t triples_failing_ = 0;
    std::string first_failing_;
};

/// "Line 8, row 7, column 3", or without the line.
std::string text_of(const EntryPlace& place);

/// Numbers in rows, separated as in a table of points.
std::unique_ptr<FormatReader> make_matrix_table_reader(std::string_view bytes, MatrixSink& sink);
/// NumPy array of two dimensions, or of one as SciPy condenses a matrix.
std::unique_ptr<FormatReader> make_matrix_npy_reader(std::string_view bytes, MatrixSink& sink);

}  // namespace plateau
