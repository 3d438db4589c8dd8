// Lock files: one process at a time can lock a file, and the system releases the lock when the
// process ends.
#pragma once

#include <string>

#include "pipeline/store/file_descriptor.h"

namespace carom::pipeline {

enum class LockState {
    acquired,     // by the caller, for as long as the descriptor is open
    busy,         // another process or descriptor has locked the file
    unsupported,  // the file system has no locks
};

struct LockAttempt {
    LockState state = LockState::busy;
    FileDescriptor descriptor;
};

/// Creates the file if it does not exist and locks it without waiting. The owner of the lock may
/// unlink the file: the next caller notices this and starts again with a new file. Throws Error if
/// the file cannot be opened.
[[nodiscard]] LockAttempt try_lock(const std::string& path);

/// Unlinks the files in `folder` whose names begin with `prefix` and that no process has locked:
/// leftovers of killed processes.
void remove_abandoned_files(const std::string& folder, const std::string& prefix);

}  // namespace carom::pipeline
