#include "dilated/dilated_complex.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/random.h"

namespace plateau {

namespace {

// Cospherical landmarks would make cells of more than d + 1 of them. The part of epsilon^2 is far above rounding and
// far below what can be seen now; the part of the squared distance to the nearest other witness is far below what can
// be seen ever, for no landmark comes closer.
constexpr double kOfEpsilon = 0x1p-36;
constexpr double kOfSpacing = 0x1p-18;

double tie_breaking_weight_squared(Step step, double epsilon, double spacing_squared) {
    Random random(step);
    return std::min(kOfEpsilon * epsilon * epsilon, kOfSpacing * spacing_squared) * random.next_unit();
}

}  // namespace

DilatedComplex::DilatedComplex(std::uint32_t dimension, const DilatedOptions& options)
    : options_(options),
      landmarks_(dimension),
      books_(static_cast<int>(dimension)),
      living_(dimension + std::size_t{1}),
      hidden_since_(1, kNever),
      nearest_squared_(1, std::numeric_limits<double>::infinity()) {}

std::span<const Step> DilatedComplex::tuple(std::size_t k, const SimplexIndex& simplex, Tables& tables) const {
    if (k == 0) return {&simplex, 1};
    return tables[k].tuple(simplex);
}

bool DilatedComplex::is_dead(std::size_t k, SimplexIndex simplex, Tables& tables) const {
    return (k == 0 ? hidden_since_[simplex] : tables[k].death[0][simplex]) != kNever;
}

bool DilatedComplex::insert(Step step, WitnessId witness, double epsilon, const LandmarkLists& lists,
                            std::vector<SimplexTable>& of_dimension, Slice& slice) {
    Tables tables{step, of_dimension};
    const double zeta = options_.dilation * epsilon;
    if (!search_) search_.emplace(lists, landmarks_);
    if (place_.phase == Phase::Idle) {
        if (!search_->prepare(slice)) return false;
        deaths_.clear();
        hidden_.clear();
        const KdTree& tree = lists.tree();
        landmarks_.add({tree.point(witness), tree.dimension()},
                       tie_breaking_weight_squared(step, epsilon, tree.nearest_distinct_squared(witness)));
        if (options_.pumps) begin_pumping(step, epsilon);
        hidden_since_.push_back(kNever);
        place_ = {.phase = Phase::Weigh};
    }
    if (place_.phase == Phase::Weigh) {
        if (!weigh(slice)) return false;
        place_ = {.phase = Phase::Lose};
    }
    if (place_.phase == Phase::Lose) {
        if (!lose(zeta, tables, slice)) return false;
        sort_deaths(tables);
        place_ = {.phase = Phase::BearVertex};
    }
    if (place_.phase == Phase::BearVertex) {
        if (slice.used_up(WitnessSearch::kUnits)) return false;
        bear_vertex(zeta, step);
        slice.charge(search_->looked_at());
        place_ = {.phase = Phase::Bear, .k = 1};
    }
    while (place_.k < living_.size()) {
        const std::size_t k = place_.k;
        const bool is_vertex = hidden_since_[step] == kNever;
        if (is_vertex && !(k == 1 ? bear_edges(zeta, tables, slice) : bear(k, zeta, tables, slice))) return false;
        tables[k].first_of_step.resize(step + std::size_t{2}, 0);
        tables[k].first_of_step[step + 1] = tables[k].size();
        place_ = {.phase = Phase::Bear, .k = k + 1};
    }
    place_ = {};
    return true;
}

// omega(p)^2 of the new landmark is to be chosen.
void DilatedComplex::begin_pumping(Step step, double epsilon) {
    double nearest = std::numeric_limits<double>::infinity();
    for (Step other = 1; other < step; ++other) {
        const double squared = landmarks_.distance_squared(other, landmarks_.point(step));
        nearest = std::min(nearest, squared);
        nearest_squared_[other] = std::min(nearest_squared_[other], squared);
    }
    nearest_squared_.push_back(nearest);
    pump_ = {};
    pumping_.reset();
    // The first landmark has no other, and at epsilon = 0 witnesses have no radius.
    if (step == 1 || epsilon == 0) return;
    const double omega_bar = options_.pump.omega_bar;
    pumping_.emplace(landmarks_, *search_, options_.pump);
    pumping_->begin(options_.pump.dilation * epsilon, omega_bar * omega_bar * nearest);
}

// Chooses it, and tells how large the weights are for the distances so far.
bool DilatedComplex::weigh(Slice& slice) {
    if (!options_.pumps) return true;
    if (pumping_) {
        if (!pumping_->advance(slice)) return false;
        pump_ = pumping_->result();
        pumping_.reset();
    }
    double amplitude_squared = 0;
    for (Step landmark = 1; landmark <= landmarks_.size(); ++landmark) {
        amplitude_squared =
            std::max(amplitude_squared, landmarks_.weight_squared(landmark) / nearest_squared_[landmark]);
    }
    pump_.amplitude = std::sqrt(amplitude_squared);
    return true;
}

bool DilatedComplex::lose(double zeta, Tables& tables, Slice& slice) {
    for (; place_.k < living_.size(); place_ = {.phase = Phase::Lose, .k = place_.k + 1}) {
        const std::size_t k = place_.k;
        for (; place_.next < living_[k].size(); ++place_.next) {
            Living& living = living_[k][place_.next];
            if (is_dead(k, living.simplex, tables)) continue;
            const Watch& watch = living.watch;
            const bool is_cut = landmarks_.power(tables.step, watch.nearest.data()) < watch.power;
            const bool is_lost = is_cut || watch.distance_squared > zeta * zeta;
            if (slice.used_up(is_lost ? WitnessSearch::kUnits : 1)) return false;
            if (is_lost) {
                const auto vertices = tuple(k, living.simplex, tables);
                std::optional<Watch> next;
                if (is_cut) next = search_->look_at(vertices, zeta, watch.witness);
                if (!next) {
                    next = search_->find(vertices, zeta, watch.nearest.data());
                    slice.charge(search_->looked_at());
                }
                if (!next) {
                    kill(k, living.simplex, tables);
                    continue;
                }
                living.watch = *next;
            }
            living_[k][place_.kept++] = living;
        }
        living_[k].resize(place_.kept);
    }
    return true;
}

void DilatedComplex::sort_deaths(Tables& tables) {
    std::sort(deaths_.begin(), deaths_.end(), [&](const Death& a, const Death& b) {
        if (a.dimension != b.dimension) return a.dimension < b.dimension;
        const auto x = tables[a.dimension].tuple(a.simplex);
        const auto y = tables[b.dimension].tuple(b.simplex);
        return std::lexicographical_compare(x.begin(), x.end(), y.begin(), y.end());
    });
}

void DilatedComplex::kill(std::size_t k, SimplexIndex simplex, Tables& tables) {
    if (k == 0) {
        hidden_since_[simplex] = tables.step;
        hidden_.push_back(simplex);
        for (const Living& edge : living_[1]) {
            const auto ends = tables[1].tuple(edge.simplex);
            if (ends[0] == simplex || ends[1] == simplex) kill(1, edge.simplex, tables);
        }
        return;
    }
    Step& death = tables[k].death[0][simplex];
    if (death != kNever) return;
    death = tables.step;
    deaths_.push_back({0, static_cast<std::uint8_t>(k), simplex});
    if (k + 1 == living_.size()) return;
    books_.for_each_coface(static_cast<int>(k), simplex, [&](SimplexIndex coface) { kill(k + 1, coface, tables); });
}

void DilatedComplex::bear_vertex(double zeta, Step step) {
    if (const auto own = search_->find({&step, 1}, zeta, landmarks_.point(step))) {
        living_[0].push_back({step, *own});
    } else {
        hidden_since_[step] = step;
        hidden_.push_back(step);
    }
}

bool DilatedComplex::bear_edges(double zeta, Tables& tables, Slice& slice) {
    if (place_.next == 0) place_ = {.phase = Phase::Bear, .k = 1, .next = 1, .reach = search_->reach(zeta)};
    const double* p = landmarks_.point(tables.step);
    for (; place_.next < tables.step; ++place_.next) {
        const auto other = static_cast<Step>(place_.next);
        if (hidden_since_[other] != kNever) continue;
        if (landmarks_.distance_squared(other, p) > place_.reach * place_.reach) continue;
        if (slice.used_up(WitnessSearch::kUnits)) return false;
        const std::array edge = {other, tables.step};
        if (const auto watch = search_->find(edge, zeta, p)) bear_one(1, edge, {}, *watch, tables);
        slice.charge(search_->looked_at());
    }
    return true;
}

// Two of the simplices just born that differ in one vertex span a candidate; all of its facets must live.
bool DilatedComplex::bear(std::size_t k, double zeta, Tables& tables, Slice& slice) {
    SimplexTable& below = tables[k - 1];
    const SimplexIndex first = below.first_of_step[tables.step];
    const SimplexIndex last = below.size();
    std::array<Step, kMaxDilatedDimension + 1> simplex{};
    std::array<SimplexIndex, kMaxDilatedDimension + 1> facets{};
    for (place_.next = std::max<std::size_t>(place_.next, first); place_.next < last; ++place_.next) {
        const auto a = static_cast<SimplexIndex>(place_.next);
        if (place_.partner == 0) place_.partner = a + std::size_t{1};
        for (; place_.partner < last; ++place_.partner) {
            const auto x = below.tuple(a);
            const auto y = below.tuple(static_cast<SimplexIndex>(place_.partner));
            if (!std::equal(x.begin(), x.end() - 2, y.begin())) break;
            std::copy(x.begin(), x.end() - 1, simplex.begin());
            simplex[k - 1] = y[k - 2];
            simplex[k] = tables.step;
            bool lives = true;
            for (std::size_t j = 0; j <= k && lives; ++j) {
                std::array<Step, kMaxDilatedDimension + 1> facet{};
                std::copy_n(simplex.begin(), j, facet.begin());
                std::copy(simplex.begin() + static_cast<std::ptrdiff_t>(j) + 1,
                          simplex.begin() + static_cast<std::ptrdiff_t>(k) + 1,
                          facet.begin() + static_cast<std::ptrdiff_t>(j));
                facets[j] = below.find({facet.data(), k});
                lives = facets[j] != kNoSimplex && below.death[0][facets[j]] == kNever;
            }
            if (slice.used_up(lives ? WitnessSearch::kUnits : 1)) return false;
            if (!lives) continue;
            const std::span<const Step> vertices{simplex.data(), k + 1};
            if (const auto watch = search_->find(vertices, zeta, landmarks_.point(tables.step))) {
                bear_one(k, vertices, {facets.data(), k + 1}, *watch, tables);
            }
            slice.charge(search_->looked_at());
        }
        place_.partner = 0;
    }
    return true;
}

void DilatedComplex::bear_one(std::size_t k, std::span<const Step> simplex, std::span<const SimplexIndex> facets,
                              const Watch& watch, Tables& tables) {
    SimplexTable& table = tables[k];
    living_[k].push_back({table.size(), watch});
    books_.add(static_cast<int>(k), facets);
    table.vertices.insert(table.vertices.end(), simplex.begin(), simplex.end());
    table.death[0].push_back(kNever);
}

std::uint64_t DilatedComplex::memory() const {
    std::uint64_t bytes = landmarks_.memory() + books_.memory();
    for (const auto& living : living_) bytes += living.capacity() * sizeof(Living);
    bytes += hidden_since_.capacity() * sizeof(Step) + nearest_squared_.capacity() * sizeof(double);
    bytes += deaths_.capacity() * sizeof(Death) + hidden_.capacity() * sizeof(Step);
    return bytes + (search_ ? search_->memory() : 0);
}

}  // namespace plateau
