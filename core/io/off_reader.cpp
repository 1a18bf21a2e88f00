#include <array>
#include <optional>
#include <string>
#include <vector>

#include "io/file_kind.h"
#include "io/format_reader.h"
#include "io/text.h"

namespace plateau {
namespace {

constexpr std::array<std::uint32_t, 3> kFirstThree = {0, 1, 2};

class OffReader : public FormatReader {
public:
    OffReader(std::string_view bytes, RowSink& sink) : lines_(bytes), sink_(sink) {}

    Result<ReadStatus> advance(std::uint32_t rows) override {
        for (std::uint32_t k = 0; k < rows; ++k) {
            if (has_counts_ && vertices_read_ == vertex_count_) return ReadStatus::Done;
            const auto line = lines_.next();
            if (!line) return file_ends_early();
            const std::string_view content = trimmed(line->substr(0, line->find('#')));
            if (content.empty()) continue;
            if (auto error = read_content(content)) return std::move(*error);
        }
        return ReadStatus::More;
    }

private:
    std::optional<Error> read_content(std::string_view content) {
        if (has_counts_) return read_vertex(content);
        if (has_keyword_) return read_counts(content);
        const std::size_t length = off_keyword_length(content);
        const std::string_view keyword = content.substr(0, length);
        if (length == 0) return malformed("should begin with the word OFF");
        if (keyword.find('4') != std::string_view::npos || keyword.find('n') != std::string_view::npos) {
            return Error{ErrorCode::UnsupportedDimension, "An OFF file of points in more than three dimensions (" +
                                                              in_quotes(keyword) + ") is not read."};
        }
        has_keyword_ = true;
        const std::string_view rest = trimmed(content.substr(length));
        if (rest.starts_with("BINARY")) {
            return Error{ErrorCode::UnknownFormat, "Binary OFF is not read; save it as ascii OFF or as PLY."};
        }
        return rest.empty() ? std::nullopt : read_counts(rest);
    }

    std::optional<Error> read_counts(std::string_view content) {
        split_at_blanks(content, fields_);
        const auto count = parse_count(fields_[0]);
        if (!count) return malformed("should hold the numbers of vertices, faces and edges");
        vertex_count_ = *count;
        has_counts_ = true;
        return std::nullopt;
    }

    std::optional<Error> read_vertex(std::string_view content) {
        split_at_blanks(content, fields_);
        if (fields_.size() < 3) {
            return Error{ErrorCode::RaggedRows,
                         "Line " + std::to_string(lines_.line_number()) + " has fewer than three coordinates."};
        }
        if (vertices_read_ == 0) {
            if (auto error = sink_.choose(static_cast<std::uint32_t>(fields_.size()), kFirstThree)) return error;
        }
        ++vertices_read_;
        return sink_.add_fields(fields_, lines_.line_number());
    }

    Error malformed(const char* what) const {
        return {ErrorCode::MalformedInput, "Line " + std::to_string(lines_.line_number()) + " " + what + "."};
    }

    Error file_ends_early() const {
        if (!has_counts_) return {ErrorCode::MalformedInput, "The file ends before the number of vertices."};
        return {ErrorCode::MalformedInput, "The header promises " + std::to_string(vertex_count_) +
                                               " vertices, but the file ends after " + std::to_string(vertices_read_) +
                                               "."};
    }

    LineScanner lines_;
    RowSink& sink_;
    std::vector<std::string_view> fields_;
    bool has_keyword_ = false;
    bool has_counts_ = false;
    std::uint64_t vertex_count_ = 0;
    std::uint64_t vertices_read_ = 0;
};

}  // namespace

std::unique_ptr<FormatReader> make_off_reader(std::string_view bytes, RowSink& sink) {
    return std::make_unique<OffReader>(bytes, sink);
}

}  // namespace plateau
