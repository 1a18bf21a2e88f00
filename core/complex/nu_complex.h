#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "complex/delaunay_faces.h"
#include "complex/delaunay_link.h"
#include "complex/link_table.h"
#include "complex/simplex_books.h"
#include "complex/simplex_table.h"
#include "complex/watched_witnesses.h"
#include "delaunay/delaunay.h"
#include "landmarks/landmark_lists.h"

namespace plateau {

/// The nu-witness complex C_nu^W(L) [GO Def. 3.6], alone or within D(L), under insertion of landmarks, for one or two
/// sequences nu on one record. A simplex of dimension k lives in track t iff it and each of its faces has a witness
/// with all of its vertices among the first nu_k landmarks of its list, and (if `within_delaunay`) it is in D(L).
///
/// Everything born at a step contains the new landmark p: within D(L) it is found in the link of p, else in the lists
/// that p entered. What dies lost its last witness, a face, or its place in D(L).
class NuComplex {
public:
    /// `nu[t]`: nu_0, nu_1, ... of track t; entries beyond the given ones are 0. Simplices up to `max_dimension`.
    NuComplex(std::vector<std::vector<std::uint32_t>> nu, int max_dimension, std::uint32_t witness_count);

    /// Follows one insertion. `lists` after the insertion of p = `step`; `entries` as it returned them. Appends births
    /// to `tables` (one a dimension, 1 first) and sets deaths there.
    void insert(Step step, const LandmarkLists& lists, std::span<const ListEntry> entries,
                std::vector<SimplexTable>& tables);
    /// The same within D(L); `delaunay` and `change` of the same insertion.
    void insert(Step step, const LandmarkLists& lists, std::span<const ListEntry> entries, const Delaunay& delaunay,
                const DelaunayChange& change, std::vector<SimplexTable>& tables);

    /// Asks for the entries of a cell that the insertion will touch.
    void expect(CellId cell) const { faces_.expect(cell); }

    /// Deaths of the last step by (track, dimension, tuple).
    std::span<const Death> deaths() const { return deaths_; }
    /// Where the simplices lie in D(L).
    const DelaunayFaces& faces() const { return faces_; }
    /// Which simplex is a facet of which.
    const SimplexBooks& books() const { return books_; }
    /// SimplexBooks::facets().
    std::span<const SimplexIndex> facets(int k, SimplexIndex simplex) const { return books_.facets(k, simplex); }
    int max_dimension() const { return books_.max_dimension(); }
    int track_count() const { return static_cast<int>(nu_.size()); }
    /// Bytes held.
    std::uint64_t memory() const;

private:
    using FirstWitness = DelaunayLink::FirstWitness;
    struct Tables {
        Step step;
        std::vector<SimplexTable>& of_dimension;
        SimplexTable& operator[](int k) { return of_dimension[static_cast<std::size_t>(k - 1)]; }
    };

    std::uint32_t nu(int track, int k) const;
    void begin_step(std::span<const ListEntry> entries);
    void lose_witnesses(const LandmarkLists& lists, std::span<const ListEntry> entries, Tables& tables);
    void end_step(Tables& tables);

    void lose_in_delaunay(const Delaunay& delaunay, const DelaunayChange& change, Tables& tables);
    void mark_link(const LandmarkLists& lists, std::span<const ListEntry> entries);
    void bear_link(Tables& tables);

    void fill_tables(const LandmarkLists& lists, std::span<const ListEntry> entries);
    void bear_tables(int k, Tables& tables);

    SimplexIndex bear(int k, std::span<const Step> others, std::span<const SimplexIndex> facets,
                      const FirstWitness& first_witness, Tables& tables);
    void kill(int track, int k, SimplexIndex simplex, Tables& tables);

    std::vector<std::vector<std::uint32_t>> nu_;
    SimplexBooks books_;
    WatchedWitnesses watches_;
    DelaunayLink link_;
    DelaunayFaces faces_;
    std::vector<LinkTable> candidates_;  // without D(L), one a dimension
    std::vector<Death> deaths_;
    std::vector<std::uint32_t> order_, places_, reach_;  // scratch
};

}  // namespace plateau
