#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "complex/link_table.h"
#include "complex/simplex_table.h"
#include "delaunay/delaunay.h"
#include "landmarks/landmark_lists.h"

namespace plateau {

/// The nu-witness complex C_nu^W(L) [GO Def. 3.6], alone or within D(L), under insertion of landmarks, for one or two
/// sequences nu on one record. A simplex of dimension k lives in track t iff it and each of its faces has a witness
/// with all of its vertices among the first nu_k landmarks of its list, and (if `within_delaunay`) it is in D(L).
///
/// Everything born at a step contains the new landmark p, and a witness of it has p in its list. So the witnesses that
/// p entered at its step contain every witness that any simplex with youngest vertex p will ever have; sets of
/// witnesses only shrink; and one watched witness per simplex and track, moved forward along that sequence when it is
/// lost, decides membership.
class NuComplex {
public:
    /// `nu[t]`: nu_0, nu_1, ... of track t; entries beyond the given ones are 0. Simplices up to `max_dimension`.
    NuComplex(std::vector<std::vector<std::uint32_t>> nu, int max_dimension, std::uint32_t witness_count);

    /// Follows one insertion. `lists` after the insertion of p = `step`; `entries` as it returned them; `change` and
    /// `delaunay` of the same insertion, or null for the complex without D(L). Appends births to `tables` (one a
    /// dimension, 1 first) and sets deaths there.
    void insert(Step step, const LandmarkLists& lists, std::span<const ListEntry> entries, const Delaunay* delaunay,
                const DelaunayChange* change, std::vector<SimplexTable>& tables);

    /// Deaths of the last step by (track, dimension, tuple).
    std::span<const Death> deaths() const { return deaths_; }
    /// Candidates of the last step of dimension k: which simplices with p were born, by their other vertices.
    const LinkTable& candidates(int k) const { return links_[static_cast<std::size_t>(k - 1)]; }
    /// Indices in the table of dimension k-1 of the k+1 facets of a simplex of dimension k >= 2; facet j lacks vertex
    /// j.
    std::span<const SimplexIndex> facets(int k, SimplexIndex simplex) const {
        const auto width = static_cast<std::size_t>(k + 1);
        return {books_[static_cast<std::size_t>(k - 1)].facets.data() + simplex * width, width};
    }
    int max_dimension() const { return static_cast<int>(books_.size()); }
    int track_count() const { return static_cast<int>(nu_.size()); }
    /// Bytes held.
    std::uint64_t memory() const;

private:
    struct Watch {
        std::vector<std::uint32_t> cursor;  // place among the entries of the birth step
        std::vector<std::uint32_t> next;    // next simplex watched by the same witness, encoded
    };
    struct Book {                                 // one a dimension
        std::vector<Watch> watch;                 // one a track
        std::vector<SimplexIndex> facets;         // k+1 a simplex, from dimension 2
        std::vector<std::uint32_t> first_coface;  // encoded links into the book of dimension k+1
        std::vector<std::uint32_t> next_coface;   // one a facet link
    };

    std::uint32_t nu(int track, int k) const;
    void fill_star(Step step, const Delaunay& delaunay, const DelaunayChange& change);
    void remove_lost_in_delaunay(Step step, const Delaunay& delaunay, const DelaunayChange& change,
                                 std::vector<SimplexTable>& tables);
    void move_watches(Step step, const LandmarkLists& lists, std::span<const ListEntry> entries,
                      std::vector<SimplexTable>& tables);
    void mark_witnessed(const LandmarkLists& lists, std::span<const ListEntry> entries, bool add_missing);
    void bear(Step step, int k, std::vector<SimplexTable>& tables);
    void kill(Step step, int track, int k, SimplexIndex simplex, std::vector<SimplexTable>& tables);
    void watch(int track, int k, SimplexIndex simplex, Step birth, std::uint32_t cursor);
    bool find_next_witness(const LandmarkLists& lists, int track, int k, SimplexIndex simplex,
                           const SimplexTable& table);

    std::vector<std::vector<std::uint32_t>> nu_;
    std::vector<LinkTable> links_;
    std::vector<Book> books_;
    std::vector<WitnessId> entered_;                         // of all steps, in step order
    std::vector<std::size_t> first_entered_{0, 0};           // [s] = first place of step s
    std::vector<std::vector<std::uint32_t>> first_watched_;  // [track][witness], encoded
    std::vector<Death> deaths_;
};

}  // namespace plateau
