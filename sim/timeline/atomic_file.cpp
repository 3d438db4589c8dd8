#include "sim/timeline/atomic_file.h"

#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "sim/timeline/error.h"

namespace carom {

namespace {

[[noreturn]] void fail(const std::string& path, int reason) {
    throw Error("cannot write '" + path + "': " + std::strerror(reason));
}

std::string folder_of(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    return slash == std::string::npos ? "." : path.substr(0, slash + 1);
}

/// A file under a name of its own that is removed again unless it got its final one.
class TemporaryFile {
  public:
    explicit TemporaryFile(std::string target) : target_(std::move(target)) {
        // Created exclusively, so that threads and processes never share a name; with the rights
        // that the user's mask gives, which mkstemp does not honour.
        for (int attempt = 0;; ++attempt) {
            name_ = folder_of(target_) + "/.carom-" + std::to_string(::getpid()) + "-" +
                    std::to_string(attempt) + ".part";
            descriptor_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
            if (descriptor_ >= 0)
                return;
            if (errno != EEXIST || attempt == 10'000)
                fail(target_, errno);
        }
    }
    ~TemporaryFile() {
        if (descriptor_ >= 0)
            ::close(descriptor_);
        if (!is_renamed_)
            ::unlink(name_.c_str());
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    TemporaryFile(TemporaryFile&&) = delete;
    TemporaryFile& operator=(TemporaryFile&&) = delete;

    void write(std::span<const std::byte> bytes) {
        while (!bytes.empty()) {
            const ::ssize_t size = ::write(descriptor_, bytes.data(), bytes.size());
            if (size < 0 && errno != EINTR)
                fail(target_, errno);
            if (size > 0)
                bytes = bytes.subspan(static_cast<std::size_t>(size));
        }
    }

    void finish() {
        if (::fsync(descriptor_) != 0)
            fail(target_, errno);
        if (::close(std::exchange(descriptor_, -1)) != 0)
            fail(target_, errno);
        if (::rename(name_.c_str(), target_.c_str()) != 0)
            fail(target_, errno);
        is_renamed_ = true;
    }

  private:
    std::string target_;
    std::string name_;
    int descriptor_ = -1;
    bool is_renamed_ = false;
};

// Makes the new name survive a power cut. The file is whole either way, so failure is not one.
void flush_folder(const std::string& folder) {
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0)
        return;
    ::fsync(descriptor);
    ::close(descriptor);
}

}  // namespace

void write_file_atomically(const std::string& path, std::span<const std::byte> bytes) {
    if (path.empty())
        throw Error("cannot write a file without a name");
    check_replaceable(path);
    TemporaryFile file(path);
    file.write(bytes);
    file.finish();
    flush_folder(folder_of(path));
}

void check_replaceable(const std::string& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode))
        throw Error("cannot write '" + path + "': it is a pipe or a device");
}

}  // namespace carom
