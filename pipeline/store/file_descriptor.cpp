#include "pipeline/store/file_descriptor.h"

#include <cerrno>
#include <filesystem>
#include <system_error>

#include <unistd.h>

#include "core/error.h"

namespace carom::pipeline {

void FileDescriptor::reset() {
    if (descriptor_ >= 0) {
        ::close(descriptor_);
        descriptor_ = -1;
    }
}

std::string system_problem(const std::string& path, const std::string& what) {
    return "'" + path + "': " + what + ": " + std::generic_category().message(errno);
}

void create_folder(const std::string& path) {
    std::error_code failure;
    std::filesystem::create_directories(path, failure);
    if (failure) {
        throw Error("'" + path + "': the folder cannot be created: " + failure.message());
    }
}

}  // namespace carom::pipeline
