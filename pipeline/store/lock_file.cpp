#include "pipeline/store/lock_file.h"

#include <cerrno>
#include <chrono>
#include <filesystem>
#include <system_error>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.h"
#include "core/group_folder.h"

namespace carom::pipeline {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kLongestWait{5};
constexpr int kMostFiles = 100;  // that others remove before they are locked

FileDescriptor open_file(const std::string& path, int flags) {
    return FileDescriptor(::open(path.c_str(), O_RDWR | O_CLOEXEC | flags, 0666));
}

FileDescriptor open_or_create(const std::string& path) {
    const std::string folder = fs::path(path).parent_path().string();
    FileDescriptor file = open_file(path, O_CREAT);
    if (!file.is_open() && errno == ENOENT) {
        create_folder(folder);
        file = open_file(path, O_CREAT);
    }
    if (!file.is_open()) {
        throw Error(system_problem(path, "the lock file cannot be opened"));
    }
    share_file(file.get(), folder);
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
    for (int i = 0; i < kMostFiles; ++i) {
        LockAttempt attempt;
        attempt.descriptor = open_or_create(path);
        attempt.state = lock(attempt.descriptor.get());
        if (attempt.state == LockState::busy) {
            attempt.descriptor.reset();
            return attempt;
        }
        if (attempt.state == LockState::unsupported ||
            is_still_linked(attempt.descriptor.get(), path)) {
            return attempt;
        }
    }
    throw Error(
        fmt::format("'{}': the file cannot be locked: it is removed again and again, or "
                    "the file system does not know it again",
                    path));
}

namespace {

/// Between attempts to lock a file that should be free in a moment.
class Patience {
  public:
    explicit Patience(const std::string& path) : path_(path) {}

    /// Throws Error if there were attempts for long enough.
    void wait() const {
        if (Clock::now() > end_) {
            throw Error(fmt::format(
                "'{}': the file cannot be locked: another process has locked it for {} s", path_,
                kLongestWait.count()));
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }

  private:
    const std::string& path_;
    Clock::time_point end_ = Clock::now() + kLongestWait;
};

}  // namespace

LockAttempt lock_own_file(const std::string& path) {
    const Patience patience(path);
    LockAttempt attempt = try_lock(path);
    while (attempt.state == LockState::busy) {
        patience.wait();
        attempt = try_lock(path);
    }
    return attempt;
}

void lock_own_file(int descriptor, const std::string& path) {
    const Patience patience(path);
    while (lock(descriptor) == LockState::busy) {
        patience.wait();
    }
}

LockState lock_state_of(const std::string& path) {
    // To lock a file of another user it is enough to read it, except on network file systems.
    FileDescriptor file = open_file(path, 0);
    if (!file.is_open() && errno == EACCES) {
        file = FileDescriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    }
    return file.is_open() ? lock(file.get()) : LockState::unsupported;
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
