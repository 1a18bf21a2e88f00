#include "dilated/pumping.h"

#include <algorithm>
#include <utility>

namespace plateau {

namespace {

// Calls use(face) for every non-empty face.
template <class Use>
void for_each_face(const std::vector<Step>& simplex, const Use& use) {
    std::vector<Step> face;
    for (std::uint32_t bits = 1; bits < 1u << simplex.size(); ++bits) {
        face.clear();
        for (std::size_t i = 0; i < simplex.size(); ++i) {
            if (bits >> i & 1) face.push_back(simplex[i]);
        }
        use(face);
    }
}

}  // namespace

bool Pumping::is_witnessed(std::span<const Step> simplex, std::uint32_t level) {
    landmarks_->reweigh(largest_ * level / kLevels + tie_breaking_);
    return search_->find(simplex, zeta_, landmarks_->point(p_)).has_value();
}

// At the level that suits it best: the highest with p, the lowest without.
bool Pumping::may_be_witnessed(const Simplex& simplex) {
    const auto known = possible_.find(simplex);
    if (known != possible_.end()) return known->second;
    const bool result = is_witnessed(simplex, simplex.back() == p_ ? kLevels : 0);
    possible_.emplace(simplex, result);
    return result;
}

// Of a simplex that may be witnessed, its faces aside.
Pumping::Levels Pumping::own_levels(const Simplex& simplex) {
    const auto known = levels_.find(simplex);
    if (known != levels_.end()) return known->second;
    const bool has_p = simplex.back() == p_;
    Levels levels;
    if (!is_witnessed(simplex, has_p ? 0 : kLevels)) {
        std::uint32_t low = 0;
        std::uint32_t high = kLevels;
        while (high - low > 1) {
            const std::uint32_t middle = low + (high - low) / 2;
            (is_witnessed(simplex, middle) == has_p ? high : low) = middle;
        }
        (has_p ? levels.first : levels.last) = has_p ? high : low;
        ++events_;
    }
    levels_.emplace(simplex, levels);
    return levels;
}

Pumping::Levels Pumping::star_levels(const Simplex& simplex) {
    Levels levels;
    for_each_face(simplex, [&](const Simplex& face) {
        const Levels own = own_levels(face);
        levels.first = std::max(levels.first, own.first);
        levels.last = std::min(levels.last, own.last);
    });
    return levels;
}

// By induction on dimension: simplices whose faces may all be witnessed, each at some level.
void Pumping::collect_star(const std::vector<Step>& vertices) {
    star_.clear();
    landmarks_->reweigh(largest_ + tie_breaking_);
    const double reach = search_->reach(zeta_);
    const double* p = landmarks_->point(p_);
    for (const Step vertex : vertices) {
        if (landmarks_->distance_squared(vertex, p) > reach * reach) continue;
        if (may_be_witnessed({vertex}) && may_be_witnessed({vertex, p_})) star_.push_back({vertex, p_});
    }
    std::size_t begin = 0;
    for (std::size_t k = 2; k <= landmarks_->dimension(); ++k) {
        const std::size_t end = star_.size();
        for (std::size_t a = begin; a < end; ++a) {
            for (std::size_t b = a + 1; b < end; ++b) {
                if (!std::equal(star_[a].begin(), star_[a].end() - 2, star_[b].begin())) break;
                Simplex simplex(star_[a].begin(), star_[a].end() - 1);
                simplex.push_back(star_[b][k - 2]);
                simplex.push_back(p_);
                bool has_facets = true;
                for (std::size_t j = 0; j <= k && has_facets; ++j) {
                    Simplex facet = simplex;
                    facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(j));
                    const auto known = possible_.find(facet);
                    // A facet without p may be new; one with p has been looked at where its own facets allowed it.
                    has_facets = known != possible_.end() ? known->second : j == k && may_be_witnessed(facet);
                }
                if (has_facets && may_be_witnessed(simplex)) star_.push_back(std::move(simplex));
            }
        }
        begin = end;
    }
}

std::vector<Pumping::Levels> Pumping::without(const std::vector<Levels>& ranges, const Levels& taken) {
    std::vector<Levels> rest;
    for (const Levels& range : ranges) {
        if (taken.first > range.first) rest.push_back({range.first, std::min(range.last, taken.first - 1)});
        if (taken.last < range.last) rest.push_back({std::max(range.first, taken.last + 1), range.last});
    }
    return rest;
}

Pump Pumping::pump(double zeta, double largest, double tie_breaking, const std::vector<Step>& vertices) {
    p_ = landmarks_->size();
    zeta_ = zeta;
    largest_ = largest;
    tie_breaking_ = tie_breaking;
    possible_.clear();
    levels_.clear();
    events_ = 0;
    Pump pump;
    if (!may_be_witnessed({p_})) {
        landmarks_->reweigh(tie_breaking);
        pump.before = pump.after = 0;
        return pump;
    }
    collect_star(vertices);
    std::vector<std::pair<double, Simplex>> flattest_first;
    for (const Simplex& simplex : star_) {
        const double measure = sliver_measure(simplex, *landmarks_, options_.measure);
        if (measure < 1) flattest_first.emplace_back(measure, simplex);
    }
    std::sort(flattest_first.begin(), flattest_first.end());

    // Levels at which p is a vertex and no simplex so far is in its star, as ranges.
    std::vector<Levels> left = {own_levels({p_})};
    bool before_is_known = left.front().first > 0;
    if (before_is_known) pump.before = 0;
    for (std::size_t i = 0; i < flattest_first.size();) {
        // Simplices of one measure together: any level that only they take is as good as the next.
        const double measure = flattest_first[i].first;
        std::vector<Levels> rest = left;
        for (; i < flattest_first.size() && flattest_first[i].first == measure; ++i) {
            const Levels taken = star_levels(flattest_first[i].second);
            if (taken.first > taken.last) continue;
            if (!before_is_known && taken.first == 0) {
                before_is_known = true;
                pump.before = measure;
            }
            rest = without(rest, taken);
        }
        if (rest.empty()) {
            pump.after = measure;
            break;
        }
        left = std::move(rest);
    }
    pump.weight_squared = largest * left.front().first / kLevels;
    pump.events = events_;
    landmarks_->reweigh(pump.weight_squared + tie_breaking);
    return pump;
}

}  // namespace plateau
