#include "pipeline/server/body.h"

#include <algorithm>
#include <cerrno>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace carom::server {

Body::Body(std::shared_ptr<const std::string> bytes)
    : bytes_(std::move(bytes)), size_(bytes_->size()), left_{0, size_} {}

/// A descriptor, which is closed at the end.
class Body::OpenFile {
  public:
    explicit OpenFile(int descriptor) : descriptor_(descriptor) {}
    ~OpenFile() { ::close(descriptor_); }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;

    [[nodiscard]] int descriptor() const { return descriptor_; }

  private:
    int descriptor_;
};

std::optional<Body> Body::open(const std::string& path) {
    // O_NONBLOCK: opening a pipe must not wait for its other end.
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor < 0) {
        return std::nullopt;
    }
    Body body;
    body.file_ = std::make_shared<const OpenFile>(descriptor);
    struct stat status {};
    if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) {
        return std::nullopt;
    }
    body.size_ = static_cast<std::uint64_t>(status.st_size);
    body.left_ = {0, body.size_};
    return body;
}

std::size_t Body::read(std::span<char> bytes) {
    const auto wanted =
        static_cast<std::size_t>(std::min<std::uint64_t>(bytes.size(), bytes_left()));
    if (bytes_) {
        std::copy_n(bytes_->data() + left_.begin, wanted, bytes.data());
        left_.begin += wanted;
        return wanted;
    }
    ssize_t count = 0;
    do {
        count = file_ ? ::pread(file_->descriptor(), bytes.data(), wanted,
                                static_cast<off_t>(left_.begin))
                      : 0;
    } while (count < 0 && errno == EINTR);
    const auto read = static_cast<std::size_t>(std::max<ssize_t>(count, 0));
    left_.begin += read;
    return read;
}

}  // namespace carom::server
