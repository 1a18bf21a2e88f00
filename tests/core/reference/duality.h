#pragma once

#include <vector>

#include "reference/complex.h"
#include "reference/triangulation.h"

namespace plateau::reference {

/// beta_0, beta_1, beta_2 of a subcomplex of a triangulation of space, for runs too large for elimination: components,
/// components of the complement less one (Alexander duality), and the rest from the Euler characteristic.
std::vector<int> betti_by_duality(const Complex& complex, const Triangulation& triangulation);

}  // namespace plateau::reference
