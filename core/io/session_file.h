#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "io/format_reader.h"
#include "io/matrix_sink.h"
#include "io/row_sink.h"
#include "io/saved_run.h"

namespace plateau {

/// A session file, ending .plateau, holds a cloud bit for bit and what to do with it. Its header is text, a line an
/// entry, the numbers behind it are little endian:
///
///     plateau session 1
///     option family auto                the options of saved_options()
///     reached 3000 0123456789abcdef     complete steps and their hash
///     shown 312                         the step that was looked at
///     points 3000 3 double              n, d, precision; or: distances 400 double
///     view 57                           bytes of what the page keeps for itself
///     data
///
/// then the view, then n rows of d coordinates, or n (n - 1) / 2 distances from below the diagonal, row by row.
/// Precision is single where that keeps every bit. There is no compression: full doubles give it nothing to hold on to.
inline constexpr std::string_view kSessionMark = "plateau session ";

/// Whether the bytes begin as a session file of whatever version.
bool begins_as_session(std::string_view bytes);

/// What the header says.
struct SessionHeader {
    SavedRun saved;
    bool has_distances = false;
    std::uint64_t count = 0;      ///< n
    std::uint64_t dimension = 0;  ///< d; 0 for distances
    bool single_precision = false;
    std::size_t data_at = 0;  ///< place of the first number in the file
};

/// Errors: UnknownFormat for another version, MalformedInput with the line. The view lies within the bytes.
Result<SessionHeader> parse_session_header(std::string_view bytes);

/// Reads the numbers into one of the sinks, as the header says which. Precondition: the header is that of the bytes.
std::unique_ptr<FormatReader> make_session_reader(std::string_view bytes, const SessionHeader& header, RowSink& points,
                                                  MatrixSink& distances);

/// The bytes of a session file.
std::string session_bytes(const PointCloud& cloud, const SavedRun& saved);

}  // namespace plateau
