#include "timeline/timeline.h"

namespace plateau {

std::vector<SimplexIndex> Timeline::living(int dim, int track, Step step) const {
    std::vector<SimplexIndex> result;
    if (dim > static_cast<int>(dimension)) return result;
    const SimplexTable& simplices_of_dim = table(dim);
    const SimplexIndex end = simplices_of_dim.first_of_step[step + 1];
    for (SimplexIndex simplex = 0; simplex < end; ++simplex) {
        if (simplices_of_dim.lives(simplex, track, step)) result.push_back(simplex);
    }
    return result;
}

std::vector<std::uint32_t> Timeline::surface_rows(Step step) const {
    std::vector<std::uint32_t> result;
    for (std::uint32_t row = 0; row < surface.size() && surface[row].from <= step; ++row) {
        if (step < surface[row].to) result.push_back(row);
    }
    return result;
}

}  // namespace plateau
