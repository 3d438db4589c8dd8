// Lock files: one process at a time can lock a file, and the system releases the lock when the
// process ends. No function here waits without a limit.
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
    FileDescriptor descriptor;  // closed if the file is busy
};

/// Creates the file if it does not exist and locks it without waiting. The owner of the lock may
/// unlink the file: the next caller notices this and starts again with a new file. Nothing in the
/// file is changed. Throws Error if the file cannot be opened.
[[nodiscard]] LockAttempt try_lock(const std::string& path);

/// The same for a file whose name nobody else uses. Those who look for leftovers may lock it for a
/// moment, which is waited for. Throws Error, too, if it is locked for longer than five seconds.
[[nodiscard]] LockAttempt lock_own_file(const std::string& path);

/// Locks an open file that nobody else works with, in the same way.
void lock_own_file(int descriptor, const std::string& path);

/// The state of a file that exists: `acquired` if it could be locked, for it is given up at once;
/// `unsupported` also if it cannot be opened.
[[nodiscard]] LockState lock_state_of(const std::string& path);

/// Unlinks the files in `folder` whose names begin with `prefix` and that no process has locked:
/// leftovers of killed processes.
void remove_abandoned_files(const std::string& folder, const std::string& prefix);

}  // namespace carom::pipeline
