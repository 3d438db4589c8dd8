#include "core/write_all.h"

#include <cerrno>

#include <unistd.h>

namespace carom {

bool write_all(int descriptor, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ::ssize_t size = ::write(descriptor, bytes.data(), bytes.size());
        if (size < 0 && errno != EINTR) {
            return false;
        }
        if (size > 0) {
            bytes = bytes.subspan(static_cast<std::size_t>(size));
        }
    }
    return true;
}

}  // namespace carom
