#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "complex/simplex_books.h"
#include "complex/simplex_table.h"
#include "homology/echelon.h"

namespace plateau {

/// The dimension of Z_k, the space of k-cycles over Z/p, of track 0 of a complex that need not be embedded, after every
/// step, k >= 2.
///
/// Let V be spanned by the boundaries of the k-simplices that stay at a step, R by those that go, A by those that come.
/// The dimension changes by the number of simplices less rank(V + A) - rank(V + R), and that is found near the new
/// landmark. Of V only a ball is looked at, the simplices found so far across shared facets. It bounds ranks modulo V
/// from both sides: from above, as it is a part of V, and from below, when facets that simplices beyond the ball may
/// have are ignored. What comes stands in for what goes: mostly both have the same boundary, and the empty ball is
/// enough. Else the ball doubles until the bounds meet. A simplex that alone has some facet is in no cycle and leaves
/// the search, with what it led to; so a nearby hole ends it.
class CycleSpace {
public:
    CycleSpace(int k, std::uint32_t prime) : k_(k), prime_(prime), echelon_(prime) {}

    /// Follows one insertion, after the complex has followed it.
    void update(Step step, const std::vector<SimplexTable>& tables, const SimplexBooks& books,
                std::span<const Death> deaths);

    std::uint32_t dimension() const { return static_cast<std::uint32_t>(dimension_); }
    std::uint64_t memory() const { return (row_of_.capacity() + column_of_.capacity()) * sizeof(std::uint32_t); }

private:
    static constexpr std::uint32_t kNone = 0xFFFFFFFFu;
    enum class Kind : std::uint8_t { Stays, Goes, Comes };
    struct Column {  // a k-simplex that is looked at
        SimplexIndex simplex = 0;
        Kind kind = Kind::Stays;
        bool alone = false;  // found in no cycle
    };
    struct Row {  // one of its facets
        SimplexIndex facet = 0;
        std::uint32_t unseen = 0;   // simplices that have it, stay, and are not in the ball
        std::uint32_t columns = 0;  // that have it and are not found alone
        std::uint32_t mixed = 0;    // their indices by exclusive or

        /// One column has it, and no other simplex ever will.
        bool lonely() const { return columns == 1 && unseen == 0; }
    };
    struct Around {
        Step step;
        const SimplexTable& simplices;
        const SimplexBooks& books;
    };

    template <class Use>
    void for_each_unseen(SimplexIndex facet, const Around& around, const Use& use) const;
    std::uint32_t row(SimplexIndex facet, const Around& around);
    void add(SimplexIndex simplex, Kind kind, const Around& around);
    void set_aside_alone(const Around& around);
    bool bounds_meet(const Around& around);
    void grow(const Around& around);
    Echelon::Column boundary(const Column& column, const Around& around) const;
    void forget();

    int k_;
    std::uint32_t prime_;
    std::int64_t dimension_ = 0;
    std::int64_t rank_change_ = 0;          // rank(V + A) - rank(V + R) of the step, as far as it is known
    std::vector<std::uint32_t> row_of_;     // facet -> row, or kNone
    std::vector<std::uint32_t> column_of_;  // simplex -> column, or kNone
    std::vector<Row> rows_;
    std::vector<Column> columns_;
    std::uint32_t changing_ = 0;                 // columns that go or come and are not found alone
    std::vector<std::uint32_t> lonely_, place_;  // scratch
    Echelon echelon_;
};

}  // namespace plateau
