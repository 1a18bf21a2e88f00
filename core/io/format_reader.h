#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include "base/result.h"
#include "io/row_sink.h"

namespace plateau {

/// Whether a reader has work left.
enum class ReadStatus : std::uint8_t { More, Done };

/// One format's reader: walks the bytes and fills a RowSink. Bytes and sink outlive it.
class FormatReader {
public:
    virtual ~FormatReader() = default;
    /// Reads on for at most `rows` lines or rows (more only where many can be skipped at once). Not to be called again
    /// after Done or an error.
    virtual Result<ReadStatus> advance(std::uint32_t rows) = 0;
};

/// Numbers in columns, separated by blanks, tabs, commas or semicolons; comments and one line of names are skipped.
/// `extension`: lower case, without the point.
std::unique_ptr<FormatReader> make_table_reader(std::string_view bytes, std::string_view extension, RowSink& sink);
/// Stanford polygon format 1.0: ascii, binary little and big endian.
std::unique_ptr<FormatReader> make_ply_reader(std::string_view bytes, RowSink& sink);
/// Object file format, also with normals, colors and texture coordinates; ascii.
std::unique_ptr<FormatReader> make_off_reader(std::string_view bytes, RowSink& sink);
/// Wavefront object: the lines of vertices.
std::unique_ptr<FormatReader> make_obj_reader(std::string_view bytes, RowSink& sink);
/// Point Cloud Library, versions 0.5 to 0.7: ascii, binary, binary_compressed; points without coordinates (NaN) are
/// left out, with a warning that counts them.
std::unique_ptr<FormatReader> make_pcd_reader(std::string_view bytes, RowSink& sink);
/// NumPy array, versions 1 to 3, of one point a row: integers and floats of both byte orders, by rows or by columns.
std::unique_ptr<FormatReader> make_npy_reader(std::string_view bytes, RowSink& sink);

}  // namespace plateau
