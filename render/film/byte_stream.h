// Plain values in a sequence of bytes, as the machine stores them.
#pragma once

#include <cstddef>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "core/error.h"

namespace carom::render {

template <class Value>
void append_value(const Value& value, std::vector<std::byte>& bytes) {
    static_assert(std::is_trivially_copyable_v<Value>);
    const auto* first = reinterpret_cast<const std::byte*>(&value);
    bytes.insert(bytes.end(), first, first + sizeof(Value));
}

/// Takes so many bytes from the front. Throws Error if there are fewer.
[[nodiscard]] inline std::span<const std::byte> take_bytes(std::size_t count,
                                                           std::span<const std::byte>& bytes) {
    if (count > bytes.size()) {
        throw Error("it ends too early");
    }
    const std::span<const std::byte> taken = bytes.first(count);
    bytes = bytes.subspan(count);
    return taken;
}

/// Takes a value from the front. Throws Error if there are too few bytes.
template <class Value>
[[nodiscard]] Value take_value(std::span<const std::byte>& bytes) {
    static_assert(std::is_trivially_copyable_v<Value>);
    Value value{};
    std::memcpy(&value, take_bytes(sizeof(Value), bytes).data(), sizeof(Value));
    return value;
}

}  // namespace carom::render
