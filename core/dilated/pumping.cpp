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

std::optional<bool> Pumping::is_witnessed(std::span<const Step> simplex, std::uint32_t level, Slice& slice) {
    if (slice.used_up(WitnessSearch::kUnits)) return std::nullopt;
    landmarks_->reweigh(largest_ * level / kLevels + tie_breaking_);
    const bool result = search_->find(simplex, zeta_, landmarks_->point(p_)).has_value();
    slice.charge(search_->looked_at());
    return result;
}

// At the level that suits it best: the highest with p, the lowest without.
std::optional<bool> Pumping::may_be_witnessed(const Simplex& simplex, Slice& slice) {
    const auto known = possible_.find(simplex);
    if (known != possible_.end()) return known->second;
    const auto result = is_witnessed(simplex, simplex.back() == p_ ? kLevels : 0, slice);
    if (result) possible_.emplace(simplex, *result);
    return result;
}

// Of a simplex that may be witnessed, its faces aside.
std::optional<Pumping::Levels> Pumping::own_levels(const Simplex& simplex, Slice& slice) {
    const auto known = levels_.find(simplex);
    if (known != levels_.end()) return known->second;
    const bool has_p = simplex.back() == p_;
    if (!halving_) {
        const auto always = is_witnessed(simplex, has_p ? 0 : kLevels, slice);
        if (!always) return std::nullopt;
        if (*always) return levels_.emplace(simplex, Levels()).first->second;
        halving_ = Levels{0, kLevels};
    }
    while (halving_->last - halving_->first > 1) {
        const std::uint32_t middle = halving_->first + (halving_->last - halving_->first) / 2;
        const auto here = is_witnessed(simplex, middle, slice);
        if (!here) return std::nullopt;
        (*here == has_p ? halving_->last : halving_->first) = middle;
    }
    Levels levels;
    (has_p ? levels.first : levels.last) = has_p ? halving_->last : halving_->first;
    halving_.reset();
    ++pump_.thresholds;
    levels_.emplace(simplex, levels);
    return levels;
}

std::optional<Pumping::Levels> Pumping::star_levels(const Simplex& simplex, Slice& slice) {
    Levels levels;
    bool complete = true;
    for_each_face(simplex, [&](const Simplex& face) {
        const auto own = complete ? own_levels(face, slice) : std::nullopt;
        complete = own.has_value();
        if (!own) return;
        levels.first = std::max(levels.first, own->first);
        levels.last = std::min(levels.last, own->last);
    });
    if (!complete) return std::nullopt;
    return levels;
}

bool Pumping::collect_edges(Slice& slice) {
    for (; next_ + 1 < p_; ++next_) {
        const auto vertex = static_cast<Step>(next_ + 1);
        if (landmarks_->distance_squared(vertex, landmarks_->point(p_)) > reach_ * reach_) continue;
        const auto alone = may_be_witnessed({vertex}, slice);
        if (!alone) return false;
        const auto joined = *alone ? may_be_witnessed({vertex, p_}, slice) : false;
        if (!joined) return false;
        if (*joined) star_.push_back({vertex, p_});
    }
    return true;
}

// Whether the faces of a simplex with p may all be witnessed, and the simplex itself, each at some level.
std::optional<bool> Pumping::may_be_in_star(const Simplex& simplex, Slice& slice) {
    const std::size_t k = simplex.size() - 1;
    for (std::size_t j = 0; j <= k; ++j) {
        Simplex facet = simplex;
        facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(j));
        const auto known = possible_.find(facet);
        std::optional<bool> has_facet = known != possible_.end() && known->second;
        // A facet without p may be new; one with p has been looked at where its own facets allowed it.
        if (known == possible_.end() && j == k) has_facet = may_be_witnessed(facet, slice);
        if (!has_facet) return std::nullopt;
        if (!*has_facet) return false;
    }
    return may_be_witnessed(simplex, slice);
}

// By induction on dimension.
bool Pumping::collect_star(Slice& slice) {
    for (; dimension_ <= landmarks_->dimension(); ++dimension_) {
        for (; next_ < end_; ++next_) {
            for (partner_ = std::max(partner_, next_ + 1); partner_ < end_; ++partner_) {
                const Simplex& a = star_[next_];
                const Simplex& b = star_[partner_];
                if (!std::equal(a.begin(), a.end() - 2, b.begin())) break;
                if (slice.used_up()) return false;
                Simplex simplex(a.begin(), a.end() - 1);
                simplex.push_back(b[dimension_ - 2]);
                simplex.push_back(p_);
                const auto may_be = may_be_in_star(simplex, slice);
                if (!may_be) return false;
                if (*may_be) star_.push_back(std::move(simplex));
            }
            partner_ = 0;
        }
        next_ = end_;
        end_ = star_.size();
    }
    return true;
}

void Pumping::sort_star() {
    for (const Simplex& simplex : star_) {
        const double measure = sliver_measure(simplex, *landmarks_, options_.measure);
        if (measure < 1) flattest_first_.emplace_back(measure, simplex);
    }
    std::sort(flattest_first_.begin(), flattest_first_.end());
}

std::vector<Pumping::Levels> Pumping::without(const std::vector<Levels>& ranges, const Levels& taken) {
    std::vector<Levels> rest;
    for (const Levels& range : ranges) {
        if (taken.first > range.first) rest.push_back({range.first, std::min(range.last, taken.first - 1)});
        if (taken.last < range.last) rest.push_back({std::max(range.first, taken.last + 1), range.last});
    }
    return rest;
}

void Pumping::begin(double zeta, double largest) {
    p_ = landmarks_->size();
    zeta_ = zeta;
    largest_ = largest;
    tie_breaking_ = landmarks_->weight_squared(p_);
}

bool Pumping::advance(Slice& slice) {
    if (phase_ == Phase::Begin) {
        const auto may_be_vertex = may_be_witnessed({p_}, slice);
        if (!may_be_vertex) return false;
        landmarks_->reweigh(largest_ + tie_breaking_);
        reach_ = search_->reach(zeta_);
        phase_ = Phase::Edges;
        if (!*may_be_vertex) {
            pump_.before = pump_.after = 0;
            phase_ = Phase::Done;
        }
    }
    if (phase_ == Phase::Edges) {
        if (!collect_edges(slice)) return false;
        next_ = 0;
        end_ = star_.size();
        phase_ = Phase::Star;
    }
    if (phase_ == Phase::Star) {
        if (!collect_star(slice)) return false;
        sort_star();
        next_ = 0;
        phase_ = Phase::Vertex;
    }
    if (phase_ == Phase::Vertex) {
        const auto own = own_levels({p_}, slice);
        if (!own) return false;
        left_ = {*own};
        before_is_known_ = own->first > 0;
        if (before_is_known_) pump_.before = 0;
        phase_ = Phase::Choice;
    }
    if (phase_ == Phase::Choice) {
        if (!choose(slice)) return false;
        pump_.weight_squared = largest_ * left_.front().first / kLevels;
        phase_ = Phase::Done;
    }
    landmarks_->reweigh(pump_.weight_squared + tie_breaking_);
    return true;
}

bool Pumping::choose(Slice& slice) {
    while (next_ < flattest_first_.size()) {
        // Simplices of one measure together: any level that only they take is as good as the next.
        const double measure = flattest_first_[next_].first;
        std::vector<Levels> rest = left_;
        bool enters_at_zero = false;
        std::size_t i = next_;
        for (; i < flattest_first_.size() && flattest_first_[i].first == measure; ++i) {
            const auto taken = star_levels(flattest_first_[i].second, slice);
            if (!taken) return false;
            if (taken->first > taken->last) continue;
            enters_at_zero = enters_at_zero || taken->first == 0;
            rest = without(rest, *taken);
        }
        if (enters_at_zero && !before_is_known_) {
            before_is_known_ = true;
            pump_.before = measure;
        }
        if (rest.empty()) {
            pump_.after = measure;
            break;
        }
        left_ = std::move(rest);
        next_ = i;
    }
    return true;
}

}  // namespace plateau
