#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/few.h"
#include "complex/simplex_table.h"

namespace plateau {

/// Candidates of one dimension k at one step: the simplices that contain the new landmark p, each named by its other k
/// vertices (ascending steps), that is by a simplex of the link of p. A table that is cleared at every step.
class LinkTable {
public:
    struct Candidate {
        /// Per track: 0-based place, among the entries of this step, of the first one whose witness nu_k-witnesses
        /// the simplex; kNoSimplex when there is none.
        std::array<std::uint32_t, kMaxTracks> first_witness{kNoSimplex, kNoSimplex};
        SimplexIndex simplex = kNoSimplex;  ///< index in the record once it is born
    };

    explicit LinkTable(int width) : width_(static_cast<std::size_t>(width)) { grow(64); }

    void clear() {
        tuples_.clear();
        candidates_.clear();
        ++epoch_;
    }
    std::uint32_t size() const { return static_cast<std::uint32_t>(candidates_.size()); }
    Candidate& operator[](std::uint32_t index) { return candidates_[index]; }
    const Candidate& operator[](std::uint32_t index) const { return candidates_[index]; }
    std::span<const Step> tuple(std::uint32_t index) const { return {tuples_.data() + index * width_, width_}; }

    /// Index of the candidate with these other vertices, or kNoSimplex.
    std::uint32_t find(const Step* tuple) const {
        for (std::size_t slot = hash(tuple) & mask_;; slot = (slot + 1) & mask_) {
            if (slots_[slot].epoch != epoch_) return kNoSimplex;
            if (matches(slots_[slot].index, tuple)) return slots_[slot].index;
        }
    }
    /// The same, adding it when it is new.
    std::uint32_t insert(const Step* tuple) {
        std::size_t slot = hash(tuple) & mask_;
        for (; slots_[slot].epoch == epoch_; slot = (slot + 1) & mask_) {
            if (matches(slots_[slot].index, tuple)) return slots_[slot].index;
        }
        const std::uint32_t index = size();
        slots_[slot] = {epoch_, index};
        tuples_.insert(tuples_.end(), tuple, tuple + width_);
        candidates_.emplace_back();
        if (candidates_.size() * 2 > slots_.size()) grow(slots_.size() * 2);
        return index;
    }

private:
    struct Slot {
        std::uint64_t epoch = 0;
        std::uint32_t index = 0;
    };

    bool matches(std::uint32_t index, const Step* tuple) const {
        return equal_few(tuple, tuples_.data() + index * width_, width_);
    }
    std::size_t hash(const Step* tuple) const {
        std::uint64_t value = 0x9e3779b97f4a7c15ull;
        for (std::size_t i = 0; i < width_; ++i) value = (value ^ tuple[i]) * 0xff51afd7ed558ccdull;
        return static_cast<std::size_t>(value >> 32);
    }
    void grow(std::size_t capacity) {
        slots_.assign(capacity, {});
        mask_ = capacity - 1;
        for (std::uint32_t index = 0; index < size(); ++index) {
            std::size_t slot = hash(tuples_.data() + index * width_) & mask_;
            while (slots_[slot].epoch == epoch_) slot = (slot + 1) & mask_;
            slots_[slot] = {epoch_, index};
        }
    }

    std::size_t width_;
    std::size_t mask_ = 0;
    std::uint64_t epoch_ = 1;
    std::vector<Slot> slots_;
    std::vector<Step> tuples_;
    std::vector<Candidate> candidates_;
};

}  // namespace plateau
