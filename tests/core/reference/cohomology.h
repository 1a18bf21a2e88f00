#pragma once

#include <cstdint>
#include <vector>

namespace plateau::reference {

/// Betti numbers beta_0 .. beta_{count-1} over Z/prime by GUDHI's persistent cohomology, for complexes that are too
/// large for dense elimination. Vertices are 0 .. vertex_count - 1; `simplices` are all others, faces before cofaces.
std::vector<std::uint32_t> betti_by_cohomology(int vertex_count, const std::vector<std::vector<int>>& simplices,
                                               std::size_t count, int prime);

}  // namespace plateau::reference
