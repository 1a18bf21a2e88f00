#include "complex/simplex_books.h"

namespace plateau {

void SimplexBooks::add(int k, std::span<const SimplexIndex> facets) {
    Book& book = books_[static_cast<std::size_t>(k - 1)];
    book.first_coface.push_back(kEnd);
    for (const SimplexIndex facet : facets) {
        std::uint32_t& first = books_[static_cast<std::size_t>(k - 2)].first_coface[facet];
        const auto encoded = static_cast<std::uint32_t>(book.facets.size());
        book.facets.push_back(facet);
        book.next_coface.push_back(first);
        first = encoded;
    }
}

std::uint64_t SimplexBooks::memory() const {
    std::uint64_t words = 0;
    for (const Book& book : books_) {
        words += book.facets.capacity() + book.first_coface.capacity() + book.next_coface.capacity();
    }
    return words * sizeof(std::uint32_t);
}

}  // namespace plateau
