#include "core/file_reader.h"

#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.h"

namespace carom {

FileReader::FileReader(std::string path)
    : path_(std::move(path)), descriptor_(::open(path_.c_str(), O_RDONLY | O_CLOEXEC)) {
    if (descriptor_ < 0) {
        fail();
    }
}

FileReader::~FileReader() {
    ::close(descriptor_);
}

std::optional<std::size_t> FileReader::size() const {
    struct stat status {};
    if (::fstat(descriptor_, &status) != 0) {
        fail();
    }
    if (S_ISDIR(status.st_mode)) {
        errno = EISDIR;
        fail();
    }
    if (!S_ISREG(status.st_mode)) {
        return {};
    }
    return static_cast<std::size_t>(status.st_size);
}

std::size_t FileReader::read(std::span<std::byte> bytes) {
    std::size_t filled = 0;
    while (filled < bytes.size()) {
        const ::ssize_t size = ::read(descriptor_, bytes.data() + filled, bytes.size() - filled);
        if (size == 0) {
            break;
        }
        if (size > 0) {
            filled += static_cast<std::size_t>(size);
        } else if (errno != EINTR) {
            fail();
        }
    }
    return filled;
}

void FileReader::fail() const {
    throw Error("cannot read '" + path_ + "': " + std::strerror(errno));
}

}  // namespace carom
