#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "complex/nu_complex.h"
#include "complex/simplex_table.h"
#include "surface/landmark_points.h"

namespace plateau {

/// Steps 1-3 of the extraction [GO 3.2.2] under insertion: from the triangles of C_nu^W within D(L), without those of
/// too large a radius-edge ratio, the largest set K in which no edge is sharp. An edge is sharp if its triangles fit in
/// a wedge of at most pi/2, a single triangle included; K is unique because a sharp edge stays sharp when triangles go.
///
/// Deaths peel from their edges on. A birth can revive only triangles that are connected to it by edges, so the search
/// starts there and asks for a peeled neighbor only where an edge would be sharp without it.
class Peeling {
public:
    /// `rho`: largest radius-edge ratio allowed; 0 allows all. Follows track 0.
    explicit Peeling(double rho) : rho_(rho) {}

    /// Follows one insertion. `all`: take every living triangle as new (the step at which D(L) became spatial).
    void update(Step step, const std::vector<SimplexTable>& tables, const NuComplex& complex,
                std::span<const Death> deaths, const LandmarkPoints& points, bool all);

    bool kept(SimplexIndex triangle) const { return triangle < state_.size() && state_[triangle] == State::Kept; }
    /// Triangles that entered or left K at the last step, net.
    std::span<const SimplexIndex> entered() const { return entered_; }
    std::span<const SimplexIndex> left() const { return left_; }

    /// Calls use(triangle, corner) for the triangles of K at the edge; `corner` is the place, in the triangle's tuple,
    /// of the vertex that is not on the edge.
    template <class Use>
    void for_each_kept_at(SimplexIndex edge, const Use& use) const {
        for (std::uint32_t link = first_[edge]; link != kEnd; link = next_[link]) {
            if (state_[link / 3] == State::Kept) use(link / 3, link % 3);
        }
    }
    std::uint64_t memory() const;

private:
    static constexpr std::uint32_t kEnd = 0xFFFFFFFFu;
    enum class State : std::uint8_t { Absent, Peeled, Kept };
    struct Context {
        const SimplexTable& edges;
        const SimplexTable& triangles;
        const NuComplex& complex;
        const LandmarkPoints& points;
    };

    void admit(SimplexIndex triangle, const Context& context);
    bool ratio_allowed(SimplexIndex triangle, const Context& context) const;
    void peel(std::vector<SimplexIndex>& queue, const Context& context);
    void revive(SimplexIndex seed, const Context& context, std::vector<SimplexIndex>& seeds);
    template <class Include>
    bool sharp(SimplexIndex edge, const Context& context, const Include& include);
    void set_state(SimplexIndex triangle, State state);
    void report_changes();

    double rho_;
    std::vector<State> state_;          // by triangle
    std::vector<std::uint32_t> first_;  // by edge: list of links, link = 3 * triangle + corner off the edge
    std::vector<std::uint32_t> next_;   // by link
    std::vector<SimplexIndex> entered_, left_;

    std::vector<std::uint8_t> was_kept_;  // by triangle, for those touched at this step
    std::vector<Step> touched_at_, doomed_at_, asked_at_;
    std::vector<SimplexIndex> touched_;
    Step now_ = 0;
    std::uint32_t search_ = 0;
    std::vector<Step> third_;  // scratch of sharp()
};

}  // namespace plateau
