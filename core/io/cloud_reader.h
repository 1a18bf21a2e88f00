#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "cloud/point_cloud.h"
#include "io/saved_run.h"

namespace plateau {

/// What the rows of a file are.
enum class ReadAs : std::uint8_t {
    Points,                ///< two or three coordinates; a wider table asks which columns are meant
    PointsOfAnyDimension,  ///< a wider table is taken as a whole
    Distances,             ///< a distance matrix
};

struct ReadOptions {
    /// 1-based columns that are the coordinates, in this order: two or three (or more, see ReadAs), no two alike; none
    /// for distances. Empty: the reader decides.
    /// Columns of a table are its fields, of a PLY file the single-valued vertex properties,
    /// of a PCD file the values of a point, of a NumPy array those of a row, else the coordinates.
    std::vector<std::uint32_t> columns;
    ReadAs as = ReadAs::Points;
    std::uint64_t memory_limit = std::uint64_t{3} << 30;  ///< bytes that a matrix and its file may take together
};

struct ReadCloud {
    PointCloud cloud;                   ///< finite coordinates, not all points equal; or distances, not all 0
    std::vector<std::string> warnings;  ///< sentences for a person, e.g. which columns were taken
    std::uint32_t columns_in_file = 0;
    std::optional<SavedRun> saved;  ///< of a session file
};

/// Reads the bytes of a point file in slices: tables (.xyz .txt .csv), .ply (ascii and binary), .off, .obj (vertices),
/// .pcd (ascii, binary and compressed) and .npy (two-dimensional arrays of real numbers). PLY, OFF, PCD and NumPy files
/// are told by how they begin, the others by the name's ending or, without one that is known, by content. The same
/// bytes give the same cloud on every machine.
///
/// A distance matrix is a table or a .npy array: square, or what is below its diagonal (with or without the diagonal),
/// a row a line; a one-dimensional array is what is above the diagonal, row by row, as SciPy condenses it. Labels in
/// the first row and column are skipped. Entries that differ from their mirror image by rounding alone are taken from
/// below the diagonal, with a warning. Of up to 300 points all triples are held against the triangle inequality, of
/// more two million that are drawn, the same ones every time; a failing one is named in a warning.
///
/// A session file (io/session_file.h), told by how it begins, says by itself what its numbers are; columns cannot be
/// named and the triangle inequality was looked at when they were read first.
///
/// Errors name the line: EmptyInput, TooFewPoints (one point, or all equal), NotANumber, RaggedRows, MalformedInput,
/// UnknownFormat (a file of another kind, which the sentence names), UnsupportedDimension (more than three columns and
/// nothing says which), InvalidOption (columns), OutOfMemory (a matrix that will not fit, with what it takes). A matrix
/// that is not square is RaggedRows, a negative entry, one without a mirror image or a distance to itself that is not 0
/// is MalformedInput; the sentence names row and column.
class CloudReader {
public:
    /// `file_name`: only its ending counts; "-" or empty for a stream.
    CloudReader(std::string bytes, std::string_view file_name, const ReadOptions& options);
    CloudReader(CloudReader&&) noexcept;
    CloudReader& operator=(CloudReader&&) noexcept;
    ~CloudReader();

    /// Reads until the budget is spent, at least a few rows. True when there is nothing left to do, also after an
    /// error.
    bool advance(double budget_ms);

    /// The cloud or the error; reads what is left. To be called once; the bytes are released.
    Result<ReadCloud> take();

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// All at once.
Result<ReadCloud> read_cloud(std::string bytes, std::string_view file_name, const ReadOptions& options);

}  // namespace plateau
