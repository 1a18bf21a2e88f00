#include "io/cloud_reader.h"

#include <chrono>
#include <limits>
#include <optional>

#include "io/file_kind.h"
#include "io/format_reader.h"
#include "io/matrix_sink.h"
#include "io/row_sink.h"
#include "io/session_file.h"
#include "io/text.h"

namespace plateau {
namespace {

std::string extension_of(std::string_view file_name) {
    const std::size_t point = file_name.rfind('.');
    if (point == std::string_view::npos) return {};
    return lower_case(file_name.substr(point + 1));
}

std::unique_ptr<FormatReader> make_reader(std::string_view bytes, std::string_view extension, RowSink& sink) {
    switch (detect_format(bytes, extension)) {
        case FileFormat::Ply:
            return make_ply_reader(bytes, sink);
        case FileFormat::Off:
            return make_off_reader(bytes, sink);
        case FileFormat::Obj:
            return make_obj_reader(bytes, sink);
        case FileFormat::Pcd:
            return make_pcd_reader(bytes, sink);
        case FileFormat::Npy:
            return make_npy_reader(bytes, sink);
        case FileFormat::Table:
            break;
    }
    return make_table_reader(bytes, extension, sink);
}

Result<std::unique_ptr<FormatReader>> make_matrix_reader(std::string_view bytes, std::string_view extension,
                                                         MatrixSink& sink) {
    switch (detect_format(bytes, extension)) {
        case FileFormat::Table:
            return make_matrix_table_reader(bytes, sink);
        case FileFormat::Npy:
            return make_matrix_npy_reader(bytes, sink);
        default:
            return Error{ErrorCode::UnknownFormat,
                         "This file holds points; a distance matrix is read from .csv, .txt and .npy."};
    }
}

}  // namespace

struct CloudReader::State {
    std::string bytes;
    bool reads_distances;
    RowSink points;
    MatrixSink distances;
    std::optional<SavedRun> saved;
    std::unique_ptr<FormatReader> reader;  ///< null when done
    std::optional<Error> error;

    State(std::string all, std::string_view file_name, const ReadOptions& options)
        : bytes(std::move(all)),
          reads_distances(options.as == ReadAs::Distances),
          points(options),
          distances(options.memory_limit, bytes.size()) {
        if (begins_as_session(bytes)) {
            begin_session();
            return;
        }
        error = reads_distances ? MatrixSink::check_options(options) : points.check_options();
        if (error) return;
        std::string_view view = bytes;
        if (view.starts_with("\xEF\xBB\xBF")) view.remove_prefix(3);  // byte order mark
        if (view.find_first_not_of(" \t\r\n") == std::string_view::npos) {
            error = Error{ErrorCode::EmptyInput, "The file is empty."};
        } else if (const auto kind = foreign_kind(view)) {
            error = Error{ErrorCode::UnknownFormat,
                          "This seems to be " + std::string(*kind) +
                              ". Points are read from .xyz, .txt, .csv, .ply, .off, .obj, .pcd and .npy."};
        } else if (reads_distances) {
            auto made = make_matrix_reader(view, extension_of(file_name), distances);
            if (made) {
                reader = std::move(made).value();
            } else {
                error = made.error();
            }
        } else {
            reader = make_reader(view, extension_of(file_name), points);
        }
    }

    void begin_session() {
        auto header = parse_session_header(bytes);
        if (!header) {
            error = header.error();
            return;
        }
        reads_distances = header.value().has_distances;
        reader = make_session_reader(bytes, header.value(), points, distances);
        saved = std::move(header.value().saved);
    }
};

CloudReader::CloudReader(std::string bytes, std::string_view file_name, const ReadOptions& options)
    : state_(std::make_unique<State>(std::move(bytes), file_name, options)) {}
CloudReader::CloudReader(CloudReader&&) noexcept = default;
CloudReader& CloudReader::operator=(CloudReader&&) noexcept = default;
CloudReader::~CloudReader() = default;

bool CloudReader::advance(double budget_ms) {
    constexpr std::uint32_t kRowsAtOnce = 256;
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    while (state_->reader) {
        const auto status = state_->reader->advance(kRowsAtOnce);
        if (!status) state_->error = status.error();
        if (!status || status.value() == ReadStatus::Done) state_->reader.reset();
        if (std::chrono::duration<double, std::milli>(Clock::now() - start).count() >= budget_ms) break;
    }
    return state_->reader == nullptr;
}

Result<ReadCloud> CloudReader::take() {
    advance(std::numeric_limits<double>::infinity());
    state_->bytes = {};
    if (state_->error) return *state_->error;
    auto read = state_->reads_distances ? state_->distances.finished() : state_->points.finished();
    if (read) read.value().saved = std::move(state_->saved);
    return read;
}

Result<ReadCloud> read_cloud(std::string bytes, std::string_view file_name, const ReadOptions& options) {
    return CloudReader(std::move(bytes), file_name, options).take();
}

}  // namespace plateau
