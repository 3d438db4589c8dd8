// A file appears under its name only when it is whole.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace carom {

/// Writes `bytes` to a temporary name in the same folder, flushes it to disk and renames it to
/// `path`. Throws Error with the system's reason; no temporary file is left then.
void write_file_atomically(const std::string& path, std::span<const std::byte> bytes);

/// Throws Error if `path` is a pipe, a device or a socket: a file that takes its name would end it.
void check_replaceable(const std::string& path);

}  // namespace carom
