#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/paged_table.h"
#include "complex/simplex_table.h"
#include "landmarks/landmark_lists.h"

namespace plateau {

/// One watched witness for every living simplex and track, as the watched literals of a SAT solver.
///
/// A simplex with youngest vertex p has only witnesses that have p in their list, so they are among those whose list p
/// entered at its step; and sets of witnesses only shrink. So each simplex keeps one cursor along that sequence: it
/// moves on when the watched witness is lost, and never back.
class WatchedWitnesses {
public:
    WatchedWitnesses(std::size_t track_count, std::size_t dimension_count, std::uint32_t witness_count);

    /// The witnesses whose lists the landmark of the next step entered.
    void begin_step(std::span<const ListEntry> entries);

    /// The next simplex of dimension k is born; it is to be watched where it lives.
    void add(int k);
    void watch(int track, int k, SimplexIndex simplex, Step birth, std::uint32_t place);
    /// It died of another cause.
    void forget(int track, int k, SimplexIndex simplex) { watch_of(track, k)[simplex].place = kDead; }

    /// Calls lost(k, simplex) for each simplex of the track that is watched by the entry's witness and contains
    /// dropped(k), the landmark that left its first nu_k (0: none). The simplex is not watched any longer.
    template <class Dropped, class Lost>
    void release(int track, WitnessId witness, const std::vector<SimplexTable>& tables, const Dropped& dropped,
                 const Lost& lost) {
        std::uint32_t* link = &first_[static_cast<std::size_t>(track)][witness];
        while (*link != kEnd) {
            const int k = static_cast<int>(*link & ((1u << kDimensionBits) - 1));
            const SimplexIndex simplex = *link >> kDimensionBits;
            Watch& watch = watch_of(track, k)[simplex];
            bool goes = watch.place == kDead;
            const bool alive = !goes;
            const Step gone = alive ? dropped(k) : 0;
            if (gone != 0) {
                for (const Step vertex : tables[static_cast<std::size_t>(k - 1)].tuple(simplex)) {
                    goes = goes || vertex == gone;
                }
            }
            if (!goes) {
                link = &watch.next;
                continue;
            }
            *link = watch.next;
            if (alive) lost(k, simplex);
        }
    }
    /// The next witness after the last one that has all vertices among the first `nu` of its list: watches it, or
    /// returns false if there is none.
    bool move_on(int track, int k, SimplexIndex simplex, std::span<const Step> tuple, std::uint32_t nu,
                 const LandmarkLists& lists);

    std::uint64_t memory() const;

private:
    static constexpr std::uint32_t kEnd = 0xFFFFFFFFu;  // of an encoded list
    static constexpr std::uint32_t kDead = 0xFFFFFFFFu;
    static constexpr int kDimensionBits = 3;
    struct Watch {
        std::uint32_t next = kEnd;    // next simplex that the same witness watches, encoded
        std::uint32_t place = kDead;  // of the witness among the entries of the birth step
    };

    PagedTable<Watch>& watch_of(int track, int k) {
        return watches_[static_cast<std::size_t>(track)][static_cast<std::size_t>(k - 1)];
    }

    std::vector<std::vector<PagedTable<Watch>>> watches_;  // [track][k-1][simplex]
    std::vector<std::vector<std::uint32_t>> first_;        // [track][witness], encoded
    std::vector<WitnessId> entered_;                       // of all steps, in step order
    std::vector<std::size_t> first_entered_{0, 0};         // [s] = first place of step s
};

}  // namespace plateau
