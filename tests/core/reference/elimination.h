#pragma once

#include <vector>

#include "reference/complex.h"

namespace plateau::reference {

/// Rank over Z/2 of a matrix given by its columns, each the rows with an odd entry (a row named twice cancels).
int rank_mod_two(const std::vector<std::vector<int>>& columns, int row_count);

/// Rank over Z/p of a dense matrix of rows.
int rank_mod_prime(std::vector<std::vector<long>> rows, long prime);

/// beta_0 .. beta_{count-1} over Z/p of the simplices of dimension <= count, by elimination of boundary matrices.
std::vector<int> betti_numbers(const Complex& complex, int count, int prime = 2);

}  // namespace plateau::reference
