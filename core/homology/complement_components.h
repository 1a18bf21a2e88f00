#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/dynamic_components.h"
#include "complex/delaunay_faces.h"
#include "complex/simplex_table.h"
#include "delaunay/delaunay.h"

namespace plateau {

/// Connected components of what a spatial D(L) leaves around one track of C_nu^W, after every step: the cells whose
/// tetrahedron is not kept, all infinite cells being one, joined through the facets that are not kept.
class ComplementComponents {
public:
    explicit ComplementComponents(int track) : track_(static_cast<std::size_t>(track)) {}

    /// Follows one insertion into a D(L) of dimension 3, after the complex has followed it. `deaths` of this
    /// step.
    void update(Step step, const std::vector<SimplexTable>& tables, std::span<const Death> deaths,
                const Delaunay& delaunay, const DelaunayChange& change, const DelaunayFaces& faces);

    /// Asks for what is known of the cell.
    void expect(CellId cell) const {
        if (cell >= flags_.size()) return;
        prefetch(&flags_[cell]);
        components_.expect(cell + 1);
    }
    std::uint32_t count() const { return components_.count(); }
    std::uint64_t memory() const { return flags_.capacity() + components_.memory(); }

private:
    using Node = DynamicComponents::Node;
    static constexpr Node kOutside = 0;  // the infinite cells; a finite cell is its id + 1
    // Flags of a cell. Bit i: facet i is kept.
    static constexpr std::uint32_t kSolid = 16;
    static constexpr std::uint32_t kInfinite = 32;
    struct Context {
        Step step;
        const std::vector<SimplexTable>& tables;
        const Delaunay& delaunay;
        const DelaunayChange& change;
        const DelaunayFaces& faces;
    };

    bool open(CellId cell, std::size_t facet) const { return (flags_[cell] >> facet & 1u) == 0; }
    bool solid(CellId cell) const { return (flags_[cell] & kSolid) != 0; }
    Node node(CellId cell) const { return (flags_[cell] & kInfinite) != 0 ? kOutside : cell + 1; }
    void remove_died(const Context& context);
    void open_deaths(const Context& context, std::span<const Death> deaths);
    void add_born(const Context& context);

    std::size_t track_;
    bool started_ = false;
    std::vector<std::uint8_t> flags_;  // by cell of D(L)
    DynamicComponents components_{kOutside};
};

}  // namespace plateau
