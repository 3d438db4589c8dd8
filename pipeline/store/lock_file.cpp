#include "pipeline/store/lock_file.h"

#include <cerrno>
#include <filesystem>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.h"

namespace carom::pipeline {
namespace {

namespace fs = std::filesystem;

FileDescriptor open_file(const std::string& path, int flags) {
    return FileDescriptor(::open(path.c_str(), O_RDWR | O_CLOEXEC | flags, 0666));
}

FileDescriptor open_or_create(const std::string& path) {
    FileDescriptor file = open_file(path, O_CREAT);
    if (!file.is_open() && errno == ENOENT) {
        create_folder(fs::path(path).parent_path().string());
        file = open_file(path, O_CREAT);
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
    // Listed first: what others create and remove meanwhile is not ours to chase.
    std::error_code ignored;
    std::vector<std::string> paths;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
        paths.push_back(entry.path().string());
    }
    for (const std::string& path : paths) {
        const FileDescriptor file = open_file(path, 0);
        if (file.is_open() && lock(file.get()) == LockState::held &&
            still_has_its_name(file.get(), path)) {
            ::unlink(path.c_str());
        }
    }
}

}  // namespace carom::pipeline
