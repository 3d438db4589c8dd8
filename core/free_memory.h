// The amount of memory that this process may still allocate.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace carom {

/// Bytes that this process can still allocate: the least of the system's available memory
/// (MemAvailable in /proc/meminfo), the remainder in the control groups of the process (version 2:
/// memory.max less memory.current, of the group and all groups above it) and the remainder of its
/// address space (RLIMIT_AS less the size in /proc/self/statm). Empty if none of the three can be
/// read. `root` is a prefix of the paths, for tests.
[[nodiscard]] std::optional<std::uint64_t> free_memory(const std::string& root = "");

/// Gives freed memory back to the system, of which malloc keeps what lies between blocks in use.
void give_back_freed_memory();

}  // namespace carom
