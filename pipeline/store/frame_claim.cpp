#include <utility>

#include <unistd.h>

#include "pipeline/store/frame_store.h"

namespace carom::pipeline {

FrameClaim::FrameClaim(int lock_descriptor, std::string path)
    : lock_descriptor_(lock_descriptor), path_(std::move(path)) {}

// The file is unlinked while it is still locked, so that no other process can lock it in between.
FrameClaim::~FrameClaim() {
    if (lock_descriptor_ >= 0) {
        ::unlink(path_.c_str());
        ::close(lock_descriptor_);
    }
}

FrameClaim::FrameClaim(FrameClaim&& other) noexcept
    : lock_descriptor_(std::exchange(other.lock_descriptor_, -1)), path_(std::move(other.path_)) {}

FrameClaim& FrameClaim::operator=(FrameClaim&& other) noexcept {
    std::swap(lock_descriptor_, other.lock_descriptor_);
    std::swap(path_, other.path_);
    return *this;
}

}  // namespace carom::pipeline
