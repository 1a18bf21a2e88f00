#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "complex/delaunay_faces.h"
#include "complex/simplex_table.h"
#include "delaunay/delaunay.h"
#include "homology/complement_components.h"
#include "homology/simplex_counts.h"
#include "homology/skeleton_components.h"

namespace plateau {

/// Betti numbers of one track of C_nu^W within D(L), at every step, without matrices: the complex is embedded, so
/// beta_0 counts the components of its edges, beta_2 the bounded components of its complement in the dual graph of D(L)
/// (Alexander duality), and beta_1 follows from the Euler characteristic. While D(L) is flat beta_2 is 0.
class EmbeddedBetti {
public:
    explicit EmbeddedBetti(int track) : counts_(track, 3), skeleton_(track), complement_(track) {}

    /// Follows one insertion, after the complex has followed it. `deaths` of this step.
    void update(Step step, const std::vector<SimplexTable>& tables, std::span<const Death> deaths,
                const Delaunay& delaunay, const DelaunayChange& change, const DelaunayFaces& faces);

    /// Asks for what is known of the cell.
    void expect(CellId cell) const { complement_.expect(cell); }
    /// beta_0, beta_1, beta_2 after the last step.
    std::array<std::uint32_t, 3> numbers() const;
    std::uint64_t memory() const { return skeleton_.memory() + complement_.memory(); }

private:
    int dimension_ = 0;  // of D(L)
    SimplexCounts counts_;
    SkeletonComponents skeleton_;
    ComplementComponents complement_;
};

}  // namespace plateau
