#include "homology/general_betti.h"

// GUDHI 3.7 prints without including this.
#include <iostream>

#include <gudhi/Persistent_cohomology.h>
#include <gudhi/Simplex_tree.h>

namespace plateau {

std::vector<std::uint32_t> general_betti(const std::vector<SimplexTable>& tables, int track, Step step,
                                         std::uint32_t count, std::uint32_t prime) {
    Gudhi::Simplex_tree<Gudhi::Simplex_tree_options_fast_persistence> tree;
    // The tree wants vertices 0, 1, ... without a gap: step - 1.
    for (Step vertex = 0; vertex < step; ++vertex) tree.insert_simplex({static_cast<int>(vertex)});
    std::vector<int> vertices;
    for (const SimplexTable& table : tables) {
        for (SimplexIndex simplex = 0; simplex < table.first_of_step[step + 1]; ++simplex) {
            if (!table.lives(simplex, track, step)) continue;
            const auto tuple = table.tuple(simplex);
            vertices.clear();
            for (const Step vertex : tuple) vertices.push_back(static_cast<int>(vertex) - 1);
            tree.insert_simplex(vertices);
        }
    }
    using Cohomology =
        Gudhi::persistent_cohomology::Persistent_cohomology<decltype(tree), Gudhi::persistent_cohomology::Field_Zp>;
    constexpr bool kTopDimensionToo = true;
    Cohomology cohomology(tree, kTopDimensionToo);
    cohomology.init_coefficients(static_cast<int>(prime));
    cohomology.compute_persistent_cohomology();

    std::vector<std::uint32_t> betti(count, 0);
    const auto all = cohomology.betti_numbers();
    for (std::size_t k = 0; k < betti.size() && k < all.size(); ++k) betti[k] = static_cast<std::uint32_t>(all[k]);
    return betti;
}

}  // namespace plateau
