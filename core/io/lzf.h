#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace plateau {

/// No LZF data expand by more than this: the shortest copy, of three bytes, makes at most 264.
inline constexpr std::size_t kMaxLzfExpansion = 88;

/// Expands LZF-compressed data in slices, as compressed PCD files have them. A token is a run of literals (first byte
/// below 32: one less than their number) or a copy of earlier output (three bits of length, 13 of distance). No input
/// makes it read or write out of bounds or beyond the promised size.
class LzfDecoder {
public:
    enum class Status : std::uint8_t { More, Done, Broken };

    /// `size`: bytes that come out, at most kMaxLzfExpansion times those that go in. The data outlive the decoder.
    LzfDecoder(std::string_view data, std::size_t size);

    /// Makes at least `bytes` more bytes, unless the data end before.
    Status advance(std::size_t bytes);

    /// What has come out so far; all of it after Done.
    const std::string& output() const { return output_; }

private:
    /// Whether the next token is well formed.
    bool expand_token();

    std::string_view data_;
    std::size_t position_ = 0;
    std::size_t size_;
    std::string output_;
};

}  // namespace plateau
