#pragma once

#include <cstdint>
#include <vector>

namespace plateau {

/// Sparse columns over Z/p in echelon form: no two of them lead with the same row.
class Echelon {
public:
    struct Entry {
        std::uint32_t row = 0;
        std::uint32_t value = 0;  ///< 1 .. p-1
    };
    /// Ascending rows, without zeros; it leads with its first row.
    using Column = std::vector<Entry>;
    static constexpr std::uint32_t kNoRow = 0xFFFFFFFFu;

    /// `prime` at most 46337, so that products fit.
    explicit Echelon(std::uint32_t prime) : prime_(prime) {}

    /// Empties it for columns with rows 0 .. row_count - 1.
    void reset(std::uint32_t row_count);
    /// Puts a column in, reduced by those that are there; the row that it leads with then, or kNoRow if it depends on
    /// them. Cost: the fill of the reduction.
    std::uint32_t insert(Column column);
    /// How many entries the last insert() went through.
    std::uint32_t looked_at() const { return looked_at_; }

    std::uint32_t rank() const { return static_cast<std::uint32_t>(columns_.size()); }
    /// Forgets the columns put in last, down to the rank.
    void shrink_to(std::uint32_t rank);

private:
    void subtract(Column& column, const Column& pivot);

    std::uint32_t prime_;
    std::vector<Column> columns_;
    std::vector<std::uint32_t> led_by_;  // row -> column that leads with it, or kNoRow
    std::uint32_t looked_at_ = 0;
    Column sum_;  // scratch
};

}  // namespace plateau
