#pragma once

#include <array>
#include <set>
#include <vector>

/// Slow second implementations, written from the definitions alone. They share nothing with the core but PointCloud:
/// everything is computed again at every step, with sets, sorting and exact integers, so that it can be read as a
/// definition. Landmarks are named by their steps, 1-based, as everywhere.
namespace plateau::reference {

/// Vertices in ascending order.
using Simplex = std::vector<int>;

/// [k] = the k-simplices. Closed under faces.
using Complex = std::array<std::set<Simplex>, 8>;

/// The faces of one dimension less, the one without the first vertex first. Empty for a vertex.
std::vector<Simplex> facets(const Simplex& simplex);

/// All subsets with `size` elements of an ascending list, each ascending.
std::vector<Simplex> subsets(const Simplex& ascending, int size);

/// All faces of the given simplices.
Complex closure(const std::set<Simplex>& simplices);

Complex intersection(const Complex& a, const Complex& b);

}  // namespace plateau::reference
