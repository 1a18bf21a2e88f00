#pragma once

#include <optional>
#include <string>
#include <vector>

#include "inspect/inspection.h"
#include "reference/complex.h"
#include "reference/triangulation.h"

namespace plateau {

/// What an answer is held against: a complex at one step, by its definition.
struct DefinedComplex {
    std::vector<std::vector<int>> lists;  ///< of every witness all landmarks, nearest first
    reference::Complex complex;
    std::vector<int> nu;
    int max_dimension = 0;
    int landmark_count = 0;
    std::optional<reference::Triangulation> triangulation;  ///< D(L), for complexes within it
    std::vector<reference::LabeledPoint> points;            ///< the landmarks, where there is D(L)
};

/// Verdict, what it is about, witnesses, ranks and blockers against the definition; lifespan and surface aside. Empty,
/// or the first difference.
std::string inspection_difference(const DefinedComplex& expected, reference::Simplex asked, const Inspection& found);

}  // namespace plateau
