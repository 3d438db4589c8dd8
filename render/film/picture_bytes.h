// Writes files whose bytes are complete in memory, so that no library loses the error of a write.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace carom::render {

/// Throws Error "'PATH': the picture cannot be written: WHY" if the file cannot be written.
void write_picture_bytes(const std::string& path, std::span<const std::byte> bytes);

/// Throws this Error.
[[noreturn]] void refuse_to_write(const std::string& path, const std::string& why);

}  // namespace carom::render
