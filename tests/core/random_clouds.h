#pragma once

#include <cstdint>
#include <string>

/// Compares the engine with the references on one random input: a small cloud of a random kind (many of them tied,
/// flat, repeated or clustered) with a random family, nu, rho, field and first landmark. Empty, or a message that names
/// all of these.
namespace plateau {
std::string random_run_difference(std::uint64_t seed);
}  // namespace plateau
