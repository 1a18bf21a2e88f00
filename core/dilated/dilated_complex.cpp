#include "dilated/dilated_complex.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/random.h"

namespace plateau {

namespace {

// Cospherical landmarks would make cells of more than d + 1 of them. As a part of epsilon^2 this is far below what can
// be seen and far above rounding.
constexpr double kTieBreaking = 0x1p-36;

double tie_breaking_weight_squared(Step step, double epsilon) {
    Random random(step);
    return kTieBreaking * epsilon * epsilon * random.next_unit();
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

void DilatedComplex::insert(Step step, std::span<const double> point, double epsilon, const LandmarkLists& lists,
                            std::vector<SimplexTable>& of_dimension) {
    Tables tables{step, of_dimension};
    if (!search_) search_.emplace(lists, landmarks_);
    deaths_.clear();
    hidden_.clear();
    landmarks_.add(point, 0);
    weigh(step, epsilon);
    hidden_since_.push_back(kNever);
    const double zeta = options_.dilation * epsilon;

    lose(zeta, tables);
    std::sort(deaths_.begin(), deaths_.end(), [&](const Death& a, const Death& b) {
        if (a.dimension != b.dimension) return a.dimension < b.dimension;
        const auto x = tables[a.dimension].tuple(a.simplex);
        const auto y = tables[b.dimension].tuple(b.simplex);
        return std::lexicographical_compare(x.begin(), x.end(), y.begin(), y.end());
    });
    const auto own = search_->find({&step, 1}, zeta, landmarks_.point(step));
    if (own) {
        living_[0].push_back({step, *own});
    } else {
        hidden_since_[step] = step;
        hidden_.push_back(step);
    }
    for (std::size_t k = 1; k < living_.size(); ++k) {
        if (own) k == 1 ? bear_edges(zeta, tables) : bear(k, zeta, tables);
        tables[k].first_of_step.resize(step + std::size_t{2}, 0);
        tables[k].first_of_step[step + 1] = tables[k].size();
    }
}

// omega(p)^2 of the new landmark, and how large the weights are for the distances so far.
void DilatedComplex::weigh(Step step, double epsilon) {
    const double tie_breaking = tie_breaking_weight_squared(step, epsilon);
    landmarks_.reweigh(tie_breaking);
    if (!options_.pumps) return;
    double nearest = std::numeric_limits<double>::infinity();
    for (Step other = 1; other < step; ++other) {
        const double squared = landmarks_.distance_squared(other, landmarks_.point(step));
        nearest = std::min(nearest, squared);
        nearest_squared_[other] = std::min(nearest_squared_[other], squared);
    }
    nearest_squared_.push_back(nearest);
    pump_ = {};
    // The first landmark has no other, and at epsilon = 0 witnesses have no radius.
    if (step > 1 && epsilon > 0) {
        std::vector<Step> vertices;
        for (const Living& vertex : living_[0]) vertices.push_back(vertex.simplex);
        const double omega_bar = options_.pump.omega_bar;
        Pumping pumping(landmarks_, *search_, options_.pump);
        pump_ = pumping.pump(options_.pump.dilation * epsilon, omega_bar * omega_bar * nearest, tie_breaking, vertices);
    }
    double amplitude_squared = 0;
    for (Step landmark = 1; landmark <= step; ++landmark) {
        amplitude_squared =
            std::max(amplitude_squared, landmarks_.weight_squared(landmark) / nearest_squared_[landmark]);
    }
    pump_.amplitude = std::sqrt(amplitude_squared);
}

void DilatedComplex::lose(double zeta, Tables& tables) {
    for (std::size_t k = 0; k < living_.size(); ++k) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < living_[k].size(); ++i) {
            Living& living = living_[k][i];
            if (is_dead(k, living.simplex, tables)) continue;
            const Watch& watch = living.watch;
            const bool is_cut = landmarks_.power(tables.step, watch.nearest.data()) < watch.power;
            if (is_cut || watch.distance_squared > zeta * zeta) {
                const auto vertices = tuple(k, living.simplex, tables);
                std::optional<Watch> next;
                if (is_cut) next = search_->look_at(vertices, zeta, watch.witness);
                if (!next) next = search_->find(vertices, zeta, watch.nearest.data());
                if (!next) {
                    kill(k, living.simplex, tables);
                    continue;
                }
                living.watch = *next;
            }
            living_[k][kept++] = living;
        }
        living_[k].resize(kept);
    }
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

void DilatedComplex::bear_edges(double zeta, Tables& tables) {
    const double reach = search_->reach(zeta);
    const double* p = landmarks_.point(tables.step);
    for (Step other = 1; other < tables.step; ++other) {
        if (hidden_since_[other] != kNever) continue;
        if (landmarks_.distance_squared(other, p) > reach * reach) continue;
        const std::array edge = {other, tables.step};
        if (const auto watch = search_->find(edge, zeta, p)) bear_one(1, edge, {}, *watch, tables);
    }
}

// Two of the simplices just born that differ in one vertex span a candidate; all of its facets must live.
void DilatedComplex::bear(std::size_t k, double zeta, Tables& tables) {
    SimplexTable& below = tables[k - 1];
    const SimplexIndex first = below.first_of_step[tables.step];
    const SimplexIndex last = below.size();
    std::array<Step, kMaxDilatedDimension + 1> simplex{};
    std::array<SimplexIndex, kMaxDilatedDimension + 1> facets{};
    for (SimplexIndex a = first; a < last; ++a) {
        for (SimplexIndex b = a + 1; b < last; ++b) {
            const auto x = below.tuple(a);
            const auto y = below.tuple(b);
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
            if (!lives) continue;
            const std::span<const Step> vertices{simplex.data(), k + 1};
            if (const auto watch = search_->find(vertices, zeta, landmarks_.point(tables.step))) {
                bear_one(k, vertices, {facets.data(), k + 1}, *watch, tables);
            }
        }
    }
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
    return bytes + (search_ ? search_->memory() : 0);
}

}  // namespace plateau
