#include "reference/complex.h"

#include <algorithm>
#include <iterator>

namespace plateau::reference {

std::vector<Simplex> facets(const Simplex& simplex) {
    std::vector<Simplex> result;
    if (simplex.size() < 2) return result;
    for (std::size_t left_out = 0; left_out < simplex.size(); ++left_out) {
        Simplex facet = simplex;
        facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(left_out));
        result.push_back(facet);
    }
    return result;
}

std::vector<Simplex> subsets(const Simplex& ascending, int size) {
    if (size == 0) return {{}};
    std::vector<Simplex> result;
    for (std::size_t last = 0; last < ascending.size(); ++last) {
        const Simplex before(ascending.begin(), ascending.begin() + static_cast<std::ptrdiff_t>(last));
        for (Simplex subset : subsets(before, size - 1)) {
            subset.push_back(ascending[last]);
            result.push_back(subset);
        }
    }
    return result;
}

Complex closure(const std::set<Simplex>& simplices) {
    Complex result;
    for (const Simplex& simplex : simplices) {
        for (int size = 1; size <= static_cast<int>(simplex.size()); ++size) {
            for (const Simplex& face : subsets(simplex, size)) result[static_cast<std::size_t>(size - 1)].insert(face);
        }
    }
    return result;
}

Complex intersection(const Complex& a, const Complex& b) {
    Complex result;
    for (std::size_t k = 0; k < a.size(); ++k) {
        std::set_intersection(a[k].begin(), a[k].end(), b[k].begin(), b[k].end(),
                              std::inserter(result[k], result[k].end()));
    }
    return result;
}

}  // namespace plateau::reference
