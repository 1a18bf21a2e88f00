#pragma once

#include <map>
#include <vector>

#include "reference/complex.h"
#include "reference/triangulation.h"

namespace plateau::reference {

/// Vertex at infinity: smaller than every step, so it comes first in its cells.
inline constexpr int kInfinity = 0;

/// The cells of a triangulation of space, one infinite cell over each hull facet, and which two share a facet.
class Cellular {
public:
    explicit Cellular(const Triangulation& triangulation);

    std::vector<Simplex> cells;
    std::map<Simplex, std::vector<int>> at_facet;

    /// The other cell at the facet.
    int across(const Simplex& facet, int cell) const;
    bool infinite(int cell) const { return cells[static_cast<std::size_t>(cell)][0] == kInfinity; }
};

/// Classes of 0 .. size - 1.
class Classes {
public:
    explicit Classes(std::size_t size);
    void unite(std::size_t a, std::size_t b);
    /// The number of each member's class, in order of first members; `count` receives how many classes there are.
    std::vector<int> numbers(int& count) const;

private:
    std::vector<int> label_;
};

}  // namespace plateau::reference
