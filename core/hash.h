// Content hashes: XXH3-128 (Collet, xxHash specification 0.8) over a canonical byte stream.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "core/vectors.h"

namespace carom {

struct Hash128 {
    std::uint64_t high = 0;
    std::uint64_t low = 0;

    // clang-tidy mistakes the 0 with which a defaulted <=> compares for a null pointer.
    auto operator<=>(const Hash128&) const = default;  // NOLINT(modernize-use-nullptr)

    /// 32 lower-case hexadecimal digits.
    [[nodiscard]] std::string to_string() const;
};

/// Hashes a sequence of values. Every value is encoded with its type and its length or a fixed
/// size, little endian, so that two different sequences of calls never produce the same bytes. -0.0
/// is hashed as 0.0; a NaN is a programming error.
class Hasher {
  public:
    Hasher();
    ~Hasher();
    Hasher(const Hasher&) = delete;
    Hasher& operator=(const Hasher&) = delete;
    Hasher(Hasher&&) = delete;
    Hasher& operator=(Hasher&&) = delete;

    Hasher& add(bool value);
    Hasher& add(std::int64_t value);
    Hasher& add(std::uint64_t value);
    Hasher& add(std::int32_t value) { return add(std::int64_t{value}); }
    Hasher& add(std::uint32_t value) { return add(std::uint64_t{value}); }
    Hasher& add(double value);
    Hasher& add(float value);
    Hasher& add(std::string_view text);
    Hasher& add(const char* text) { return add(std::string_view(text)); }
    Hasher& add(const Vec2& value);
    Hasher& add(const Vec3& value);
    Hasher& add(const Quat& value);
    Hasher& add(const Mat44& value);
    Hasher& add(const Hash128& value);
    Hasher& add_bytes(std::span<const std::byte> bytes);

    [[nodiscard]] Hash128 finish() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// XXH3-128 of the bytes, without type and length.
[[nodiscard]] Hash128 hash_bytes(std::span<const std::byte> bytes);

/// hash_bytes of the contents of a file. Throws an Error that names the file if it cannot be read.
[[nodiscard]] Hash128 hash_file(const std::string& path);

}  // namespace carom
