#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <vector>

namespace plateau {

/// A table that only grows, and beyond its first page never moves. A large vector would double by copying, which one
/// step of the run pays for all, and would hold up to twice the memory; here a page is added. Costs one more load an
/// access.
template <class T>
class PagedTable {
public:
    /// New entries have this value.
    explicit PagedTable(T fill = T()) : fill_(fill) {}

    std::size_t size() const { return size_; }
    /// Entries that there is memory for.
    std::size_t capacity() const {
        return pages_.empty() ? 0 : (pages_.size() - 1) * kEntriesOfPage + pages_.back().capacity();
    }
    T& operator[](std::size_t index) { return pages_[index / kEntriesOfPage][index % kEntriesOfPage]; }
    const T& operator[](std::size_t index) const { return pages_[index / kEntriesOfPage][index % kEntriesOfPage]; }

    /// To at least `size` entries.
    void grow(std::size_t size) {
        while (size_ < size) {
            std::vector<T>& page = page_at_end();
            const std::size_t more = std::min(size - size_, kEntriesOfPage - page.size());
            page.resize(page.size() + more, fill_);
            size_ += more;
        }
    }
    void push_back(const T& value) {
        page_at_end().push_back(value);
        ++size_;
    }

private:
    static constexpr std::size_t kBytesOfPage = std::size_t{1} << 18;
    static constexpr std::size_t kEntriesOfPage = std::bit_floor(kBytesOfPage / sizeof(T));

    std::vector<T>& page_at_end() {
        if (pages_.empty()) {
            pages_.emplace_back();  // doubles like any vector: most runs are small
        } else if (pages_.back().size() == kEntriesOfPage) {
            pages_.emplace_back().reserve(kEntriesOfPage);
        }
        return pages_.back();
    }

    std::vector<std::vector<T>> pages_;
    std::size_t size_ = 0;
    T fill_;
};

}  // namespace plateau
