#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "complex/simplex_table.h"
#include "dilated/pumping.h"

namespace plateau {

/// Which complex is followed (DESIGN.md, families).
enum class Family : std::uint8_t {
    Witness = 0,   ///< C_nu^W(L), without the Delaunay triangulation
    Delaunay = 1,  ///< C_nu^W(L) within D(L)
    Surface = 2,   ///< the surface extracted from C_nu^W within D(L)
    Auto = 3,      ///< surface where it is not empty, else C_(1,2,3,4)^W within D(L)
    Dilated = 4,   ///< the weighted witness complex with dilated witnesses [BGO]
};

/// Whether the complex is followed within the Delaunay triangulation.
inline bool is_within_delaunay(Family family) {
    return family != Family::Witness && family != Family::Dilated;
}

/// One triangle of the extracted surface over a run of steps: a facet seen from one outer side.
/// The same (triangle, side) can come back later as a new row.
struct SurfaceRow {
    SimplexIndex triangle = 0;  ///< in the triangle table
    std::uint8_t side = 0;      ///< 0: the outer side is where (v0,v1,v2) turn counter-clockwise; 1: the other
    Step from = 0;
    Step to = kNever;  ///< in the surface at step i exactly for from <= i < to
};

/// A landmark that is no vertex: none of its cell is near a witness, because of its neighbors' weights.
struct HiddenLandmark {
    Step landmark = 0;
    Step from = 0;  ///< no vertex from this step on, its own or a later one
};

/// The append-only record of a run: everything any step needs, as lifespans, for steps 1 .. step_count.
struct Timeline {
    /// Largest dimension of a simplex, and the number of Betti numbers: that of the cloud unless the run was asked for
    /// others.
    std::uint32_t dimension = 0;
    Family family = Family::Auto;
    int track_count = 1;
    Step step_count = 0;

    std::vector<std::uint32_t> landmarks;          ///< [step-1] = 0-based input index
    std::vector<double> epsilons;                  ///< [step-1] = epsilon(step), input units, non-increasing
    std::vector<std::uint8_t> delaunay_dimension;  ///< [step-1] = dimension m of D(L); 0 for families without it
    std::vector<SimplexTable> simplices;           ///< [k-1] = table of dimension k, k = 1 .. dimension

    std::vector<double> weights_squared;  ///< [step-1] = omega(p)^2, input units squared; family dilated
    std::vector<Pump> pumps;              ///< [step-1]; family dilated where it pumps
    std::vector<HiddenLandmark> hidden;   ///< in the order of (from, landmark); family dilated

    std::vector<Death> deaths;  ///< in step order; within a step by (track, dimension, tuple)
    std::vector<std::size_t> first_death_of_step = {0, 0};  ///< [s] = first death at step >= s

    std::vector<SurfaceRow> surface;        ///< families surface and auto, in 3d
    std::vector<std::uint32_t> ended_rows;  ///< rows in the order in which they ended
    std::vector<std::size_t> first_ended_row_of_step = {0, 0};
    std::vector<std::uint32_t> first_row_of_step = {0, 0};

    std::vector<Family> shown_family;  ///< [step-1]; never Auto
    std::vector<std::uint32_t> betti;  ///< `dimension` numbers a step: beta_0 .. beta_{d-1}
    /// Complexes that are not embedded can have torsion: then the numbers over another field differ from `betti`.
    std::uint32_t other_field = 0;           ///< a prime; 0: the complex is embedded, or numbers over it are not known
    std::vector<std::uint32_t> other_betti;  ///< over Z/other_field, as many as `betti`; else empty

    double epsilon(Step step) const { return epsilons[step - 1]; }
    std::span<const std::uint32_t> betti_at(Step step) const {
        return {betti.data() + static_cast<std::size_t>(step - 1) * dimension, dimension};
    }
    std::span<const std::uint32_t> other_betti_at(Step step) const {
        return {other_betti.data() + static_cast<std::size_t>(step - 1) * dimension, dimension};
    }
    const SimplexTable& table(int dim) const { return simplices[static_cast<std::size_t>(dim - 1)]; }
    /// The track that the family shown at the step belongs to.
    int shown_track(Step step) const {
        return family == Family::Auto && shown_family[step - 1] == Family::Delaunay ? 1 : 0;
    }
    /// All simplices of dimension dim >= 1 that live at the step in the track. Cost: O(births so far).
    std::vector<SimplexIndex> living(int dim, int track, Step step) const;
    /// Rows of the surface at the step. Cost: O(rows so far).
    std::vector<std::uint32_t> surface_rows(Step step) const;
};

}  // namespace plateau
