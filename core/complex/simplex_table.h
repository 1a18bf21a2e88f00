#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace plateau {

/// A step of the run, 1-based. A landmark is named by the step that inserted it, everywhere.
using Step = std::uint32_t;
/// Later than every step: the death of what still lives.
inline constexpr Step kNever = 0xFFFFFFFFu;
/// Index of a simplex in the table of its dimension, 0-based.
using SimplexIndex = std::uint32_t;
inline constexpr SimplexIndex kNoSimplex = 0xFFFFFFFFu;

/// Two complexes can be followed on one record; each has its own death (DESIGN "one record, two deaths").
/// Family `auto`: track 0 is C_nu with nu = (1,6,6,4), from which the surface is extracted, track 1 is C_(1,2,3,4).
/// All other families use track 0 alone.
inline constexpr int kMaxTracks = 2;

/// All simplices of one dimension k >= 1 that were ever in the complex, in order of (birth, vertex tuple).
/// Vertices are steps in ascending order, so the last vertex is the youngest and its step is the birth.
/// A simplex is in the complex of track t at step i exactly for birth <= i < death[t]; a simplex that track t never
/// held has death[t] == birth.
struct SimplexTable {
    int dimension = 1;
    std::vector<Step> vertices;                        ///< (k+1) steps a simplex, ascending
    std::array<std::vector<Step>, kMaxTracks> death;   ///< one a simplex and track in use
    std::vector<SimplexIndex> first_of_step = {0, 0};  ///< [s] = first simplex with birth >= s; s = 0 .. steps + 1

    SimplexIndex size() const {
        return static_cast<SimplexIndex>(vertices.size() / static_cast<std::size_t>(dimension + 1));
    }
    std::span<const Step> tuple(SimplexIndex index) const {
        const auto width = static_cast<std::size_t>(dimension + 1);
        return {vertices.data() + index * width, width};
    }
    Step birth(SimplexIndex index) const {
        return vertices[(static_cast<std::size_t>(index) + 1) * static_cast<std::size_t>(dimension + 1) - 1];
    }
    bool lives(SimplexIndex index, int track, Step step) const {
        return birth(index) <= step && step < death[static_cast<std::size_t>(track)][index];
    }
    /// The simplex with this ascending vertex tuple, or kNoSimplex. Cost: O(log(births of one step)).
    SimplexIndex find(std::span<const Step> tuple) const;
};

/// A death in one track.
struct Death {
    std::uint8_t track = 0;
    std::uint8_t dimension = 1;
    SimplexIndex simplex = 0;
};

}  // namespace plateau
