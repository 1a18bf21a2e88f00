#pragma once

#include <emscripten/val.h>

#include <cstdint>
#include <cstdio>
#include <exception>
#include <new>
#include <span>
#include <string>

#include "base/result.h"

/// Copies between the heap of the module and JavaScript. A view of the heap dies when the memory grows and drags the
/// whole heap along when it is posted, so none ever leaves this file: everything is copied out with slice().
namespace plateau::marshal {

using emscripten::val;

/// A typed array of its own with the given values (Uint8Array, Uint32Array, Float64Array by type).
template <class T>
val copied(std::span<const T> values) {
    return val(emscripten::typed_memory_view(values.size(), values.data())).template call<val>("slice");
}

/// The bytes of a text as an Uint8Array.
inline val copied_bytes(const std::string& text) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(text.data());
    return copied(std::span<const std::uint8_t>(bytes, text.size()));
}

/// The bytes of a Uint8Array or ArrayBuffer.
inline std::string bytes_of(const val& source) {
    const val array = val::global("Uint8Array").new_(source);
    std::string bytes(array["length"].as<std::size_t>(), '\0');
    auto* target = reinterpret_cast<std::uint8_t*>(bytes.data());
    val(emscripten::typed_memory_view(bytes.size(), target)).call<void>("set", array);
    return bytes;
}

/// A 64-bit hash as 16 hexadecimal digits: numbers of JavaScript hold only 53 bits.
inline std::string hex(std::uint64_t hash) {
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
    return digits;
}

/// {code, message}.
inline val failure(const Error& error) {
    val object = val::object();
    object.set("code", static_cast<unsigned>(error.code));
    object.set("message", error.message);
    return object;
}

/// {kind: 'failed', failure}.
inline val failed(const Error& error) {
    val object = val::object();
    object.set("kind", std::string("failed"));
    object.set("failure", failure(error));
    return object;
}

/// Runs `body` and turns what it throws into a value: an exception would reach JavaScript without its message.
template <class Body>
val guarded(Body body) {
    try {
        return body();
    } catch (const std::bad_alloc&) {
        return failed({ErrorCode::OutOfMemory, "The memory of this page ran out; try fewer points."});
    } catch (const std::exception& exception) {
        return failed({ErrorCode::Internal, std::string("Something broke inside: ") + exception.what()});
    }
}

}  // namespace plateau::marshal
