#include "homology/cycle_space.h"

#include <algorithm>
#include <array>

namespace plateau {

namespace {

constexpr std::size_t kFirstBall = 16;  // columns

}  // namespace

void CycleSpace::update(Step step, const std::vector<SimplexTable>& tables, const SimplexBooks& books,
                        std::span<const Death> deaths) {
    const SimplexTable& simplices = tables[static_cast<std::size_t>(k_ - 1)];
    const Around around{step, simplices, books};
    row_of_.resize(tables[static_cast<std::size_t>(k_ - 2)].size(), kNone);
    column_of_.resize(simplices.size(), kNone);

    for (const Death& death : deaths) {
        if (death.track != 0 || death.dimension != k_) continue;
        add(death.simplex, Kind::Goes, around);
        --dimension_;
    }
    for (SimplexIndex simplex = simplices.first_of_step[step]; simplex < simplices.size(); ++simplex) {
        if (simplices.death[0][simplex] != kNever) continue;
        add(simplex, Kind::Comes, around);
        ++dimension_;
    }
    rank_change_ = 0;
    for (;;) {
        set_aside_alone(around);
        if (changing_ == 0 || bounds_meet(around)) break;
        grow(around);
    }
    dimension_ -= rank_change_;
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
        if (column.kind == Kind::Comes) ++rank_change_;
        if (column.kind == Kind::Goes) --rank_change_;
        for (const SimplexIndex facet : around.books.facets(k_, column.simplex)) {
            const std::uint32_t index = row_of_[facet];
            --rows_[index].columns;
            rows_[index].mixed ^= row.mixed;
            if (rows_[index].lonely()) lonely_.push_back(index);
        }
    }
}

// rank(V + A) - rank(V + R) = rank(A mod V + R) - rank(R mod V + A), each between what it is without the facets that
// lead out of the ball and what it is with them. Those facets are the last rows, so that a column leads with one only
// if it has no other.
bool CycleSpace::bounds_meet(const Around& around) {
    place_.resize(rows_.size());
    std::uint32_t inside = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (rows_[i].unseen == 0) place_[i] = inside++;
    }
    std::uint32_t all = inside;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (rows_[i].unseen != 0) place_[i] = all++;
    }
    struct Ranks {
        std::int64_t upper = 0, lower = 0;
    };
    const auto put_in = [&](Kind kind) {
        Ranks ranks;
        for (const Column& column : columns_) {
            if (column.kind != kind || column.alone) continue;
            const std::uint32_t lead = echelon_.insert(boundary(column, around));
            if (lead != Echelon::kNoRow) ++ranks.upper;
            if (lead < inside) ++ranks.lower;
        }
        return ranks;
    };
    echelon_.reset(all);
    put_in(Kind::Stays);
    const std::uint32_t staying = echelon_.rank();
    const Ranks gone = put_in(Kind::Goes);
    const Ranks come_after = put_in(Kind::Comes);
    echelon_.shrink_to(staying);
    const Ranks come = put_in(Kind::Comes);
    if (come_after.upper != come_after.lower) return false;
    // rank(R mod V + A) = rank(R mod V) + rank(A mod V + R) - rank(A mod V)
    const std::int64_t gone_after_upper = gone.upper + come_after.upper - come.upper;
    const std::int64_t gone_after_lower = gone.lower + come_after.lower - come.lower;
    if (gone_after_upper != gone_after_lower) return false;
    rank_change_ += come_after.upper - gone_after_upper;
    return true;
}

// Doubles the ball, facet by facet, from what is not set aside.
void CycleSpace::grow(const Around& around) {
    const std::size_t enough = std::max(kFirstBall, 2 * columns_.size());
    for (std::size_t i = 0; i < rows_.size() && columns_.size() < enough; ++i) {
        if (rows_[i].unseen == 0 || rows_[i].columns == 0) continue;
        for_each_unseen(rows_[i].facet, around, [&](SimplexIndex simplex) { add(simplex, Kind::Stays, around); });
    }
}

Echelon::Column CycleSpace::boundary(const Column& column, const Around& around) const {
    Echelon::Column boundary;
    std::uint32_t sign = 1;
    for (const SimplexIndex facet : around.books.facets(k_, column.simplex)) {
        boundary.push_back({place_[row_of_[facet]], sign});
        sign = prime_ - sign;
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
    changing_ = 0;
}

}  // namespace plateau
