// Writing to a descriptor.
#pragma once

#include <cstddef>
#include <span>

namespace carom {

/// Writes all of `bytes`, in as many calls as that takes. False with errno set if one fails.
[[nodiscard]] bool write_all(int descriptor, std::span<const std::byte> bytes);

}  // namespace carom
