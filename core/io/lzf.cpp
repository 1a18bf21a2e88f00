#include "io/lzf.h"

namespace plateau {

LzfDecoder::LzfDecoder(std::string_view data, std::size_t size) : data_(data), size_(size) {
    output_.reserve(size);
}

LzfDecoder::Status LzfDecoder::advance(std::size_t bytes) {
    const std::size_t aim = bytes < size_ - output_.size() ? output_.size() + bytes : size_;
    while (output_.size() < aim) {
        if (!expand_token()) return Status::Broken;
    }
    if (output_.size() < size_) return Status::More;
    return position_ == data_.size() ? Status::Done : Status::Broken;
}

bool LzfDecoder::expand_token() {
    constexpr unsigned kLiterals = 32;
    constexpr std::size_t kLongLength = 7;
    const auto left = [&] { return data_.size() - position_; };
    const auto next_byte = [&] { return static_cast<unsigned char>(data_[position_++]); };
    if (left() == 0) return false;
    const unsigned control = next_byte();
    if (control < kLiterals) {
        const std::size_t length = control + 1;
        if (length > left() || length > size_ - output_.size()) return false;
        output_.append(data_.substr(position_, length));
        position_ += length;
        return true;
    }
    std::size_t length = control >> 5;
    if (left() < (length == kLongLength ? 2u : 1u)) return false;
    if (length == kLongLength) length += next_byte();
    length += 2;
    const std::size_t distance = ((control & 31u) << 8 | next_byte()) + 1;
    if (distance > output_.size() || length > size_ - output_.size()) return false;
    // Byte by byte: a copy may reach into what it writes.
    for (std::size_t k = 0; k < length; ++k) output_.push_back(output_[output_.size() - distance]);
    return true;
}

}  // namespace plateau
