#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "cloud/point_cloud.h"

namespace plateau {

struct ReadOptions {
    /// 1-based columns that are the coordinates, in this order: two or three, no two alike. Empty: the reader decides.
    /// Columns of a table are its fields, of a PLY file the single-valued vertex properties,
    /// of a PCD file the values of a point, of a NumPy array those of a row, else the coordinates.
    std::vector<std::uint32_t> columns;
};

struct ReadCloud {
    PointCloud cloud;                   ///< two or three finite coordinates a point, not all points equal
    std::vector<std::string> warnings;  ///< sentences for a person, e.g. which columns were taken
    std::uint32_t columns_in_file = 0;
};

/// Reads the bytes of a point file in slices: tables (.xyz .txt .csv), .ply (ascii and binary), .off, .obj (vertices),
/// .pcd (ascii, binary and compressed) and .npy (two-dimensional arrays of real numbers). PLY, OFF, PCD and NumPy files
/// are told by how they begin, the others by the name's ending or, without one that is known, by content. The same
/// bytes give the same cloud on every machine.
///
/// Errors name the line: EmptyInput, TooFewPoints (one point, or all equal), NotANumber, RaggedRows, MalformedInput,
/// UnknownFormat (a file of another kind, which the sentence names), UnsupportedDimension (more than three columns and
/// nothing says which), InvalidOption (columns).
class CloudReader {
public:
    /// `file_name`: only its ending counts; "-" or empty for a stream.
    CloudReader(std::string bytes, std::string_view file_name, ReadOptions options);
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
