#include "surface/peeling.h"

#include "delaunay/predicates.h"

namespace plateau {

void Peeling::update(Step step, const std::vector<SimplexTable>& tables, const NuComplex& complex,
                     std::span<const Death> deaths, const LandmarkPoints& points, bool all) {
    const Context context{tables[0], tables[1], complex, points};
    now_ = step;
    touched_.clear();
    first_.resize(context.edges.size(), kEnd);
    state_.resize(context.triangles.size(), State::Absent);
    next_.resize(3 * state_.size(), kEnd);
    was_kept_.resize(state_.size(), 0);
    touched_at_.resize(state_.size(), 0);
    doomed_at_.resize(state_.size(), 0);
    asked_at_.resize(state_.size(), 0);

    std::vector<SimplexIndex> queue;
    for (const Death& death : deaths) {
        if (death.track != 0 || death.dimension != 2 || state_[death.simplex] == State::Absent) continue;
        if (state_[death.simplex] == State::Kept) {
            for (const SimplexIndex edge : complex.facets(2, death.simplex)) queue.push_back(edge);
        }
        set_state(death.simplex, State::Absent);
    }
    peel(queue, context);

    std::vector<SimplexIndex> seeds;
    const SimplexIndex first_new = all ? 0 : context.triangles.first_of_step[step];
    for (SimplexIndex triangle = first_new; triangle < context.triangles.size(); ++triangle) {
        if (!context.triangles.lives(triangle, 0, step) || !ratio_allowed(triangle, context)) continue;
        admit(triangle, context);
        seeds.push_back(triangle);
    }
    for (std::size_t i = 0; i < seeds.size(); ++i) revive(seeds[i], context, seeds);
    report_changes();
}

void Peeling::admit(SimplexIndex triangle, const Context& context) {
    set_state(triangle, State::Peeled);
    const auto edges = context.complex.facets(2, triangle);
    for (std::uint32_t corner = 0; corner < 3; ++corner) {
        const std::uint32_t link = 3 * triangle + corner;
        next_[link] = first_[edges[corner]];
        first_[edges[corner]] = link;
    }
}

// R / (shortest edge) <= rho, squared and without a division: R = |a||b||c| / (2 |a x b|).
bool Peeling::ratio_allowed(SimplexIndex triangle, const Context& context) const {
    if (rho_ <= 0) return true;
    const auto tuple = context.triangles.tuple(triangle);
    const auto p = context.points[tuple[0]];
    const auto q = context.points[tuple[1]];
    const auto r = context.points[tuple[2]];
    const double pq = distance_squared(p, q);
    const double pr = distance_squared(p, r);
    const double qr = distance_squared(q, r);
    double cross_squared = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const double minor = (q[i] - p[i]) * (r[j] - p[j]) - (q[j] - p[j]) * (r[i] - p[i]);
        cross_squared += minor * minor;
    }
    double shortest = pq < pr ? pq : pr;
    shortest = qr < shortest ? qr : shortest;
    return pq * pr * qr <= 4 * rho_ * rho_ * shortest * cross_squared;
}

template <class Include>
bool Peeling::sharp(SimplexIndex edge, const Context& context, const Include& include) {
    third_.clear();
    std::uint32_t* link = &first_[edge];
    while (*link != kEnd) {
        const SimplexIndex triangle = *link / 3;
        if (state_[triangle] == State::Absent) {
            *link = next_[*link];
            continue;
        }
        if (include(triangle)) third_.push_back(context.triangles.tuple(triangle)[*link % 3]);
        link = &next_[*link];
    }
    const auto ends = context.edges.tuple(edge);
    const auto u = context.points[ends[0]];
    const auto v = context.points[ends[1]];
    for (std::size_t i = 0; i < third_.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (sign_of_wedge(u, v, context.points[third_[i]], context.points[third_[j]]) < 0) return false;
        }
    }
    return true;
}

void Peeling::peel(std::vector<SimplexIndex>& queue, const Context& context) {
    while (!queue.empty()) {
        const SimplexIndex edge = queue.back();
        queue.pop_back();
        if (!sharp(edge, context, [&](SimplexIndex t) { return state_[t] == State::Kept; })) continue;
        for (std::uint32_t link = first_[edge]; link != kEnd; link = next_[link]) {
            const SimplexIndex triangle = link / 3;
            if (state_[triangle] != State::Kept) continue;
            set_state(triangle, State::Peeled);
            for (const SimplexIndex other : context.complex.facets(2, triangle)) queue.push_back(other);
        }
    }
}

// Tries to keep `seed` together with the peeled triangles that its edges ask for. What is doomed here has an edge that
// is sharp among all that could be kept, so it stays doomed for the rest of the step.
void Peeling::revive(SimplexIndex seed, const Context& context, std::vector<SimplexIndex>& seeds) {
    if (state_[seed] != State::Peeled || doomed_at_[seed] == now_) return;
    const std::uint32_t search = ++search_;
    const auto asked = [&](SimplexIndex t) { return asked_at_[t] == search && doomed_at_[t] != now_; };
    std::vector<SimplexIndex> group;
    std::vector<SimplexIndex> queue;
    const auto ask = [&](SimplexIndex triangle) {
        asked_at_[triangle] = search;
        group.push_back(triangle);
        for (const SimplexIndex edge : context.complex.facets(2, triangle)) queue.push_back(edge);
    };
    ask(seed);
    while (!queue.empty() && doomed_at_[seed] != now_) {
        const SimplexIndex edge = queue.back();
        queue.pop_back();
        if (!sharp(edge, context, [&](SimplexIndex t) { return state_[t] == State::Kept || asked(t); })) continue;
        bool grew = false;
        for (std::uint32_t link = first_[edge]; link != kEnd; link = next_[link]) {
            const SimplexIndex triangle = link / 3;
            const bool fresh = state_[triangle] == State::Peeled && asked_at_[triangle] != search;
            if (!fresh || doomed_at_[triangle] == now_) continue;
            ask(triangle);
            grew = true;
        }
        if (grew) {
            queue.push_back(edge);
            continue;
        }
        for (std::uint32_t link = first_[edge]; link != kEnd; link = next_[link]) {
            const SimplexIndex triangle = link / 3;
            if (!asked(triangle)) continue;
            doomed_at_[triangle] = now_;
            for (const SimplexIndex other : context.complex.facets(2, triangle)) queue.push_back(other);
        }
    }
    if (doomed_at_[seed] == now_) return;
    for (const SimplexIndex triangle : group) {
        if (doomed_at_[triangle] != now_) set_state(triangle, State::Kept);
    }
    for (const SimplexIndex triangle : group) {
        if (state_[triangle] != State::Kept) continue;
        for (const SimplexIndex edge : context.complex.facets(2, triangle)) {
            for (std::uint32_t link = first_[edge]; link != kEnd; link = next_[link]) {
                const SimplexIndex neighbor = link / 3;
                if (state_[neighbor] == State::Peeled && doomed_at_[neighbor] != now_) seeds.push_back(neighbor);
            }
        }
    }
}

void Peeling::set_state(SimplexIndex triangle, State state) {
    if (touched_at_[triangle] != now_) {
        touched_at_[triangle] = now_;
        was_kept_[triangle] = state_[triangle] == State::Kept ? 1 : 0;
        touched_.push_back(triangle);
    }
    state_[triangle] = state;
}

void Peeling::report_changes() {
    entered_.clear();
    left_.clear();
    for (const SimplexIndex triangle : touched_) {
        const bool is_kept = state_[triangle] == State::Kept;
        if (is_kept && was_kept_[triangle] == 0) entered_.push_back(triangle);
        if (!is_kept && was_kept_[triangle] != 0) left_.push_back(triangle);
    }
}

std::uint64_t Peeling::memory() const {
    return state_.capacity() * (2 * sizeof(State) + 3 * sizeof(Step)) +
           (first_.capacity() + next_.capacity()) * sizeof(std::uint32_t);
}

}  // namespace plateau
