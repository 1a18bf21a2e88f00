#pragma once

#include <cstdint>
#include <string>

namespace plateau {

/// Compares the engine with the references on one random input: a small cloud of a random kind (many of them tied,
/// flat, repeated or clustered) with a random family, nu, rho, field and first landmark, at every step. Clouds have at
/// least 4 and fewer than `size_bound` points. Empty, or a message that names all of these.
std::string random_run_difference(std::uint64_t seed, int size_bound = 38);

}  // namespace plateau
