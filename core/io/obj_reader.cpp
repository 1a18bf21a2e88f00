#include <array>
#include <optional>
#include <string>
#include <vector>

#include "io/format_reader.h"
#include "io/text.h"

namespace plateau {
namespace {

constexpr std::array<std::uint32_t, 3> kFirstThree = {0, 1, 2};

/// Own reader rather than tinyobjloader, which keeps the whole mesh in memory and cannot be sliced; only the lines of
/// vertices count here.
class ObjReader : public FormatReader {
public:
    ObjReader(std::string_view bytes, RowSink& sink) : lines_(bytes), sink_(sink) {}

    Result<ReadStatus> advance(std::uint32_t rows) override {
        for (std::uint32_t k = 0; k < rows; ++k) {
            const auto line = lines_.next();
            if (!line) return ReadStatus::Done;
            if (auto error = read_line(trimmed(*line))) return std::move(*error);
        }
        return ReadStatus::More;
    }

private:
    std::optional<Error> read_line(std::string_view line) {
        if (!line.starts_with("v ") && !line.starts_with("v\t")) return std::nullopt;
        split_at_blanks(line.substr(1, line.find('#') - 1), fields_);
        if (fields_.size() < 3) {
            return Error{ErrorCode::RaggedRows,
                         "Line " + std::to_string(lines_.line_number()) + " has fewer than three coordinates."};
        }
        if (sink_.columns().empty()) {
            if (auto error = sink_.choose(static_cast<std::uint32_t>(fields_.size()), kFirstThree)) return error;
        }
        return sink_.add_fields(fields_, lines_.line_number());
    }

    LineScanner lines_;
    RowSink& sink_;
    std::vector<std::string_view> fields_;
};

}  // namespace

std::unique_ptr<FormatReader> make_obj_reader(std::string_view bytes, RowSink& sink) {
    return std::make_unique<ObjReader>(bytes, sink);
}

}  // namespace plateau
