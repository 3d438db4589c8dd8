#include "pipeline/video/pending_file.h"

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/atomic_file.h"
#include "core/error.h"

namespace carom::pipeline {

namespace fs = std::filesystem;

namespace {

std::string system_text(int error) {
    return std::generic_category().message(error);
}

fs::path folder_of(const fs::path& target) {
    return target.has_parent_path() ? target.parent_path() : fs::path(".");
}

std::string leftover_prefix(const fs::path& target) {
    return "." + target.filename().string() + ".";
}
/// The suffix for `target` as the user names it: writers choose the format by the extension.
std::string leftover_suffix(const fs::path& target) {
    return ".part" + target.extension().string();
}

/// A text that is unique among all objects of all processes on the machine.
std::string unique_middle() {
    static std::atomic<std::uint64_t> count{0};
    return fmt::format("{}-{}", ::getpid(), count.fetch_add(1));
}

bool is_linked(int descriptor) {
    struct stat status {};
    return ::fstat(descriptor, &status) == 0 && status.st_nlink > 0;
}

void flush_to_disk(const std::string& path, const std::string& target) {
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    const bool flushed =
        descriptor >= 0 &&
        (::fsync(descriptor) == 0 || errno == EINVAL);  // EINVAL: the file system has no disk
    const int error = errno;
    if (descriptor >= 0) {
        ::close(descriptor);
    }
    if (!flushed) {
        throw Error("cannot write '" + target + "': " + system_text(error));
    }
}

/// Flushes the folder, so that the new name survives a power failure. The file is complete in any
/// case, so a failure is not an error.
void flush_folder(const fs::path& folder) {
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor >= 0) {
        ::fsync(descriptor);
        ::close(descriptor);
    }
}

}  // namespace

PendingFile::PendingFile(std::string target)
    : target_(std::move(target)), file_(replaceable_file(target_)) {
    std::error_code ignored;
    if (fs::is_directory(file_, ignored)) {
        throw Error("cannot write '" + target_ + "': it is a folder");
    }
    remove_leftovers();
    create();
}

PendingFile::~PendingFile() {
    discard();
}

void PendingFile::create() {
    const fs::path target(file_);
    constexpr int kTries =
        16;  // a leftover has this name, or another process removed the file before flock
    for (int i = 0; i < kTries; ++i) {
        const std::string name =
            leftover_prefix(target) + unique_middle() + leftover_suffix(target_);
        temporary_path_ = (folder_of(target) / name).string();
        lock_descriptor_ =
            ::open(temporary_path_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (lock_descriptor_ < 0) {
            if (errno == EEXIST) {
                continue;
            }
            throw Error("cannot write '" + target_ + "': " + system_text(errno));
        }
        // On file systems without locks (some network file systems) nobody removes leftovers
        // either.
        static_cast<void>(::flock(lock_descriptor_, LOCK_EX | LOCK_NB));
        if (is_linked(lock_descriptor_)) {
            return;
        }
        ::close(std::exchange(lock_descriptor_, -1));
    }
    throw Error("cannot write '" + target_ + "': no temporary name beside it is free");
}

void PendingFile::remove_leftovers() const {
    const fs::path target(file_);
    const std::string prefix = leftover_prefix(target);
    const std::string suffix = leftover_suffix(target_);
    std::error_code ignored;
    for (fs::directory_iterator entry(folder_of(target), ignored), end; !ignored && entry != end;
         entry.increment(ignored)) {
        const std::string name = entry->path().filename().string();
        if (name.size() <= prefix.size() + suffix.size() || !name.starts_with(prefix) ||
            !name.ends_with(suffix)) {
            continue;
        }
        const int descriptor = ::open(entry->path().c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW);
        if (descriptor < 0) {
            continue;
        }
        if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0) {
            ::unlink(entry->path().c_str());
        }
        ::close(descriptor);
    }
}

void PendingFile::commit() {
    flush_to_disk(temporary_path_, target_);
    if (::rename(temporary_path_.c_str(), file_.c_str()) != 0) {
        throw Error("cannot write '" + target_ + "': " + system_text(errno));
    }
    temporary_path_.clear();
    ::close(std::exchange(lock_descriptor_, -1));
    flush_folder(folder_of(file_));
}

void PendingFile::discard() noexcept {
    if (lock_descriptor_ >= 0) {
        if (!temporary_path_.empty()) {
            ::unlink(temporary_path_.c_str());
        }
        ::close(std::exchange(lock_descriptor_, -1));
    }
}

}  // namespace carom::pipeline
