#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/part_search.h"
#include "homology/component_labels.h"
#include "surface/surface_tracker.h"

namespace plateau {

/// Betti numbers of the extracted surface at every step. It is closed, so beta_0 = beta_2 = its components and
/// beta_1 = 2 beta_0 - chi.
class SurfaceBetti {
public:
    /// Follows one step of the tracker. `rows` is the number of rows so far. Cost: about the rows that came and went,
    /// and the pieces that came off.
    void update(const SurfaceTracker& surface, std::uint32_t rows);

    /// beta_0, beta_1, beta_2 after the last step; 0, 0, 0 where the surface is empty.
    std::array<std::uint32_t, 3> numbers() const { return {labels_.count(), beta1_, labels_.count()}; }
    std::uint64_t memory() const;

private:
    ComponentLabels labels_;
    std::vector<ComponentLabels::Label> label_;  // by row; none once it has ended
    std::vector<std::uint32_t> suspects_;
    PartSearch search_;
    std::uint32_t beta1_ = 0;
};

}  // namespace plateau
