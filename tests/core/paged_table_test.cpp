#include "base/paged_table.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <vector>

#include "base/random.h"

namespace plateau {
namespace {

struct Wide {
    std::array<std::uint32_t, 11> entries{};
    bool operator==(const Wide&) const = default;
};

// Grows both by the same steps over several pages, and writes at random in between.
template <class T>
void expect_as_a_vector(T fill, const std::vector<T>& values, std::uint64_t seed) {
    PagedTable<T> table(fill);
    std::vector<T> plain;
    Random random(seed);
    while (plain.size() < 200'000) {
        const T& value = values[random.next_bits() % values.size()];
        if (random.next_bits() % 4 == 0) {
            const std::size_t size = plain.size() + random.next_bits() % 9'000;
            table.grow(size);
            plain.resize(size, fill);
            table.grow(size / 2);  // never smaller
        } else {
            table.push_back(value);
            plain.push_back(value);
        }
        if (plain.empty()) continue;
        const std::size_t at = random.next_bits() % plain.size();
        table[at] = value;
        plain[at] = value;
    }
    ASSERT_EQ(table.size(), plain.size());
    EXPECT_GE(table.capacity(), table.size());
    for (std::size_t at = 0; at < plain.size(); ++at) ASSERT_EQ(table[at], plain[at]) << at;
}

TEST(PagedTable, HoldsWhatAVectorHolds) {
    expect_as_a_vector<std::uint32_t>(0xFFFFFFFFu, {1, 2, 3}, 1);
    expect_as_a_vector<std::uint8_t>(7, {1, 2, 3}, 2);
    expect_as_a_vector<Wide>({}, {{{1}}, {{2, 3}}}, 3);
}

TEST(PagedTable, NothingMovesBeyondTheFirstPage) {
    PagedTable<Wide> table;
    table.grow(20'000);
    table[0] = table[19'999] = {{1}};
    const Wide* const first = &table[0];
    const Wide* const last = &table[19'999];
    table.grow(1'000'000);
    EXPECT_EQ(&table[0], first);
    EXPECT_EQ(&table[19'999], last);
    EXPECT_EQ(*first, Wide{{1}});
    EXPECT_EQ(*last, Wide{{1}});
    EXPECT_EQ(table[999'999], Wide{});
}

TEST(PagedTable, HoldsLittleWhileItIsSmall) {
    PagedTable<Wide> table;
    EXPECT_EQ(table.capacity(), 0u);
    table.push_back({});
    EXPECT_LT(table.capacity(), 10u);
    table.grow(100'000);
    EXPECT_LT(table.capacity(), 110'000u);
}

}  // namespace
}  // namespace plateau
