#include "pipeline/store/lock_file.h"

#include <cerrno>
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "sim/timeline/error.h"

namespace carom::pipeline {
namespace {

namespace fs = std::filesystem;

FileDescriptor open_or_create(const std::string& path) {
    const auto open_file = [&path] {
        return FileDescriptor(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666));
    };
    FileDescriptor file = open_file();
    if (!file.is_open() && errno == ENOENT) {
        create_folder(fs::path(path).parent_path().string());
        file = open_file();
    }
    if (!file.is_open()) {
        throw Error(system_problem(path, "the lock file cannot be opened"));
    }
    return file;
}

LockState lock(int descriptor) {
    while (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
        if (errno == EWOULDBLOCK) {
            return LockState::busy;
        }
        if (errno != EINTR) {
            return LockState::unsupported;
        }
    }
    return LockState::held;
}

// Between open and flock the last owner may have unlinked the file; a lock on it means nothing.
bool still_has_its_name(int descriptor, const std::string& path) {
    struct stat opened {};
    struct stat named {};
    return ::fstat(descriptor, &opened) == 0 && ::stat(path.c_str(), &named) == 0 &&
           opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

}  // namespace

LockAttempt try_lock(const std::string& path) {
    while (true) {
        LockAttempt attempt;
        attempt.descriptor = open_or_create(path);
        attempt.state = lock(attempt.descriptor.get());
        if (attempt.state != LockState::held) {
            attempt.descriptor.reset();
            return attempt;
        }
        if (still_has_its_name(attempt.descriptor.get(), path)) {
            return attempt;
        }
    }
}

void remove_abandoned(const std::string& folder) {
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
        const std::string path = entry.path().string();
        try {
            const LockAttempt attempt = try_lock(path);
            if (attempt.state == LockState::held) {
                ::unlink(path.c_str());
            }
        } catch (const Error&) {
            // Somebody else's file: theirs to remove.
        }
    }
}

}  // namespace carom::pipeline
