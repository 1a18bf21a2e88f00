#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "base/paged_table.h"
#include "base/slice.h"
#include "complex/nu_complex.h"
#include "complex/simplex_table.h"
#include "surface/landmark_points.h"

namespace plateau {

/// Steps 1-3 of the extraction [GO 3.2.2] under insertion: from the triangles of C_nu^W within D(L), without those of
/// too large a radius-edge ratio, the largest set K in which no edge is sharp. An edge is sharp if its triangles fit in
/// a wedge of at most pi/2, a single triangle included; K is unique because a sharp edge stays sharp when triangles go.
///
/// Every triangle has a round: infinite in K, and else such that one of its edges is sharp among the triangles of its
/// own and later rounds. That certifies that it is not in K, and deaths cannot spoil it. A birth can: the triangles
/// around it are checked again in the order of their rounds, and only where a certificate fails the search goes on (as
/// in the maintenance of k-cores by their peeling order).
class Peeling {
public:
    /// `rho`: largest radius-edge ratio allowed; 0 allows all. Follows track 0.
    explicit Peeling(double rho) : rho_(rho) {}

    /// Follows one insertion. `all`: take every living triangle as new (the step at which D(L) became spatial). False
    /// if the slice was used up before the end: call it again, with the same arguments, before anything else is asked.
    bool update(Step step, const std::vector<SimplexTable>& tables, const NuComplex& complex,
                std::span<const Death> deaths, const LandmarkPoints& points, bool all, Slice& slice);

    bool kept(SimplexIndex triangle) const {
        return triangle < states_.size() && states_[triangle].present && states_[triangle].round == kForever;
    }
    /// Triangles that entered or left K at the last step, net.
    std::span<const SimplexIndex> entered() const { return entered_; }
    std::span<const SimplexIndex> left() const { return left_; }

    /// Calls use(triangle, corner) for the triangles of K at the edge; `corner` is the place, in the triangle's tuple,
    /// of the vertex that is not on the edge.
    template <class Use>
    void for_each_kept_at(SimplexIndex edge, const Use& use) const {
        for (std::uint32_t link = first_[edge]; link != kEnd; link = next_[link]) {
            if (kept(link / 3)) use(link / 3, link % 3);
        }
    }
    std::uint64_t memory() const;

private:
    using Round = std::int64_t;
    static constexpr Round kForever = std::numeric_limits<Round>::max();
    static constexpr Round kBeforeAll = std::numeric_limits<Round>::min() / 4;
    static constexpr std::uint32_t kEnd = 0xFFFFFFFFu;
    /// Of a triangle.
    struct State {
        Round round = kForever;
        std::uint32_t in_doubt = 0;    ///< the admission that doubts it
        std::uint32_t asked = 0;       ///< the admission that asked for a check
        Step touched = 0;              ///< the step that may have changed it last
        bool was_kept = false;         ///< before that step
        bool present = false;          ///< lives and is allowed
        std::uint8_t certificate = 0;  ///< corner opposite the edge that was sharp
    };
    struct Context {
        const SimplexTable& edges;
        const SimplexTable& triangles;
        const NuComplex& complex;
        const LandmarkPoints& points;
    };
    /// First all certificates of a round are checked, then what was in doubt is tried without that round.
    struct Event {
        Round round = 0;
        enum Phase : std::uint8_t { Check, Pass } phase = Check;
        SimplexIndex triangle = 0;
        bool operator>(const Event& other) const {
            const Round mine = 2 * round + phase;
            const Round others = 2 * other.round + other.phase;
            return mine != others ? mine > others : triangle > other.triangle;
        }
    };

    bool ratio_allowed(SimplexIndex triangle, const Context& context) const;
    void begin(Step step, bool all, const Context& context);
    void admit(std::span<const SimplexIndex> born, const Context& context);
    bool check_certificates(const Context& context, Slice& slice);
    void bury(std::span<const Death> deaths, const Context& context);
    bool peel(const Context& context, Slice& slice);
    void push(const Event& event);
    void doubt(SimplexIndex triangle, Round from, const Context& context);
    void check(const Event& event, const Context& context);
    void pass(SimplexIndex edge, Round round, const Context& context);
    bool sharp(SimplexIndex edge, Round from, const Context& context);
    bool doubtful(SimplexIndex triangle) const {
        const State& state = states_[triangle];
        return state.in_doubt == admission_ && state.round == kForever && state.present;
    }
    /// Calls use(triangle, corner) for the triangles at the edge that are present; forgets the others.
    template <class Use>
    void for_each_at(SimplexIndex edge, const Use& use) {
        std::uint32_t* link = &first_[edge];
        while (*link != kEnd) {
            if (states_[*link / 3].present) {
                use(*link / 3, *link % 3);
                link = &next_[*link];
            } else {
                *link = next_[*link];
            }
        }
    }
    void set_round(SimplexIndex triangle, Round round);
    void touch(SimplexIndex triangle);
    void report_changes();

    double rho_;
    std::vector<State> states_;             // by triangle
    std::vector<std::uint32_t> first_;      // by edge: list of links, link = 3 * triangle + corner off the edge
    PagedTable<std::uint32_t> next_{kEnd};  // by link
    PagedTable<std::array<SimplexIndex, 2>> blunt_{
        {kNoSimplex, kNoSimplex}};  // by edge: two triangles that last kept it from being sharp
    Round last_round_ = 0;          // the largest finite one
    std::vector<SimplexIndex> entered_, left_;
    std::vector<SimplexIndex> touched_;
    std::vector<SimplexIndex> loose_;  // edges that have lost a triangle of K: some may be sharp now
    enum class Stage : std::uint8_t { Begin, Births, Deaths } stage_ = Stage::Begin;
    Step now_ = 0;
    std::uint32_t admission_ = 0;
    std::vector<Event> queue_;  // a heap, the next event on top
    struct Candidate {
        SimplexIndex triangle;
        Step third;  // the vertex off the edge
    };
    std::vector<Candidate> candidates_;  // scratch of sharp()
};

}  // namespace plateau
