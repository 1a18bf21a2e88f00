#include "io/row_sink.h"

#include <algorithm>
#include <cmath>

#include "io/fields.h"
#include "io/text.h"

namespace plateau {

std::optional<Error> RowSink::check_options() const {
    if (asked_.empty()) return std::nullopt;
    if (takes_any_dimension() && asked_.size() < 2) {
        return Error{ErrorCode::InvalidOption, "Name at least two columns."};
    }
    if (!takes_any_dimension() && asked_.size() != 2 && asked_.size() != 3) {
        return Error{ErrorCode::InvalidOption, "Name two or three columns, not " + std::to_string(asked_.size()) + "."};
    }
    for (std::size_t k = 0; k < asked_.size(); ++k) {
        if (asked_[k] == 0) return Error{ErrorCode::InvalidOption, "Columns are counted from 1."};
        for (std::size_t other = 0; other < k; ++other) {
            if (asked_[k] == asked_[other]) {
                return Error{ErrorCode::InvalidOption, "Column " + std::to_string(asked_[k]) + " is named twice."};
            }
        }
    }
    return std::nullopt;
}

std::optional<Error> RowSink::choose(std::uint32_t columns_in_file, std::span<const std::uint32_t> suggested) {
    result_.columns_in_file = columns_in_file;
    chosen_.assign(suggested.begin(), suggested.end());
    if (!asked_.empty()) {
        chosen_.clear();
        for (const std::uint32_t column : asked_) {
            if (column > columns_in_file) {
                return Error{ErrorCode::InvalidOption, "There is no column " + std::to_string(column) +
                                                           ": the file has " + std::to_string(columns_in_file) + "."};
            }
            chosen_.push_back(column - 1);
        }
    }
    result_.cloud.dimension = static_cast<std::uint32_t>(chosen_.size());
    point_.resize(chosen_.size());
    return std::nullopt;
}

void RowSink::reserve(std::uint64_t points) {
    // The largest files grow on their own: a reservation that fails would be fatal.
    constexpr std::uint64_t kMostReserved = std::uint64_t{1} << 24;
    result_.cloud.coordinates.reserve(static_cast<std::size_t>(std::min(points, kMostReserved)) * chosen_.size());
}

void RowSink::warn_of_dimension(std::uint32_t columns) {
    warn("Took all " + std::to_string(columns) + " columns as coordinates: points in R^" + std::to_string(columns) +
         ". If they are not, name the ones that are, such as --columns 1,2,3.");
}

std::optional<Error> RowSink::add_fields(std::span<const std::string_view> fields, std::uint64_t line_number) {
    for (std::size_t axis = 0; axis < chosen_.size(); ++axis) {
        if (chosen_[axis] >= fields.size()) {
            return Error{ErrorCode::RaggedRows, "Line " + std::to_string(line_number) + " ends before column " +
                                                    std::to_string(chosen_[axis] + 1) + "."};
        }
        const std::string_view field = fields[chosen_[axis]];
        const ParsedField parsed = parse_field(field);
        if (parsed.kind == FieldKind::NotNumber) return not_a_number(field, line_number);
        if (parsed.kind == FieldKind::NotFinite) {
            return Error{ErrorCode::NotANumber, "Line " + std::to_string(line_number) + " has " + in_quotes(field) +
                                                    ", which is not a finite number."};
        }
        point_[axis] = parsed.value;
    }
    return add_point(point_, "Line", line_number);
}

std::optional<Error> RowSink::add_point(std::span<const double> point, const char* place, std::uint64_t number) {
    for (const double coordinate : point) {
        if (std::abs(coordinate) <= kMaxCoordinate) continue;
        const char* why = std::isfinite(coordinate) ? " has a coordinate beyond 1e150; scale the cloud down."
                                                    : " has a coordinate that is not a finite number.";
        return Error{ErrorCode::NotANumber, std::string(place) + " " + std::to_string(number) + why};
    }
    result_.cloud.coordinates.insert(result_.cloud.coordinates.end(), point.begin(), point.end());
    return std::nullopt;
}

Result<ReadCloud> RowSink::finished() {
    const PointCloud& cloud = result_.cloud;
    if (cloud.coordinates.empty()) return Error{ErrorCode::EmptyInput, "The file holds no points."};
    if (cloud.size() == 1) {
        return Error{ErrorCode::TooFewPoints, "The file holds one point; a shape needs at least two different ones."};
    }
    bool all_equal = true;
    for (std::size_t k = cloud.dimension; all_equal && k < cloud.coordinates.size(); ++k) {
        all_equal = cloud.coordinates[k] == cloud.coordinates[k - cloud.dimension];
    }
    if (all_equal) {
        return Error{ErrorCode::TooFewPoints, "All " + std::to_string(cloud.size()) +
                                                  " points are the same; a shape needs at least two different ones."};
    }
    return std::move(result_);
}

}  // namespace plateau
