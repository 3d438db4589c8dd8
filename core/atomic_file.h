// A file appears under its name only when it is whole.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace carom {

/// Writes `bytes` to a temporary name beside the file that `path` names, flushes it to disk and
/// renames it to that. A link stays, what it leads to is replaced. Throws Error with the system's
/// reason; no temporary file is left then.
void write_file_atomically(const std::string& path, std::span<const std::byte> bytes);

/// The name that a whole file takes for `path`: where links lead, there or not yet. Throws Error if
/// that is a pipe, a device or a socket, which a file of its name would end, or a circle of links.
[[nodiscard]] std::string replaceable_file(const std::string& path);

}  // namespace carom
