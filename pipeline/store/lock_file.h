// Files that one process at a time holds; the system frees them when it dies.
#pragma once

#include <string>

#include "pipeline/store/file_descriptor.h"

namespace carom::pipeline {

enum class LockState {
    held,         // by the caller, through the descriptor
    busy,         // somebody else holds it
    unsupported,  // the file system has no locks
};

struct LockAttempt {
    LockState state = LockState::busy;
    FileDescriptor descriptor;
};

/// Creates the file if need be and locks it without waiting. Whoever holds the lock may unlink the
/// file: the next one notices and starts over with a new file. Throws Error if the file cannot be
/// opened.
[[nodiscard]] LockAttempt try_lock(const std::string& path);

/// Unlinks the files in `folder` that nobody holds: what killed processes left.
void remove_abandoned(const std::string& folder);

}  // namespace carom::pipeline
