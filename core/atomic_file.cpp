#include "core/atomic_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.h"
#include "core/group_folder.h"
#include "core/write_all.h"

namespace carom {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const std::string& path, int reason) {
    throw Error("cannot write '" + path + "': " + std::strerror(reason));
}

std::string folder_of(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    return slash == std::string::npos ? "." : path.substr(0, slash + 1);
}

// Makes the new name survive a power failure. The file is complete in any case, so errors are
// ignored.
void flush_folder(const std::string& folder) {
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) {
        return;
    }
    ::fsync(descriptor);
    ::close(descriptor);
}

}  // namespace

AtomicWriter::AtomicWriter(const std::string& path, FileAccess access)
    : path_(path), access_(access) {
    if (path.empty()) {
        throw Error("cannot write a file without a name");
    }
    target_ = replaceable_file(path);
    // Created exclusively, so that threads and processes never share a name. The permissions follow
    // the user's mask, which mkstemp ignores.
    for (int attempt = 0;; ++attempt) {
        name_ = fmt::format("{}/.carom-{}-{}.part", folder_of(target_), ::getpid(), attempt);
        descriptor_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor_ >= 0) {
            return;
        }
        if (errno != EEXIST || attempt == 10'000) {
            fail(path_, errno);
        }
    }
}

AtomicWriter::~AtomicWriter() {
    if (descriptor_ >= 0) {
        ::close(descriptor_);
    }
    if (!is_renamed_) {
        ::unlink(name_.c_str());
    }
}

void AtomicWriter::write(std::span<const std::byte> bytes) {
    if (!write_all(descriptor_, bytes)) {
        fail(path_, errno);
    }
}

void AtomicWriter::finish() {
    struct stat replaced {};
    if (::stat(target_.c_str(), &replaced) == 0) {
        static_cast<void>(::fchmod(descriptor_, replaced.st_mode & 0777U));
    }
    if (access_ == FileAccess::of_folder) {
        share_file(descriptor_, folder_of(target_));
    }
    if (::fsync(descriptor_) != 0) {
        fail(path_, errno);
    }
    if (::close(std::exchange(descriptor_, -1)) != 0) {
        fail(path_, errno);
    }
    if (::rename(name_.c_str(), target_.c_str()) != 0) {
        fail(path_, errno);
    }
    is_renamed_ = true;
    flush_folder(folder_of(target_));
}

void write_file_atomically(const std::string& path, std::span<const std::byte> bytes,
                           FileAccess access) {
    AtomicWriter file(path, access);
    file.write(bytes);
    file.finish();
}

std::string replaceable_file(const std::string& path) {
    constexpr int kMaxLinks = 40;  // as in Linux
    struct stat status {};
    fs::path file = path;
    for (int links = 0; ::lstat(file.c_str(), &status) == 0; ++links) {
        if (!S_ISLNK(status.st_mode)) {
            if (!S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode)) {
                throw Error("cannot write '" + path + "': it is a pipe or a device");
            }
            break;
        }
        if (links == kMaxLinks) {
            fail(path, ELOOP);
        }
        std::error_code error;
        // An absolute link replaces the folder.
        file = file.parent_path() / fs::read_symlink(file, error);
        if (error) {
            fail(path, error.value());
        }
    }
    return file.string();
}

}  // namespace carom
