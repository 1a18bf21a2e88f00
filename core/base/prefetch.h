#pragma once

namespace plateau {

/// Asks the memory for what will be needed soon, and does not wait: what an insertion touches lies scattered, and one
/// miss after the other would cost more than all the work on it. Never needed for a result.
inline void prefetch(const void* address) {
    __builtin_prefetch(address);
}

}  // namespace plateau
