#include "complex/nu_complex.h"

#include <algorithm>
#include <array>

#include "base/few.h"

namespace plateau {

namespace {

constexpr std::uint32_t kEnd = 0xFFFFFFFFu;  // of an encoded list
constexpr int kDimensionBits = 3;

std::uint32_t encode(int k, SimplexIndex simplex) {
    return simplex << kDimensionBits | static_cast<std::uint32_t>(k);
}

bool contains(std::span<const std::uint32_t> list, std::uint32_t count, Step step) {
    for (std::uint32_t rank = 0; rank < count; ++rank) {
        if (list[rank] == step) return true;
    }
    return false;
}

// Calls use(tuple) for every ascending k-subset of the ascending `from`.
template <class Use>
void for_each_subset(std::span<const Step> from, std::size_t k, std::array<Step, 8>& tuple, std::size_t chosen,
                     std::size_t next, const Use& use) {
    if (chosen == k) {
        use(tuple.data());
        return;
    }
    for (; next + (k - chosen) <= from.size(); ++next) {
        tuple[chosen] = from[next];
        for_each_subset(from, k, tuple, chosen + 1, next + 1, use);
    }
}

template <class Use>
void for_each_subset(std::span<const Step> from, std::size_t k, const Use& use) {
    std::array<Step, 8> tuple{};
    for_each_subset(from, k, tuple, 0, 0, use);
}

}  // namespace

NuComplex::NuComplex(std::vector<std::vector<std::uint32_t>> nu, int max_dimension, std::uint32_t witness_count)
    : nu_(std::move(nu)) {
    for (int k = 1; k <= max_dimension; ++k) links_.emplace_back(k);
    books_.resize(static_cast<std::size_t>(max_dimension));
    for (Book& book : books_) book.watch.resize(nu_.size());
    first_watched_.assign(nu_.size(), std::vector<std::uint32_t>(witness_count, kEnd));
}

std::uint32_t NuComplex::nu(int track, int k) const {
    const auto& sequence = nu_[static_cast<std::size_t>(track)];
    return static_cast<std::size_t>(k) < sequence.size() ? sequence[static_cast<std::size_t>(k)] : 0;
}

void NuComplex::insert(Step step, const LandmarkLists& lists, std::span<const ListEntry> entries,
                       const Delaunay* delaunay, const DelaunayChange* change, std::vector<SimplexTable>& tables) {
    deaths_.clear();
    for (LinkTable& link : links_) link.clear();
    for (const ListEntry& entry : entries) entered_.push_back(entry.witness);
    first_entered_.push_back(entered_.size());

    if (change != nullptr) {
        fill_star(step, *delaunay, *change);
        remove_lost_in_delaunay(step, *delaunay, *change, tables);
    }
    move_watches(step, lists, entries, tables);
    mark_witnessed(lists, entries, change == nullptr);
    for (int k = 1; k <= max_dimension(); ++k) bear(step, k, tables);

    std::sort(deaths_.begin(), deaths_.end(), [&](const Death& a, const Death& b) {
        if (a.track != b.track) return a.track < b.track;
        if (a.dimension != b.dimension) return a.dimension < b.dimension;
        const SimplexTable& table = tables[a.dimension - 1u];
        const auto x = table.tuple(a.simplex);
        const auto y = table.tuple(b.simplex);
        return std::lexicographical_compare(x.begin(), x.end(), y.begin(), y.end());
    });
}

// The simplices of D(L) that contain p, as simplices of its link.
void NuComplex::fill_star(Step step, const Delaunay& delaunay, const DelaunayChange& change) {
    for (const CellId id : change.born) {
        const DelaunayCell& cell = delaunay.cell(id);
        if (!cell.finite(change.dimension)) continue;
        std::array<Step, 4> others{};
        std::size_t count = 0;
        for (std::size_t i = 0; i <= static_cast<std::size_t>(change.dimension); ++i) {
            if (cell.vertex[i] != step) others[count++] = cell.vertex[i];
        }
        if (count > static_cast<std::size_t>(change.dimension)) continue;
        sort_few(others.data(), count);
        for (std::size_t k = 1; k <= count; ++k) {
            for_each_subset({others.data(), count}, k, [&](const Step* tuple) { links_[k - 1].insert(tuple); });
        }
    }
}

// A face of a dead cell is still in D(L) exactly if it is in the link of p.
void NuComplex::remove_lost_in_delaunay(Step step, const Delaunay& delaunay, const DelaunayChange& change,
                                        std::vector<SimplexTable>& tables) {
    if (change.dimension_rose) return;  // D(L) became a cone over itself
    for (const CellId id : change.died) {
        const DelaunayCell& cell = delaunay.cell(id);
        std::array<Step, 4> vertices{};
        std::size_t count = 0;
        for (std::size_t i = 0; i <= static_cast<std::size_t>(change.dimension); ++i) {
            if (cell.vertex[i] != kInfiniteVertex) vertices[count++] = cell.vertex[i];
        }
        sort_few(vertices.data(), count);
        for (std::size_t size = 2; size <= count; ++size) {
            for_each_subset({vertices.data(), count}, size, [&](const Step* tuple) {
                const bool in_link = size <= links_.size() && links_[size - 1].find(tuple) != kNoSimplex;
                if (in_link) return;
                const SimplexIndex simplex = tables[size - 2].find({tuple, size});
                if (simplex == kNoSimplex) return;
                for (int track = 0; track < track_count(); ++track) {
                    kill(step, track, static_cast<int>(size) - 1, simplex, tables);
                }
            });
        }
    }
}

void NuComplex::move_watches(Step step, const LandmarkLists& lists, std::span<const ListEntry> entries,
                             std::vector<SimplexTable>& tables) {
    for (const ListEntry& entry : entries) {
        const auto list = lists.list(entry.witness);
        for (int track = 0; track < track_count(); ++track) {
            std::uint32_t* link = &first_watched_[static_cast<std::size_t>(track)][entry.witness];
            while (*link != kEnd) {
                const int k = static_cast<int>(*link & ((1u << kDimensionBits) - 1));
                const SimplexIndex simplex = *link >> kDimensionBits;
                const SimplexTable& table = tables[static_cast<std::size_t>(k - 1)];
                std::uint32_t& next =
                    books_[static_cast<std::size_t>(k - 1)].watch[static_cast<std::size_t>(track)].next[simplex];
                const bool lives = table.death[static_cast<std::size_t>(track)][simplex] == kNever;
                bool witnessed = lives;
                if (lives && entry.rank < nu(track, k)) {
                    for (const Step vertex : table.tuple(simplex)) {
                        witnessed = witnessed && contains(list, nu(track, k), vertex);
                    }
                }
                if (witnessed) {
                    link = &next;
                    continue;
                }
                *link = next;
                if (lives && !find_next_witness(lists, track, k, simplex, table)) {
                    kill(step, track, k, simplex, tables);
                }
            }
        }
    }
}

bool NuComplex::find_next_witness(const LandmarkLists& lists, int track, int k, SimplexIndex simplex,
                                  const SimplexTable& table) {
    const auto tuple = table.tuple(simplex);
    const Step birth = tuple.back();
    const std::uint32_t count = nu(track, k);
    const auto begin = first_entered_[birth];
    const auto size = static_cast<std::uint32_t>(first_entered_[birth + 1] - begin);
    const Watch& watch_book = books_[static_cast<std::size_t>(k - 1)].watch[static_cast<std::size_t>(track)];
    for (std::uint32_t cursor = watch_book.cursor[simplex] + 1; cursor < size; ++cursor) {
        const auto list = lists.list(entered_[begin + cursor]);
        bool witnessed = true;
        for (std::size_t i = tuple.size(); witnessed && i-- > 0;) witnessed = contains(list, count, tuple[i]);
        if (!witnessed) continue;
        watch(track, k, simplex, birth, cursor);
        return true;
    }
    return false;
}

// For every candidate the first entry whose witness nu_k-witnesses it, per track.
void NuComplex::mark_witnessed(const LandmarkLists& lists, std::span<const ListEntry> entries, bool add_missing) {
    std::vector<Step> others;
    for (std::uint32_t place = 0; place < entries.size(); ++place) {
        const auto list = lists.list(entries[place].witness);
        for (int track = 0; track < track_count(); ++track) {
            for (int k = 1; k <= max_dimension(); ++k) {
                const std::uint32_t count = nu(track, k);
                if (entries[place].rank >= count) continue;
                others.clear();
                for (std::uint32_t rank = 0; rank < count && list[rank] != 0; ++rank) {
                    const bool candidate =
                        rank != entries[place].rank && (add_missing || links_[0].find(&list[rank]) != kNoSimplex);
                    if (candidate) others.push_back(list[rank]);
                }
                sort_few(others.data(), others.size());
                LinkTable& link = links_[static_cast<std::size_t>(k - 1)];
                for_each_subset(others, static_cast<std::size_t>(k), [&](const Step* tuple) {
                    const std::uint32_t index = add_missing ? link.insert(tuple) : link.find(tuple);
                    if (index == kNoSimplex) return;
                    std::uint32_t& first = link[index].first_witness[static_cast<std::size_t>(track)];
                    if (first == kNoSimplex) first = place;
                });
            }
        }
    }
}

// Appends the witnessed candidates of dimension k whose facets live, in the order of their tuples.
void NuComplex::bear(Step step, int k, std::vector<SimplexTable>& tables) {
    LinkTable& link = links_[static_cast<std::size_t>(k - 1)];
    SimplexTable& table = tables[static_cast<std::size_t>(k - 1)];
    Book& book = books_[static_cast<std::size_t>(k - 1)];
    const auto width = static_cast<std::size_t>(k);

    std::vector<std::uint32_t> order;
    for (std::uint32_t index = 0; index < link.size(); ++index) {
        bool witnessed = false;
        for (int track = 0; track < track_count(); ++track) {
            witnessed = witnessed || link[index].first_witness[static_cast<std::size_t>(track)] != kNoSimplex;
        }
        if (witnessed) order.push_back(index);
    }
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        const auto x = link.tuple(a);
        const auto y = link.tuple(b);
        return std::lexicographical_compare(x.begin(), x.end(), y.begin(), y.end());
    });

    for (const std::uint32_t index : order) {
        const auto others = link.tuple(index);
        std::array<SimplexIndex, 8> facets{};
        bool facets_known = true;
        if (k >= 2) {
            facets[width] = tables[width - 2].find(others);
            facets_known = facets[width] != kNoSimplex;
            for (std::size_t j = 0; facets_known && j < width; ++j) {
                std::array<Step, 8> rest{};
                std::copy(others.begin(), others.begin() + static_cast<std::ptrdiff_t>(j), rest.begin());
                std::copy(others.begin() + static_cast<std::ptrdiff_t>(j) + 1, others.end(),
                          rest.begin() + static_cast<std::ptrdiff_t>(j));
                const std::uint32_t candidate = links_[width - 2].find(rest.data());
                facets[j] = candidate == kNoSimplex ? kNoSimplex : links_[width - 2][candidate].simplex;
                facets_known = facets[j] != kNoSimplex;
            }
        }
        if (!facets_known) continue;

        std::array<bool, kMaxTracks> lives{};
        for (std::size_t track = 0; track < nu_.size(); ++track) {
            lives[track] = link[index].first_witness[track] != kNoSimplex;
            for (std::size_t j = 0; lives[track] && k >= 2 && j <= width; ++j) {
                lives[track] = tables[width - 2].death[track][facets[j]] == kNever;
            }
        }
        if (!lives[0] && !lives[1]) continue;

        const SimplexIndex simplex = table.size();
        link[index].simplex = simplex;
        table.vertices.insert(table.vertices.end(), others.begin(), others.end());
        table.vertices.push_back(step);
        book.first_coface.push_back(kEnd);
        if (k >= 2) {
            Book& facet_book = books_[width - 2];
            for (std::size_t j = 0; j <= width; ++j) {
                const auto encoded = static_cast<std::uint32_t>(book.facets.size());
                book.facets.push_back(facets[j]);
                book.next_coface.push_back(facet_book.first_coface[facets[j]]);
                facet_book.first_coface[facets[j]] = encoded;
            }
        }
        for (std::size_t track = 0; track < nu_.size(); ++track) {
            table.death[track].push_back(lives[track] ? kNever : step);
            book.watch[track].cursor.push_back(0);
            book.watch[track].next.push_back(kEnd);
            if (lives[track]) watch(static_cast<int>(track), k, simplex, step, link[index].first_witness[track]);
        }
    }
    table.first_of_step.resize(step + 2, 0);
    table.first_of_step[step + 1] = table.size();
}

void NuComplex::watch(int track, int k, SimplexIndex simplex, Step birth, std::uint32_t cursor) {
    const WitnessId witness = entered_[first_entered_[birth] + cursor];
    Watch& book = books_[static_cast<std::size_t>(k - 1)].watch[static_cast<std::size_t>(track)];
    std::uint32_t& first = first_watched_[static_cast<std::size_t>(track)][witness];
    book.cursor[simplex] = cursor;
    book.next[simplex] = first;
    first = encode(k, simplex);
}

void NuComplex::kill(Step step, int track, int k, SimplexIndex simplex, std::vector<SimplexTable>& tables) {
    Step& death = tables[static_cast<std::size_t>(k - 1)].death[static_cast<std::size_t>(track)][simplex];
    if (death != kNever) return;
    death = step;
    deaths_.push_back({static_cast<std::uint8_t>(track), static_cast<std::uint8_t>(k), simplex});
    if (k == max_dimension()) return;
    const Book& cofaces = books_[static_cast<std::size_t>(k)];
    const auto links_per_simplex = static_cast<std::uint32_t>(k + 2);
    std::uint32_t link = books_[static_cast<std::size_t>(k - 1)].first_coface[simplex];
    for (; link != kEnd; link = cofaces.next_coface[link]) kill(step, track, k + 1, link / links_per_simplex, tables);
}

std::uint64_t NuComplex::memory() const {
    std::uint64_t words = 2 * first_entered_.capacity() + entered_.capacity();
    for (const auto& heads : first_watched_) words += heads.capacity();
    for (const Book& book : books_) {
        words += book.facets.capacity() + book.first_coface.capacity() + book.next_coface.capacity();
        for (const Watch& one : book.watch) words += one.cursor.capacity() + one.next.capacity();
    }
    return words * sizeof(std::uint32_t);
}

}  // namespace plateau
