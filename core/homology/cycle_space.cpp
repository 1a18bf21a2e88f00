#include "homology/cycle_space.h"

#include <algorithm>
#include <array>

namespace plateau {

namespace {

constexpr std::size_t kFirstBall = 16;  // columns

}  // namespace

CycleSpace::CycleSpace(int k, std::span<const std::uint32_t> primes) : k_(k), fields_(primes.begin(), primes.end()) {}

void CycleSpace::update(Step step, const std::vector<SimplexTable>& tables, const SimplexBooks& books,
                        std::span<const Death> deaths) {
    const SimplexTable& simplices = tables[static_cast<std::size_t>(k_ - 1)];
    const Around around{step, simplices, books};
    row_of_.resize(tables[static_cast<std::size_t>(k_ - 2)].size(), kNone);
    column_of_.resize(simplices.size(), kNone);

    std::int64_t more = 0;  // simplices
    for (const Death& death : deaths) {
        if (death.track != 0 || death.dimension != k_) continue;
        add(death.simplex, Kind::Goes, around);
        --more;
    }
    for (SimplexIndex simplex = simplices.first_of_step[step]; simplex < simplices.size(); ++simplex) {
        if (simplices.death[0][simplex] != kNever) continue;
        add(simplex, Kind::Comes, around);
        ++more;
    }
    for (;;) {
        set_aside_alone(around);
        if (changing_ == 0 || all_settled(around)) break;
        grow(around);
    }
    for (Field& field : fields_) field.dimension += more - field.rank_change.value_or(alone_);
    forget();
}

// Calls use(simplex) for those that have the facet, stay, and are not in the ball.
template <class Use>
void CycleSpace::for_each_unseen(SimplexIndex facet, const Around& around, const Use& use) const {
    around.books.for_each_coface(k_ - 1, facet, [&](SimplexIndex simplex) {
        const bool stays =
            around.simplices.birth(simplex) < around.step && around.simplices.death[0][simplex] == kNever;
        if (stays && column_of_[simplex] == kNone) use(simplex);
    });
}

std::uint32_t CycleSpace::row(SimplexIndex facet, const Around& around) {
    if (row_of_[facet] != kNone) return row_of_[facet];
    Row row{facet};
    for_each_unseen(facet, around, [&](SimplexIndex) { ++row.unseen; });
    row_of_[facet] = static_cast<std::uint32_t>(rows_.size());
    rows_.push_back(row);
    return row_of_[facet];
}

void CycleSpace::add(SimplexIndex simplex, Kind kind, const Around& around) {
    const auto column = static_cast<std::uint32_t>(columns_.size());
    if (kind != Kind::Stays) ++changing_;
    for (const SimplexIndex facet : around.books.facets(k_, simplex)) {
        const std::uint32_t index = row(facet, around);
        if (kind == Kind::Stays) --rows_[index].unseen;
        ++rows_[index].columns;
        rows_[index].mixed ^= column;
    }
    columns_.push_back({simplex, kind});
    column_of_[simplex] = column;
}

// The rank grows by one with each of them, whatever else is put in.
void CycleSpace::set_aside_alone(const Around& around) {
    lonely_.clear();
    for (std::uint32_t i = 0; i < rows_.size(); ++i) {
        if (rows_[i].lonely()) lonely_.push_back(i);
    }
    while (!lonely_.empty()) {
        const Row row = rows_[lonely_.back()];
        lonely_.pop_back();
        if (row.columns != 1) continue;
        Column& column = columns_[row.mixed];
        column.alone = true;
        if (column.kind != Kind::Stays) --changing_;
        if (column.kind == Kind::Comes) ++alone_;
        if (column.kind == Kind::Goes) --alone_;
        for (const SimplexIndex facet : around.books.facets(k_, column.simplex)) {
            const std::uint32_t index = row_of_[facet];
            --rows_[index].columns;
            rows_[index].mixed ^= row.mixed;
            if (rows_[index].lonely()) lonely_.push_back(index);
        }
    }
}

// The facets that lead out of the ball are the last rows, so that a column leads with one only if it has no other.
bool CycleSpace::all_settled(const Around& around) {
    place_.resize(rows_.size());
    std::uint32_t inside = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (rows_[i].unseen == 0) place_[i] = inside++;
    }
    std::uint32_t all = inside;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (rows_[i].unseen != 0) place_[i] = all++;
    }
    bool settled = true;
    for (Field& field : fields_) {
        if (!field.rank_change) field.rank_change = settled_change(field, inside, around);
        settled = settled && field.rank_change;
    }
    return settled;
}

// rank(V + A) - rank(V + R) = rank(A mod V + R) - rank(R mod V + A), each between what it is without the facets that
// lead out of the ball and what it is with them. None while the bounds differ.
std::optional<std::int64_t> CycleSpace::settled_change(Field& field, std::uint32_t inside, const Around& around) {
    Echelon& echelon = field.echelon;
    struct Ranks {
        std::int64_t upper = 0, lower = 0;
    };
    const auto put_in = [&](Kind kind) {
        Ranks ranks;
        for (const Column& column : columns_) {
            if (column.kind != kind || column.alone) continue;
            const std::uint32_t lead = echelon.insert(boundary(column, field.prime, around));
            if (lead != Echelon::kNoRow) ++ranks.upper;
            if (lead < inside) ++ranks.lower;
        }
        return ranks;
    };
    echelon.reset(static_cast<std::uint32_t>(rows_.size()));
    put_in(Kind::Stays);
    const std::uint32_t staying = echelon.rank();
    const Ranks gone = put_in(Kind::Goes);
    const Ranks come_after = put_in(Kind::Comes);
    echelon.shrink_to(staying);
    const Ranks come = put_in(Kind::Comes);
    if (come_after.upper != come_after.lower) return std::nullopt;
    // rank(R mod V + A) = rank(R mod V) + rank(A mod V + R) - rank(A mod V)
    const std::int64_t gone_after_upper = gone.upper + come_after.upper - come.upper;
    const std::int64_t gone_after_lower = gone.lower + come_after.lower - come.lower;
    if (gone_after_upper != gone_after_lower) return std::nullopt;
    return alone_ + come_after.upper - gone_after_upper;
}

// Doubles the ball, facet by facet, from what is not set aside.
void CycleSpace::grow(const Around& around) {
    const std::size_t enough = std::max(kFirstBall, 2 * columns_.size());
    for (std::size_t i = 0; i < rows_.size() && columns_.size() < enough; ++i) {
        if (rows_[i].unseen == 0 || rows_[i].columns == 0) continue;
        for_each_unseen(rows_[i].facet, around, [&](SimplexIndex simplex) { add(simplex, Kind::Stays, around); });
    }
}

Echelon::Column CycleSpace::boundary(const Column& column, std::uint32_t prime, const Around& around) const {
    Echelon::Column boundary;
    std::uint32_t sign = 1;
    for (const SimplexIndex facet : around.books.facets(k_, column.simplex)) {
        boundary.push_back({place_[row_of_[facet]], sign});
        sign = prime - sign;
    }
    std::sort(boundary.begin(), boundary.end(),
              [](const Echelon::Entry& a, const Echelon::Entry& b) { return a.row < b.row; });
    return boundary;
}

void CycleSpace::forget() {
    for (const Row& row : rows_) row_of_[row.facet] = kNone;
    for (const Column& column : columns_) column_of_[column.simplex] = kNone;
    rows_.clear();
    columns_.clear();
    for (Field& field : fields_) field.rank_change.reset();
    alone_ = 0;
    changing_ = 0;
}

}  // namespace plateau
