// Atomic writing of files: a file gets its name only when it is complete.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace carom {

/// Writes `bytes` to a temporary file beside `path`, flushes it to disk and renames it to `path`.
/// If `path` is a link, its target is replaced. Throws Error with the system's reason and leaves no
/// temporary file.
void write_file_atomically(const std::string& path, std::span<const std::byte> bytes);

/// The final name of a file for `path`: the target of its links, which need not exist. Throws Error
/// if that is a pipe, a device or a socket, which must not be replaced by a file, or if the links
/// form a cycle.
[[nodiscard]] std::string replaceable_file(const std::string& path);

}  // namespace carom
