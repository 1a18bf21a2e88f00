#include "complex/simplex_table.h"

#include <algorithm>

#include "base/few.h"

namespace plateau {

SimplexIndex SimplexTable::find(std::span<const Step> tuple) const {
    const Step youngest = tuple.back();
    SimplexIndex low = first_of_step[youngest];
    SimplexIndex high = first_of_step[youngest + 1];
    const auto width = static_cast<std::size_t>(dimension + 1);
    while (low < high) {
        const SimplexIndex middle = low + (high - low) / 2;
        const Step* candidate = vertices.data() + middle * width;
        if (std::lexicographical_compare(candidate, candidate + width, tuple.begin(), tuple.end())) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    if (low == first_of_step[youngest + 1] || low == size()) return kNoSimplex;
    const Step* candidate = vertices.data() + low * width;
    return equal_few(tuple.data(), candidate, width) ? low : kNoSimplex;
}

}  // namespace plateau
