#include "reference/cohomology.h"

// GUDHI 3.7 prints without including this.
#include <iostream>

#include <gudhi/Persistent_cohomology.h>
#include <gudhi/Simplex_tree.h>

namespace plateau::reference {

std::vector<std::uint32_t> betti_by_cohomology(int vertex_count, const std::vector<std::vector<int>>& simplices,
                                               std::size_t count, int prime) {
    using Tree = Gudhi::Simplex_tree<Gudhi::Simplex_tree_options_fast_persistence>;
    Tree tree;
    for (int vertex = 0; vertex < vertex_count; ++vertex) tree.insert_simplex({vertex});
    for (const std::vector<int>& simplex : simplices) tree.insert_simplex(simplex);
    constexpr bool kTopDimensionToo = true;
    Gudhi::persistent_cohomology::Persistent_cohomology<Tree, Gudhi::persistent_cohomology::Field_Zp> cohomology(
        tree, kTopDimensionToo);
    cohomology.init_coefficients(prime);
    cohomology.compute_persistent_cohomology();
    std::vector<std::uint32_t> betti(count, 0);
    const auto all = cohomology.betti_numbers();
    for (std::size_t k = 0; k < count && k < all.size(); ++k) betti[k] = static_cast<std::uint32_t>(all[k]);
    return betti;
}

}  // namespace plateau::reference
