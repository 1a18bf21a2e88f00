#include "homology/general_betti.h"

namespace plateau {

GeneralBetti::GeneralBetti(int count, std::span<const std::uint32_t> primes) : skeleton_(0), simplices_(0, count) {
    for (int k = 2; k <= count; ++k) cycles_.emplace_back(k, primes);
}

bool GeneralBetti::update(Step step, const std::vector<SimplexTable>& tables, const SimplexBooks& books,
                          std::span<const Death> deaths, std::span<const Step> hidden, Slice& slice) {
    if (!is_counted_) {
        simplices_.update(step, tables, deaths, hidden);
        hidden_ += static_cast<std::uint32_t>(hidden.size());
        skeleton_.update(step, tables.front(), deaths);
        is_counted_ = true;
    }
    for (; next_ < cycles_.size(); ++next_) {
        if (!cycles_[next_].update(step, tables, books, deaths, slice)) return false;
    }
    is_counted_ = false;
    next_ = 0;
    return true;
}

std::vector<std::uint32_t> GeneralBetti::numbers(std::size_t field) const {
    const auto count = static_cast<std::size_t>(simplices_.max_dimension());
    std::vector<std::uint32_t> numbers;
    std::uint32_t boundaries_below = 0;  // dim B_(k-1)
    for (std::size_t k = 0; k < count; ++k) {
        const std::uint32_t cycles = simplices_[k] - boundaries_below;
        const std::uint32_t boundaries = k == 0 ? simplices_[0] - (skeleton_.count() - hidden_)
                                                : simplices_[k + 1] - cycles_[k - 1].dimension(field);
        numbers.push_back(cycles - boundaries);
        boundaries_below = boundaries;
    }
    return numbers;
}

std::uint64_t GeneralBetti::memory() const {
    std::uint64_t bytes = skeleton_.memory();
    for (const CycleSpace& cycles : cycles_) bytes += cycles.memory();
    return bytes;
}

}  // namespace plateau
