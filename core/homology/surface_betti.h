#pragma once

#include <array>
#include <cstdint>

#include "base/dynamic_components.h"
#include "surface/surface_tracker.h"

namespace plateau {

/// Betti numbers of the extracted surface at every step. It is closed, so beta_0 = beta_2 = its components and
/// beta_1 = 2 beta_0 - chi.
class SurfaceBetti {
public:
    /// Follows one step of the tracker. `rows` is the number of rows so far.
    void update(const SurfaceTracker& surface, std::uint32_t rows);

    /// beta_0, beta_1, beta_2 after the last step; 0, 0, 0 where the surface is empty.
    std::array<std::uint32_t, 3> numbers() const { return {components_.count(), beta1_, components_.count()}; }
    std::uint64_t memory() const { return components_.memory(); }

private:
    DynamicComponents components_;  // nodes: rows; edges: what is glued
    std::uint32_t rows_ = 0;
    std::uint32_t beta1_ = 0;
};

}  // namespace plateau
