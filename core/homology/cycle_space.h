#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/slice.h"
#include "complex/simplex_books.h"
#include "complex/simplex_table.h"
#include "homology/echelon.h"

namespace plateau {

/// The dimension of Z_k, the space of k-cycles over Z/p for one or several primes p, of track 0 of a complex that need
/// not be embedded, after every step, k >= 2.
///
/// Let V be spanned by the boundaries of the k-simplices that stay at a step, R by those that go, A by those that come.
/// The dimension changes by the number of simplices less rank(V + A) - rank(V + R), and that is found near the new
/// landmark. Of V only a ball is looked at, the simplices found so far across shared facets. It bounds ranks modulo V
/// from both sides: from above, as it is a part of V, and from below, when facets that simplices beyond the ball may
/// have are ignored. What comes stands in for what goes: mostly both have the same boundary, and the empty ball is
/// enough. Else the ball doubles until the bounds meet. A simplex that alone has some facet is in no cycle and leaves
/// the search, with what it led to; so a nearby hole ends it. Boundaries have no coefficients but 1 and -1, so all that
/// is alike for every prime; only ranks within the ball are taken prime by prime.
class CycleSpace {
public:
    CycleSpace(int k, std::span<const std::uint32_t> primes);

    /// Follows one insertion, after the complex has followed it. False where the slice is used up: then it is to be
    /// called again with the same arguments, until it is true, and goes on where it was.
    bool update(Step step, const std::vector<SimplexTable>& tables, const SimplexBooks& books,
                std::span<const Death> deaths, Slice& slice);

    /// Over the prime of this 0-based index.
    std::uint32_t dimension(std::size_t field) const { return static_cast<std::uint32_t>(fields_[field].dimension); }
    std::uint64_t memory() const {
        return (row_of_.capacity() + column_of_.capacity()) * sizeof(std::uint32_t) + rows_.capacity() * sizeof(Row) +
               columns_.capacity() * sizeof(Column);
    }

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
    struct Field {
        std::uint32_t prime;
        Echelon echelon;
        std::int64_t dimension = 0;
        std::optional<std::int64_t> rank_change = std::nullopt;  // rank(V + A) - rank(V + R) of the step, once known

        explicit Field(std::uint32_t p) : prime(p), echelon(p) {}
    };
    struct Around {
        Step step;
        const SimplexTable& simplices;
        const SimplexBooks& books;
    };

    enum class Phase : std::uint8_t { Idle, Collect, SetAside, Eliminate, Grow };
    struct Ranks {
        std::int64_t upper = 0, lower = 0;  // with the facets that lead out of the ball, and without
    };
    /// The columns are put into an echelon four times: those that stay, that go, that come; and after the first again
    /// those that come.
    static constexpr std::array kRounds = {Kind::Stays, Kind::Goes, Kind::Comes, Kind::Comes};
    /// Where an update is.
    struct Place {
        Phase phase = Phase::Idle;
        std::size_t next = 0;    // collecting: the death, then the birth; eliminating: the column; growing: the row
        std::size_t enough = 0;  // growing: so many columns are
        std::size_t field = 0, round = 0;  // eliminating
        std::uint32_t inside = 0;          // eliminating: rows of facets that do not lead out of the ball
        std::uint32_t staying = 0;         // rank of the first round
        std::array<Ranks, kRounds.size()> ranks{};
    };

    template <class Use>
    void for_each_unseen(SimplexIndex facet, const Around& around, const Use& use) const;
    std::uint32_t row(SimplexIndex facet, const Around& around);
    void add(SimplexIndex simplex, Kind kind, const Around& around);
    void set_aside_alone(const Around& around);
    bool collect(std::span<const Death> deaths, const Around& around, Slice& slice);
    std::uint32_t place_rows();
    bool eliminate(const Around& around, Slice& slice);
    bool put_in(Field& field, const Around& around, Slice& slice);
    std::optional<std::int64_t> settled_change() const;
    bool all_settled() const;
    bool grow(const Around& around, Slice& slice);
    Echelon::Column boundary(const Column& column, std::uint32_t prime, const Around& around) const;
    void forget();

    int k_;
    Place at_;
    std::int64_t more_ = 0;  // simplices that come, less those that go
    std::vector<Field> fields_;
    std::int64_t alone_ = 0;                // the part of the rank's change that is found alone, over every prime
    std::vector<std::uint32_t> row_of_;     // facet -> row, or kNone
    std::vector<std::uint32_t> column_of_;  // simplex -> column, or kNone
    std::vector<Row> rows_;
    std::vector<Column> columns_;
    std::uint32_t changing_ = 0;                 // columns that go or come and are not found alone
    std::vector<std::uint32_t> lonely_, place_;  // scratch
};

}  // namespace plateau
