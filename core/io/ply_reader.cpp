#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/binary_number.h"
#include "io/format_reader.h"
#include "io/ply_header.h"
#include "io/text.h"

namespace plateau {
namespace {

class PlyReader : public FormatReader {
public:
    PlyReader(std::string_view bytes, RowSink& sink) : bytes_(bytes), sink_(sink), lines_(std::string_view{}) {}

    Result<ReadStatus> advance(std::uint32_t rows) override {
        if (!has_header_) {
            if (auto error = read_header()) return std::move(*error);
            return ReadStatus::More;
        }
        for (std::uint32_t k = 0; k < rows; ++k) {
            const PlyElement& element = header_.elements[element_];
            // A row without properties takes no bytes, whatever their number.
            if (row_ == element.count || element.properties.empty()) {
                if (element_ == vertex_element_) return ReadStatus::Done;
                ++element_;
                row_ = 0;
                continue;
            }
            auto error = header_.encoding == PlyEncoding::Ascii ? read_line() : read_binary_row();
            if (error) return std::move(*error);
        }
        return ReadStatus::More;
    }

private:
    std::optional<Error> read_header() {
        auto header = parse_ply_header(bytes_);
        if (!header) return header.error();
        header_ = std::move(header).value();
        has_header_ = true;
        position_ = header_.size;
        lines_ = LineScanner(bytes_.substr(position_));
        while (vertex_element_ < header_.elements.size() && header_.elements[vertex_element_].name != "vertex") {
            ++vertex_element_;
        }
        if (vertex_element_ == header_.elements.size()) {
            return Error{ErrorCode::MalformedInput, "The PLY header has no element vertex."};
        }
        return choose_columns(header_.elements[vertex_element_]);
    }

    /// Columns are the single-valued properties; x, y and, if there is one, z are the coordinates.
    std::optional<Error> choose_columns(const PlyElement& vertex) {
        std::array<std::optional<std::uint32_t>, 3> axes;
        std::uint32_t column = 0;
        for (const PlyProperty& property : vertex.properties) {
            if (property.list_count_type) continue;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                if (!axes[axis] && property.name == std::string_view("xyz").substr(axis, 1)) axes[axis] = column;
            }
            ++column;
        }
        std::vector<std::uint32_t> suggested;
        for (const auto& axis : axes) {
            if (axis) suggested.push_back(*axis);
        }
        if (!sink_.columns_asked() && (!axes[0] || !axes[1])) {
            return Error{ErrorCode::MalformedInput, "The vertices of this PLY file have no properties x and y."};
        }
        if (auto error = sink_.choose(column, suggested)) return error;
        if (header_.encoding != PlyEncoding::Ascii && !vertex.has_list()) {
            if ((bytes_.size() - position_) / vertex.row_size() >= vertex.count) sink_.reserve(vertex.count);
        }
        return std::nullopt;
    }

    /// One row of an ascii file, or nothing if the line is empty.
    std::optional<Error> read_line() {
        const auto line = lines_.next();
        if (!line) return file_ends_early();
        split_at_blanks(*line, fields_);
        if (fields_.empty()) return std::nullopt;
        ++row_;
        if (element_ != vertex_element_) return std::nullopt;
        const std::uint64_t number = header_.lines + lines_.line_number();
        // Close up the fields of lists, so that a column is a field.
        std::size_t from = 0;
        std::size_t to = 0;
        for (const PlyProperty& property : header_.elements[element_].properties) {
            if (from >= fields_.size()) return wrong_length(number);
            if (property.list_count_type) {
                const auto length = parse_count(fields_[from]);
                if (!length || *length > fields_.size() - from - 1) return wrong_length(number);
                from += static_cast<std::size_t>(*length) + 1;
            } else {
                fields_[to++] = fields_[from++];
            }
        }
        if (from != fields_.size()) return wrong_length(number);
        fields_.resize(to);
        return sink_.add_fields(fields_, number);
    }

    /// One row of a binary file, or all rows at once of an element that is skipped and has rows of one length.
    std::optional<Error> read_binary_row() {
        const PlyElement& element = header_.elements[element_];
        const bool is_vertex = element_ == vertex_element_;
        if (!is_vertex && !element.has_list()) {
            const std::uint64_t left = bytes_.size() - position_;
            if (left / element.row_size() < element.count) return file_ends_early();
            position_ += static_cast<std::size_t>(element.count * element.row_size());
            row_ = element.count;
            return std::nullopt;
        }
        const bool big_endian = header_.encoding == PlyEncoding::BigEndian;
        const ByteOrder order = big_endian ? ByteOrder::BigEndian : ByteOrder::LittleEndian;
        row_values_.clear();
        for (const PlyProperty& property : element.properties) {
            const NumberType type = property.list_count_type.value_or(property.type);
            if (bytes_.size() - position_ < byte_size(type)) return file_ends_early();
            const double value = decode_number(bytes_.data() + position_, type, order);
            position_ += byte_size(type);
            if (!property.list_count_type) {
                row_values_.push_back(value);
                continue;
            }
            if (value < 0) {
                return Error{ErrorCode::MalformedInput, "Row " + std::to_string(row_ + 1) + " of element " +
                                                            in_quotes(element.name) +
                                                            " has a list of negative length."};
            }
            const auto length = static_cast<std::uint64_t>(value);
            if ((bytes_.size() - position_) / byte_size(property.type) < length) return file_ends_early();
            position_ += static_cast<std::size_t>(length * byte_size(property.type));
        }
        ++row_;
        if (!is_vertex) return std::nullopt;
        const std::span<double> point = sink_.point();
        const auto columns = sink_.columns();
        for (std::size_t axis = 0; axis < columns.size(); ++axis) point[axis] = row_values_[columns[axis]];
        return sink_.add_point(point, "Vertex", row_);
    }

    Error wrong_length(std::uint64_t line_number) const {
        return {ErrorCode::RaggedRows, "Line " + std::to_string(line_number) + " has " +
                                           std::to_string(fields_.size()) +
                                           " numbers, which is not what the PLY header says of a vertex."};
    }

    Error file_ends_early() const {
        const PlyElement& element = header_.elements[element_];
        return {ErrorCode::MalformedInput, "The PLY header promises " + std::to_string(element.count) +
                                               " rows of element " + in_quotes(element.name) +
                                               ", but the file ends after " + std::to_string(row_) + "."};
    }

    std::string_view bytes_;
    RowSink& sink_;
    bool has_header_ = false;
    PlyHeader header_;
    std::size_t vertex_element_ = 0;
    std::size_t element_ = 0;   ///< that is being read
    std::uint64_t row_ = 0;     ///< rows of it that were read
    std::size_t position_ = 0;  ///< binary: next byte
    LineScanner lines_;         ///< ascii: the lines behind the header
    std::vector<std::string_view> fields_;
    std::vector<double> row_values_;  ///< single-valued properties of a binary row
};

}  // namespace

std::unique_ptr<FormatReader> make_ply_reader(std::string_view bytes, RowSink& sink) {
    return std::make_unique<PlyReader>(bytes, sink);
}

}  // namespace plateau
