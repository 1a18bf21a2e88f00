#pragma once

#include <cstdint>
#include <vector>

#include "complex/simplex_table.h"

namespace plateau {

/// Betti numbers beta_0 .. beta_{count-1} over Z/prime of the simplices of a track that live at the step, by cohomology
/// of the whole complex: for complexes that are not embedded. `tables` up to dimension `count`. Cost: a reduction of
/// all living simplices.
std::vector<std::uint32_t> general_betti(const std::vector<SimplexTable>& tables, int track, Step step,
                                         std::uint32_t count, std::uint32_t prime);

}  // namespace plateau
