// Complete writes to a file descriptor.
#pragma once

#include <cstddef>
#include <span>

namespace carom {

/// Writes all of `bytes`, in as many calls as needed. Returns false and sets errno if one fails.
[[nodiscard]] bool write_all(int descriptor, std::span<const std::byte> bytes);

}  // namespace carom
