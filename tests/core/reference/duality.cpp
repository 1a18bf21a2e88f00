#include "reference/duality.h"

#include <map>

#include "reference/cellular.h"

namespace plateau::reference {

std::vector<int> betti_by_duality(const Complex& complex, const Triangulation& triangulation) {
    std::map<int, std::size_t> place;  // of a landmark among the vertices
    for (const Simplex& vertex : complex[0]) place.emplace(vertex[0], place.size());
    Classes vertices(place.size());
    for (const Simplex& edge : complex[1]) vertices.unite(place.at(edge[0]), place.at(edge[1]));
    int components = 0;
    vertices.numbers(components);

    const Cellular space(triangulation);
    Classes regions(space.cells.size());
    int first_infinite = -1;
    for (std::size_t c = 0; c < space.cells.size(); ++c) {
        if (!space.infinite(static_cast<int>(c))) continue;
        if (first_infinite < 0) first_infinite = static_cast<int>(c);
        regions.unite(static_cast<std::size_t>(first_infinite), c);
    }
    for (const auto& [facet, both] : space.at_facet) {
        if (complex[2].count(facet) == 0)
            regions.unite(static_cast<std::size_t>(both[0]), static_cast<std::size_t>(both[1]));
    }
    int region_count = 0;
    regions.numbers(region_count);
    // A kept cell is a region of its own: all of its facets are kept.
    const int voids = region_count - static_cast<int>(complex[3].size()) - 1;

    const int euler = static_cast<int>(complex[0].size()) - static_cast<int>(complex[1].size()) +
                      static_cast<int>(complex[2].size()) - static_cast<int>(complex[3].size());
    return {components, components + voids - euler, voids};
}

}  // namespace plateau::reference
