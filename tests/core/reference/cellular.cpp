#include "reference/cellular.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace plateau::reference {

Cellular::Cellular(const Triangulation& triangulation) : cells(triangulation.cells.begin(), triangulation.cells.end()) {
    std::map<Simplex, int> count;
    for (const Simplex& cell : triangulation.cells) {
        for (const Simplex& facet : facets(cell)) ++count[facet];
    }
    for (const auto& [facet, times] : count) {
        if (times > 2) throw std::logic_error("a facet with more than two cells");
        if (times == 2) continue;
        Simplex infinite_cell = facet;
        infinite_cell.insert(infinite_cell.begin(), kInfinity);
        cells.push_back(infinite_cell);
    }
    for (std::size_t c = 0; c < cells.size(); ++c) {
        for (const Simplex& facet : facets(cells[c])) at_facet[facet].push_back(static_cast<int>(c));
    }
}

int Cellular::across(const Simplex& facet, int cell) const {
    const std::vector<int>& both = at_facet.at(facet);
    if (both.size() != 2) throw std::logic_error("a facet without two cells");
    return both[0] == cell ? both[1] : both[0];
}

Classes::Classes(std::size_t size) : label_(size) {
    std::iota(label_.begin(), label_.end(), 0);
}

void Classes::unite(std::size_t a, std::size_t b) {
    const int from = std::max(label_[a], label_[b]), to = std::min(label_[a], label_[b]);
    if (from != to) std::replace(label_.begin(), label_.end(), from, to);
}

std::vector<int> Classes::numbers(int& count) const {
    std::map<int, int> number;
    std::vector<int> result;
    for (const int label : label_) {
        result.push_back(number.emplace(label, static_cast<int>(number.size())).first->second);
    }
    count = static_cast<int>(number.size());
    return result;
}

}  // namespace plateau::reference
