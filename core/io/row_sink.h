#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "io/cloud_reader.h"

namespace plateau {

/// Where every format's reader puts its rows: knows which columns are the coordinates and collects them.
class RowSink {
public:
    explicit RowSink(const ReadOptions& options) : asked_(options.columns), as_(options.as) {}

    /// The columns asked for are two or three (or more, where any dimension will do), 1-based and unlike; to be called
    /// before anything else.
    std::optional<Error> check_options() const;
    /// Whether all columns of a file are taken where nothing says which.
    bool takes_any_dimension() const { return as_ == ReadAs::PointsOfAnyDimension; }
    /// Whether the user named the columns.
    bool columns_asked() const { return !asked_.empty(); }

    /// Settles the coordinate columns once the file's width is known: those asked for, else `suggested` (0-based).
    std::optional<Error> choose(std::uint32_t columns_in_file, std::span<const std::uint32_t> suggested);
    /// 0-based, in coordinate order; empty before choose().
    std::span<const std::uint32_t> columns() const { return chosen_; }

    /// Room for the coordinates of one point, in their order; for add_point().
    std::span<double> point() { return point_; }
    /// Adds the chosen ones of a line's fields; fields beyond the columns are ignored.
    std::optional<Error> add_fields(std::span<const std::string_view> fields, std::uint64_t line_number);
    /// Adds one point. `place`: where it stands, for the message, e.g. "Vertex 7".
    std::optional<Error> add_point(std::span<const double> point, const char* place, std::uint64_t number);
    /// Room for points that are known to come.
    void reserve(std::uint64_t points);
    /// That points have more than three coordinates.
    void warn_of_dimension(std::uint32_t columns);
    void warn(std::string sentence) { result_.warnings.push_back(std::move(sentence)); }

    /// What was collected, or why it is no cloud.
    Result<ReadCloud> finished();

private:
    std::vector<std::uint32_t> asked_;  ///< 1-based
    ReadAs as_;
    std::vector<std::uint32_t> chosen_;  ///< 0-based
    std::vector<double> point_;
    ReadCloud result_;
};

}  // namespace plateau
