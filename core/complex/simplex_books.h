#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/paged_table.h"
#include "complex/simplex_table.h"

namespace plateau {

/// Which simplex is a facet of which, for the simplices of a record: one entry a simplex, in the order of its table.
class SimplexBooks {
public:
    explicit SimplexBooks(int max_dimension) : books_(static_cast<std::size_t>(max_dimension)) {}

    /// Enters the next simplex of dimension k >= 1. `facets`: their indices in the table of dimension k-1, facet j
    /// lacks vertex j; none for an edge.
    void add(int k, std::span<const SimplexIndex> facets);

    /// Indices in the table of dimension k-1 of the k+1 facets of a simplex of dimension k >= 2; facet j lacks vertex
    /// j.
    std::span<const SimplexIndex> facets(int k, SimplexIndex simplex) const {
        const auto width = static_cast<std::size_t>(k + 1);
        return {books_[static_cast<std::size_t>(k - 1)].facets.data() + simplex * width, width};
    }
    /// Calls use(coface) for every recorded simplex of dimension k+1 that has this one, of dimension k >= 1, as a
    /// facet, also where it is dead.
    template <class Use>
    void for_each_coface(int k, SimplexIndex simplex, const Use& use) const {
        const auto links_per_simplex = static_cast<std::uint32_t>(k + 2);
        std::uint32_t link = books_[static_cast<std::size_t>(k - 1)].first_coface[simplex];
        for (; link != kEnd; link = books_[static_cast<std::size_t>(k)].next_coface[link])
            use(link / links_per_simplex);
    }
    int max_dimension() const { return static_cast<int>(books_.size()); }
    /// Bytes held.
    std::uint64_t memory() const;

private:
    static constexpr std::uint32_t kEnd = 0xFFFFFFFFu;  // of an encoded list
    struct Book {                                       // one a dimension
        std::vector<SimplexIndex> facets;               // k+1 a simplex, from dimension 2
        PagedTable<std::uint32_t> first_coface;         // encoded links into the book of dimension k+1
        PagedTable<std::uint32_t> next_coface;          // one a facet link
    };

    std::vector<Book> books_;
};

}  // namespace plateau
