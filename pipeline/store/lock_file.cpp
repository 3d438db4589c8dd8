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
    return LockState::acquired;
}

// Between open and flock the last owner may have unlinked the file. A lock on an unlinked file
// excludes nobody.
bool is_still_linked(int descriptor, const std::string& path) {
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
        if (attempt.state != LockState::acquired) {
            attempt.descriptor.reset();
            return attempt;
        }
        if (is_still_linked(attempt.descriptor.get(), path)) {
            return attempt;
        }
    }
}

void remove_abandoned_files(const std::string& folder, const std::string& prefix) {
    // The folder is listed first, so that files which other processes create or remove meanwhile do
    // not matter.
    std::error_code ignored;
    std::vector<std::string> paths;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
        if (entry.path().filename().string().starts_with(prefix)) {
            paths.push_back(entry.path().string());
        }
    }
    for (const std::string& path : paths) {
        const FileDescriptor file = open_file(path, 0);
        if (file.is_open() && lock(file.get()) == LockState::acquired &&
            is_still_linked(file.get(), path)) {
            ::unlink(path.c_str());
        }
    }
}

}  // namespace carom::pipeline
