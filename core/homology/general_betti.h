#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/slice.h"
#include "complex/simplex_books.h"
#include "complex/simplex_table.h"
#include "homology/cycle_space.h"
#include "homology/simplex_counts.h"
#include "homology/skeleton_components.h"

namespace plateau {

/// Betti numbers over Z/p, for one or several primes p, of track 0 of a complex that need not be embedded, at every
/// step, from the numbers of its simplices and of its cycles: beta_k = dim Z_k - dim B_k, where dim B_k = (number of
/// (k+1)-simplices) - dim Z_(k+1). Z_0 holds all vertices, and dim B_0 = vertices -
/// components; a hidden landmark is a component of no vertex.
class GeneralBetti {
public:
    /// beta_0 .. beta_{count-1}, of simplices up to dimension `count`; every prime at most 46337.
    GeneralBetti(int count, std::span<const std::uint32_t> primes);

    /// Follows one insertion, after the complex has followed it. `hidden`: see SimplexCounts. False where the slice is
    /// used up: then it is to be called again with the same arguments, until it is true, and goes on where it was.
    bool update(Step step, const std::vector<SimplexTable>& tables, const SimplexBooks& books,
                std::span<const Death> deaths, std::span<const Step> hidden, Slice& slice);

    /// Over the prime of this 0-based index.
    std::vector<std::uint32_t> numbers(std::size_t field) const;
    std::uint64_t memory() const;

private:
    SkeletonComponents skeleton_;
    SimplexCounts simplices_;
    std::uint32_t hidden_ = 0;        // landmarks that are no vertices
    std::vector<CycleSpace> cycles_;  // of dimension 2, 3, ...
    bool is_counted_ = false;         // an update is through with all but the cycles
    std::size_t next_ = 0;            // of them
};

}  // namespace plateau
