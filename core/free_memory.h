// How much more memory this process may use.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace carom {

/// Bytes that this process can still take: the least of what the system has available
/// (MemAvailable in /proc/meminfo), what the control groups of the process leave (memory.max less
/// memory.current, version 2, of the group and of each group above it), and what the limit on its
/// address space leaves (RLIMIT_AS less the size in /proc/self/statm). Nothing where none of the
/// three can be read. `root` stands before the paths, for tests.
[[nodiscard]] std::optional<std::uint64_t> free_memory(const std::string& root = "");

}  // namespace carom
