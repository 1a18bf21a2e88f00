#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace plateau {

/// Every expected failure of the core. The numeric values cross the module boundary: append only.
enum class ErrorCode : unsigned char {
    EmptyInput = 1,      ///< no point at all
    TooFewPoints = 2,    ///< fewer points than the task needs
    NotANumber = 3,      ///< NaN or infinity, or a coordinate whose square overflows
    RaggedRows = 4,      ///< rows of different length
    MalformedInput = 5,  ///< the text or bytes break the rules of their format
    UnknownFormat = 6,   ///< a file of another kind
    UnsupportedDimension = 7,
    InvalidOption = 8,  ///< an option out of its range or unknown
    OutOfMemory = 9,    ///< the estimate exceeds the budget, or the budget ran out during the run
    CannotReadFile = 10,
    CannotWriteFile = 11,
    Internal = 12,  ///< a broken invariant; please report
};

/// An expected failure: a code for programs and one sentence that tells a person what to do.
struct Error {
    ErrorCode code = ErrorCode::Internal;
    std::string message;
};

/// A value or the reason why there is none.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

    explicit operator bool() const { return state_.index() == 0; }
    T& value() & { return *std::get_if<0>(&state_); }
    const T& value() const& { return *std::get_if<0>(&state_); }
    T&& value() && { return std::move(*std::get_if<0>(&state_)); }
    const Error& error() const { return *std::get_if<1>(&state_); }

private:
    std::variant<T, Error> state_;
};

}  // namespace plateau
