#include "cloud/distance_matrix.h"

namespace plateau {

void DistanceMatrix::row(std::uint32_t witness, std::span<double> out) const {
    std::size_t place = static_cast<std::size_t>(entry_count(witness));
    for (std::uint32_t other = 0; other < witness; ++other) out[other] = entry(place++);
    out[witness] = 0;
    // Below the witness's row its column goes on, each row one longer than the last.
    place += witness;
    for (std::uint32_t other = witness + 1; other < size; ++other) {
        out[other] = entry(place);
        place += other;
    }
}

}  // namespace plateau
