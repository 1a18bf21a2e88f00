#include "homology/cycle_space.h"

#include <algorithm>
#include <array>

namespace plateau {

namespace {

constexpr std::size_t kFirstBall = 16;  // columns
// What a column counts as of a Slice, and how many entries as one unit.
constexpr std::uint32_t kUnits = 8;
constexpr std::uint32_t kEntriesPerUnit = 32;

}  // namespace

CycleSpace::CycleSpace(int k, std::span<const std::uint32_t> primes) : k_(k), fields_(primes.begin(), primes.end()) {}

bool CycleSpace::update(Step step, const std::vector<SimplexTable>& tables, const SimplexBooks& books,
                        std::span<const Death> deaths, Slice& slice) {
    const SimplexTable& simplices = tables[static_cast<std::size_t>(k_ - 1)];
    const Around around{step, simplices, books};
    if (at_.phase == Phase::Idle) {
        row_of_.resize(tables[static_cast<std::size_t>(k_ - 2)].size(), kNone);
        column_of_.resize(simplices.size(), kNone);
        at_ = {.phase = Phase::Collect};
    }
    if (at_.phase == Phase::Collect) {
        if (!collect(deaths, around, slice)) return false;
        at_ = {.phase = Phase::SetAside};
    }
    for (;;) {
        if (at_.phase == Phase::SetAside) {
            set_aside_alone(around);
            if (changing_ == 0) break;
            at_ = {.phase = Phase::Eliminate, .inside = place_rows()};
        }
        if (at_.phase == Phase::Eliminate) {
            if (!eliminate(around, slice)) return false;
            if (all_settled()) break;
            at_ = {.phase = Phase::Grow, .enough = std::max(kFirstBall, 2 * columns_.size())};
        }
        if (!grow(around, slice)) return false;
        at_ = {.phase = Phase::SetAside};
    }
    for (Field& field : fields_) field.dimension += more_ - field.rank_change.value_or(alone_);
    forget();
    return true;
}

// What goes and what comes.
bool CycleSpace::collect(std::span<const Death> deaths, const Around& around, Slice& slice) {
    for (; at_.next < deaths.size(); ++at_.next) {
        const Death& death = deaths[at_.next];
        if (death.track != 0 || death.dimension != k_) continue;
        if (slice.used_up(kUnits)) return false;
        add(death.simplex, Kind::Goes, around);
        --more_;
    }
    const SimplexIndex first = around.simplices.first_of_step[around.step];
    for (; first + (at_.next - deaths.size()) < around.simplices.size(); ++at_.next) {
        const auto simplex = static_cast<SimplexIndex>(first + (at_.next - deaths.size()));
        if (around.simplices.death[0][simplex] != kNever) continue;
        if (slice.used_up(kUnits)) return false;
        add(simplex, Kind::Comes, around);
        ++more_;
    }
    return true;
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

// The facets that lead out of the ball are the last rows, so that a column leads with one only if it has no other. How
// many rows go before them.
std::uint32_t CycleSpace::place_rows() {
    place_.resize(rows_.size());
    std::uint32_t inside = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (rows_[i].unseen == 0) place_[i] = inside++;
    }
    std::uint32_t all = inside;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (rows_[i].unseen != 0) place_[i] = all++;
    }
    return inside;
}

bool CycleSpace::eliminate(const Around& around, Slice& slice) {
    for (; at_.field < fields_.size(); ++at_.field) {
        Field& field = fields_[at_.field];
        if (field.rank_change) continue;
        for (; at_.round < kRounds.size(); ++at_.round) {
            if (!put_in(field, around, slice)) return false;
            at_.next = 0;
        }
        at_.round = 0;
        field.rank_change = settled_change();
    }
    return true;
}

// All columns of the round; so many ranks they add.
bool CycleSpace::put_in(Field& field, const Around& around, Slice& slice) {
    Echelon& echelon = field.echelon;
    Ranks& ranks = at_.ranks[at_.round];
    if (at_.next == 0) {
        ranks = {};
        if (at_.round == 0) echelon.reset(static_cast<std::uint32_t>(rows_.size()));
        if (at_.round == 1) at_.staying = echelon.rank();
        if (at_.round == 3) echelon.shrink_to(at_.staying);
    }
    for (; at_.next < columns_.size(); ++at_.next) {
        const Column& column = columns_[at_.next];
        if (column.kind != kRounds[at_.round] || column.alone) continue;
        if (slice.used_up(kUnits)) return false;
        const std::uint32_t lead = echelon.insert(boundary(column, field.prime, around));
        slice.charge(echelon.looked_at() / kEntriesPerUnit);
        if (lead != Echelon::kNoRow) ++ranks.upper;
        if (lead < at_.inside) ++ranks.lower;
    }
    return true;
}

// rank(V + A) - rank(V + R) = rank(A mod V + R) - rank(R mod V + A), each between what it is without the facets that
// lead out of the ball and what it is with them. None while the bounds differ.
std::optional<std::int64_t> CycleSpace::settled_change() const {
    const auto& [stay, gone, come_after, come] = at_.ranks;
    if (come_after.upper != come_after.lower) return std::nullopt;
    // rank(R mod V + A) = rank(R mod V) + rank(A mod V + R) - rank(A mod V)
    const std::int64_t gone_after_upper = gone.upper + come_after.upper - come.upper;
    const std::int64_t gone_after_lower = gone.lower + come_after.lower - come.lower;
    if (gone_after_upper != gone_after_lower) return std::nullopt;
    return alone_ + come_after.upper - gone_after_upper;
}

bool CycleSpace::all_settled() const {
    return std::all_of(fields_.begin(), fields_.end(),
                       [](const Field& field) { return field.rank_change.has_value(); });
}

// Doubles the ball, facet by facet, from what is not set aside.
bool CycleSpace::grow(const Around& around, Slice& slice) {
    for (; at_.next < rows_.size() && columns_.size() < at_.enough; ++at_.next) {
        const Row& row = rows_[at_.next];
        if (row.unseen == 0 || row.columns == 0) continue;
        if (slice.used_up(kUnits)) return false;
        const std::size_t before = columns_.size();
        // Adding one makes rows, which may move the others.
        const SimplexIndex facet = row.facet;
        for_each_unseen(facet, around, [&](SimplexIndex simplex) { add(simplex, Kind::Stays, around); });
        slice.charge(kUnits * static_cast<std::uint32_t>(columns_.size() - before));
    }
    return true;
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
    more_ = 0;
    changing_ = 0;
    at_ = {};
}

}  // namespace plateau
