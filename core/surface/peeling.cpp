#include "surface/peeling.h"

#include <algorithm>

#include "delaunay/predicates.h"

namespace plateau {

bool Peeling::update(Step step, const std::vector<SimplexTable>& tables, const NuComplex& complex,
                     std::span<const Death> deaths, const LandmarkPoints& points, bool all, Slice& slice) {
    const Context context{tables[0], tables[1], complex, points};
    switch (stage_) {
        case Stage::Begin:
            begin(step, all, context);
            stage_ = Stage::Births;
            [[fallthrough]];
        case Stage::Births:
            if (!check_certificates(context, slice)) return false;
            bury(deaths, context);
            stage_ = Stage::Deaths;
            [[fallthrough]];
        case Stage::Deaths:
            if (!peel(context, slice)) return false;
            report_changes();
            stage_ = Stage::Begin;
    }
    return true;
}

// Births first, while what dies is still there: else every insertion would tear a hole, peel the surface from its rim
// and put it back. The order does not matter to K.
void Peeling::begin(Step step, bool all, const Context& context) {
    now_ = step;
    touched_.clear();
    first_.resize(context.edges.size(), kEnd);
    blunt_.grow(context.edges.size());
    const std::size_t count = context.triangles.size();
    states_.resize(count);
    next_.grow(3 * count);

    std::vector<SimplexIndex> born;
    const SimplexIndex first_new = all ? 0 : context.triangles.first_of_step[step];
    for (SimplexIndex triangle = first_new; triangle < context.triangles.size(); ++triangle) {
        if (context.triangles.lives(triangle, 0, step) && ratio_allowed(triangle, context)) born.push_back(triangle);
    }
    if (!born.empty()) admit(born, context);
}

void Peeling::bury(std::span<const Death> deaths, const Context& context) {
    for (const Death& death : deaths) {
        if (death.track != 0 || death.dimension != 2 || !states_[death.simplex].present) continue;
        if (kept(death.simplex)) {
            for (const SimplexIndex edge : context.complex.facets(2, death.simplex)) loose_.push_back(edge);
        }
        touch(death.simplex);
        states_[death.simplex].present = false;
    }
}

bool Peeling::ratio_allowed(SimplexIndex triangle, const Context& context) const {
    if (rho_ <= 0) return true;
    const auto tuple = context.triangles.tuple(triangle);
    const LandmarkPoints& points = context.points;
    return !radius_edge_ratio_exceeds(rho_, points[tuple[0]], points[tuple[1]], points[tuple[2]]);
}

// Whether all triangles at the edge, of this round and later, fit in a wedge of at most pi/2. None or one do.
bool Peeling::sharp(SimplexIndex edge, Round from, const Context& context) {
    const auto counts = [&](SimplexIndex triangle) {
        return states_[triangle].present && states_[triangle].round >= from;
    };
    auto& blunt = blunt_[edge];
    if (blunt[0] != kNoSimplex && counts(blunt[0]) && counts(blunt[1])) return false;

    candidates_.clear();
    for_each_at(edge, [&](SimplexIndex triangle, std::uint32_t corner) {
        if (counts(triangle)) candidates_.push_back({triangle, context.triangles.tuple(triangle)[corner]});
    });
    if (candidates_.size() < 2) return true;
    const auto ends = context.edges.tuple(edge);
    const auto u = context.points[ends[0]];
    const auto v = context.points[ends[1]];
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
        const auto third = context.points[candidates_[i].third];
        for (std::size_t j = 0; j < i; ++j) {
            if (sign_of_wedge(u, v, third, context.points[candidates_[j].third]) >= 0) continue;
            blunt = {candidates_[i].triangle, candidates_[j].triangle};
            return false;
        }
    }
    return true;
}

// Removes from K what hangs on sharp edges, from the loose ones on; each edge is a round of its own, the latest so far.
bool Peeling::peel(const Context& context, Slice& slice) {
    while (!loose_.empty()) {
        if (slice.used_up()) return false;
        const SimplexIndex edge = loose_.back();
        loose_.pop_back();
        if (!sharp(edge, kForever, context)) continue;
        ++last_round_;
        for_each_at(edge, [&](SimplexIndex triangle, std::uint32_t corner) {
            if (!kept(triangle)) return;
            set_round(triangle, last_round_);
            states_[triangle].certificate = static_cast<std::uint8_t>(corner);
            for (const SimplexIndex other : context.complex.facets(2, triangle)) loose_.push_back(other);
        });
    }
    return true;
}

void Peeling::admit(std::span<const SimplexIndex> born, const Context& context) {
    ++admission_;
    for (const SimplexIndex triangle : born) {
        touch(triangle);
        states_[triangle].present = true;
        const auto edges = context.complex.facets(2, triangle);
        for (std::uint32_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t link = 3 * triangle + corner;
            next_[link] = first_[edges[corner]];
            first_[edges[corner]] = link;
        }
    }
    for (const SimplexIndex triangle : born) doubt(triangle, kBeforeAll, context);
    for (const SimplexIndex triangle : born) {
        for (const SimplexIndex edge : context.complex.facets(2, triangle)) pass(edge, kBeforeAll, context);
    }
}

bool Peeling::check_certificates(const Context& context, Slice& slice) {
    while (!queue_.empty()) {
        if (slice.used_up()) return false;
        std::pop_heap(queue_.begin(), queue_.end(), std::greater<>());
        const Event event = queue_.back();
        queue_.pop_back();
        if (states_[event.triangle].round != event.round) continue;
        if (event.phase == Event::Check) {
            check(event, context);
        } else {
            for (const SimplexIndex edge : context.complex.facets(2, event.triangle)) pass(edge, event.round, context);
        }
    }
    return true;
}

void Peeling::push(const Event& event) {
    queue_.push_back(event);
    std::push_heap(queue_.begin(), queue_.end(), std::greater<>());
}

// Takes the triangle as kept until a certificate is found; those of its neighbors from that round on may count it now.
void Peeling::doubt(SimplexIndex triangle, Round from, const Context& context) {
    set_round(triangle, kForever);
    states_[triangle].in_doubt = admission_;
    for (const SimplexIndex edge : context.complex.facets(2, triangle)) {
        for_each_at(edge, [&](SimplexIndex at, std::uint32_t) {
            State& neighbor = states_[at];
            if (neighbor.round == kForever || neighbor.round < from) return;
            // Once is enough: what is certified anew has counted all that can still come into doubt.
            if (neighbor.asked == admission_) return;
            neighbor.asked = admission_;
            push({neighbor.round, Event::Check, at});
        });
    }
}

void Peeling::check(const Event& event, const Context& context) {
    State& state = states_[event.triangle];
    const auto edges = context.complex.facets(2, event.triangle);
    for (std::uint32_t tried = 0; tried < 3; ++tried) {
        const std::uint32_t corner = (state.certificate + tried) % 3;
        if (!sharp(edges[corner], event.round, context)) continue;
        state.certificate = static_cast<std::uint8_t>(corner);
        push({event.round, Event::Pass, event.triangle});
        return;
    }
    doubt(event.triangle, event.round, context);
}

// What is gone after this round has left the edge: that may certify what is in doubt.
void Peeling::pass(SimplexIndex edge, Round round, const Context& context) {
    const Round later = round + 1;
    bool any = false;
    for_each_at(edge, [&](SimplexIndex neighbor, std::uint32_t) { any = any || doubtful(neighbor); });
    if (!any || !sharp(edge, later, context)) return;
    for_each_at(edge, [&](SimplexIndex neighbor, std::uint32_t corner) {
        if (!doubtful(neighbor)) return;
        set_round(neighbor, later);
        states_[neighbor].certificate = static_cast<std::uint8_t>(corner);
        push({later, Event::Pass, neighbor});
    });
}

void Peeling::touch(SimplexIndex triangle) {
    State& state = states_[triangle];
    if (state.touched == now_) return;
    state.touched = now_;
    state.was_kept = kept(triangle);
    touched_.push_back(triangle);
}

void Peeling::set_round(SimplexIndex triangle, Round round) {
    touch(triangle);
    states_[triangle].round = round;
    if (round != kForever) last_round_ = std::max(last_round_, round);
}

void Peeling::report_changes() {
    entered_.clear();
    left_.clear();
    for (const SimplexIndex triangle : touched_) {
        const bool was = states_[triangle].was_kept;
        if (kept(triangle) && !was) entered_.push_back(triangle);
        if (!kept(triangle) && was) left_.push_back(triangle);
    }
}

std::uint64_t Peeling::memory() const {
    return blunt_.capacity() * sizeof(blunt_[0]) + states_.capacity() * sizeof(State) +
           (first_.capacity() + next_.capacity()) * sizeof(std::uint32_t);
}

}  // namespace plateau
