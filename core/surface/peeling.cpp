#include "surface/peeling.h"

#include <algorithm>

#include "delaunay/predicates.h"

namespace plateau {

void Peeling::update(Step step, const std::vector<SimplexTable>& tables, const NuComplex& complex,
                     std::span<const Death> deaths, const LandmarkPoints& points, bool all) {
    const Context context{tables[0], tables[1], complex, points};
    now_ = step;
    touched_.clear();
    first_.resize(context.edges.size(), kEnd);
    blunt_.resize(context.edges.size(), {kNoSimplex, kNoSimplex});
    const std::size_t count = context.triangles.size();
    round_.resize(count, kForever);
    present_.resize(count, 0);
    next_.resize(3 * count, kEnd);
    was_kept_.resize(count, 0);
    touched_at_.resize(count, 0);
    in_doubt_.resize(count, 0);

    // Births first, while what dies is still there: else every insertion would tear a hole, peel the surface from its
    // rim and put it back. The order does not matter to K.
    std::vector<SimplexIndex> born;
    const SimplexIndex first_new = all ? 0 : context.triangles.first_of_step[step];
    for (SimplexIndex triangle = first_new; triangle < context.triangles.size(); ++triangle) {
        if (context.triangles.lives(triangle, 0, step) && ratio_allowed(triangle, context)) born.push_back(triangle);
    }
    admit(born, context);

    std::vector<SimplexIndex> edges;
    for (const Death& death : deaths) {
        if (death.track != 0 || death.dimension != 2 || present_[death.simplex] == 0) continue;
        if (kept(death.simplex)) {
            for (const SimplexIndex edge : complex.facets(2, death.simplex)) edges.push_back(edge);
        }
        touch(death.simplex);
        present_[death.simplex] = 0;
    }
    peel(edges, context);
    report_changes();
}

bool Peeling::ratio_allowed(SimplexIndex triangle, const Context& context) const {
    if (rho_ <= 0) return true;
    const auto tuple = context.triangles.tuple(triangle);
    const LandmarkPoints& points = context.points;
    return !radius_edge_ratio_exceeds(rho_, points[tuple[0]], points[tuple[1]], points[tuple[2]]);
}

// Whether all triangles at the edge, of this round and later, fit in a wedge of at most pi/2. None or one do.
bool Peeling::sharp(SimplexIndex edge, Round from, const Context& context) {
    const auto counts = [&](SimplexIndex triangle) { return present_[triangle] != 0 && round_[triangle] >= from; };
    auto& blunt = blunt_[edge];
    if (blunt[0] != kNoSimplex && counts(blunt[0]) && counts(blunt[1])) return false;

    links_.clear();
    std::uint32_t* link = &first_[edge];
    while (*link != kEnd) {
        const SimplexIndex triangle = *link / 3;
        if (present_[triangle] == 0) {
            *link = next_[*link];
            continue;
        }
        if (counts(triangle)) links_.push_back(*link);
        link = &next_[*link];
    }
    const auto ends = context.edges.tuple(edge);
    const auto u = context.points[ends[0]];
    const auto v = context.points[ends[1]];
    const auto third = [&](std::uint32_t at) { return context.points[context.triangles.tuple(at / 3)[at % 3]]; };
    for (std::size_t i = 0; i < links_.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (sign_of_wedge(u, v, third(links_[i]), third(links_[j])) >= 0) continue;
            blunt = {links_[i] / 3, links_[j] / 3};
            return false;
        }
    }
    return true;
}

// Removes from K what hangs on sharp edges, from the given edges on; each edge is a round of its own, the latest so
// far.
void Peeling::peel(std::vector<SimplexIndex>& edges, const Context& context) {
    while (!edges.empty()) {
        const SimplexIndex edge = edges.back();
        edges.pop_back();
        if (!sharp(edge, kForever, context)) continue;
        ++last_round_;
        for (std::uint32_t link = first_[edge]; link != kEnd; link = next_[link]) {
            const SimplexIndex triangle = link / 3;
            if (!kept(triangle)) continue;
            set_round(triangle, last_round_);
            for (const SimplexIndex other : context.complex.facets(2, triangle)) edges.push_back(other);
        }
    }
}

void Peeling::admit(std::span<const SimplexIndex> born, const Context& context) {
    if (born.empty()) return;
    ++admission_;
    for (const SimplexIndex triangle : born) {
        touch(triangle);
        present_[triangle] = 1;
        const auto edges = context.complex.facets(2, triangle);
        for (std::uint32_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t link = 3 * triangle + corner;
            next_[link] = first_[edges[corner]];
            first_[edges[corner]] = link;
        }
    }
    Queue queue;
    for (const SimplexIndex triangle : born) doubt(triangle, kBeforeAll, queue, context);
    for (const SimplexIndex triangle : born) pass({kBeforeAll, Event::Pass, triangle}, queue, context);
    while (!queue.empty()) {
        const Event event = queue.top();
        queue.pop();
        if (round_[event.triangle] != event.round) continue;
        if (event.phase == Event::Check) {
            check(event, queue, context);
        } else {
            pass(event, queue, context);
        }
    }
}

// Takes the triangle as kept until a certificate is found; those of its neighbors from that round on may count it now.
void Peeling::doubt(SimplexIndex triangle, Round from, Queue& queue, const Context& context) {
    set_round(triangle, kForever);
    in_doubt_[triangle] = admission_;
    for (const SimplexIndex edge : context.complex.facets(2, triangle)) {
        for (std::uint32_t link = first_[edge]; link != kEnd; link = next_[link]) {
            const SimplexIndex neighbor = link / 3;
            const bool concerned = present_[neighbor] != 0 && round_[neighbor] != kForever && round_[neighbor] >= from;
            if (concerned) queue.push({round_[neighbor], Event::Check, neighbor});
        }
    }
}

void Peeling::check(const Event& event, Queue& queue, const Context& context) {
    for (const SimplexIndex edge : context.complex.facets(2, event.triangle)) {
        if (!sharp(edge, event.round, context)) continue;
        queue.push({event.round, Event::Pass, event.triangle});
        return;
    }
    doubt(event.triangle, event.round, queue, context);
}

// The triangle is gone after its round: edges that it leaves may certify what is in doubt.
void Peeling::pass(const Event& event, Queue& queue, const Context& context) {
    const Round later = event.round + 1;
    for (const SimplexIndex edge : context.complex.facets(2, event.triangle)) {
        bool doubtful = false;
        for (std::uint32_t link = first_[edge]; link != kEnd; link = next_[link]) {
            doubtful = doubtful || (kept(link / 3) && in_doubt_[link / 3] == admission_);
        }
        if (!doubtful || !sharp(edge, later, context)) continue;
        for (std::uint32_t link = first_[edge]; link != kEnd; link = next_[link]) {
            const SimplexIndex neighbor = link / 3;
            if (!kept(neighbor) || in_doubt_[neighbor] != admission_) continue;
            set_round(neighbor, later);
            queue.push({later, Event::Pass, neighbor});
        }
    }
}

void Peeling::touch(SimplexIndex triangle) {
    if (touched_at_[triangle] == now_) return;
    touched_at_[triangle] = now_;
    was_kept_[triangle] = kept(triangle) ? 1 : 0;
    touched_.push_back(triangle);
}

void Peeling::set_round(SimplexIndex triangle, Round round) {
    touch(triangle);
    round_[triangle] = round;
    if (round != kForever) last_round_ = std::max(last_round_, round);
}

void Peeling::report_changes() {
    entered_.clear();
    left_.clear();
    for (const SimplexIndex triangle : touched_) {
        if (kept(triangle) && was_kept_[triangle] == 0) entered_.push_back(triangle);
        if (!kept(triangle) && was_kept_[triangle] != 0) left_.push_back(triangle);
    }
}

std::uint64_t Peeling::memory() const {
    return blunt_.capacity() * sizeof(blunt_[0]) +
           round_.capacity() * (sizeof(Round) + 2 + sizeof(Step) + sizeof(std::uint32_t)) +
           (first_.capacity() + next_.capacity()) * sizeof(std::uint32_t);
}

}  // namespace plateau
