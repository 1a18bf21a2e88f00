#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "dilated/weighted_landmarks.h"

namespace plateau {

/// Distance of a point x to the cell of a simplex sigma,
///     V(sigma) = { c : power of p at c <= power of q at c, for p in sigma, q any other landmark } [BGO],
/// a convex polyhedron: the quadratic program min |c - x|, by the dual active-set method of Goldfarb and Idnani. A
/// distance only grows from one active set to the next, so that a search can stop as soon as it is too large.
///
/// Which landmarks bound the cell is not guessed: programs are solved over a pool of landmarks, which gives bounds from
/// below, and a distance that matters is complete only when no landmark at all cuts its point off; who does joins the
/// pool. Distances are computed anew from their active set in sorted order. Only + - * / and square roots.
class CellDistance {
public:
    /// `landmarks` must outlive this.
    explicit CellDistance(const WeightedLandmarks& landmarks) : landmarks_(&landmarks) {}

    /// Takes another simplex: its vertices in ascending order, at most one more than the dimension. Empties the pool.
    void begin(std::span<const Step> simplex);
    /// Puts a landmark into the pool; one that is there, or in the simplex, is passed over.
    void consider(Step landmark);
    /// Whether the landmark is a vertex of the simplex.
    bool has_vertex(Step landmark) const;

    /// Squared distance of x to the cell: exact where it is at most near^2, else a bound from below. The search stops
    /// where it exceeds far >= near. Infinity: the cell is empty. Not a number, and so neither near nor far: rounding
    /// led in circles, which no program has been seen to do.
    double from(const double* x, double near, double far);
    /// The nearest point of the cell, after an exact distance, and the largest power there of a vertex: a new landmark
    /// leaves the distance as it is unless its own power there is less.
    const double* nearest_point() const { return nearest_.data(); }
    double power() const { return power_; }
    std::uint64_t memory() const {
        return sizeof(std::uint32_t) * (pool_.capacity() + seen_.capacity()) + sizeof(double) * relative_.capacity();
    }

private:
    static constexpr std::size_t kMaxActive = kMaxDilatedDimension;
    static constexpr std::size_t kMaxVertices = kMaxDilatedDimension + 1;
    template <std::size_t D>
    struct Program;

    template <std::size_t D>
    double solve(const double* x, double near, double far);

    const WeightedLandmarks* landmarks_;
    std::array<Step, kMaxVertices> simplex_{};
    std::size_t vertices_ = 0;
    std::vector<Step> pool_;
    std::vector<std::uint32_t> seen_;  // by landmark: the stamp of the simplex that has it in its pool or as a vertex
    std::uint32_t stamp_ = 0;
    std::vector<double> relative_;  // of the pool to x, and the power at x: D + 1 numbers each
    std::array<double, kMaxDilatedDimension> nearest_{};
    double power_ = 0;
};

}  // namespace plateau
