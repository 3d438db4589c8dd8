#include "pipeline/store/file_descriptor.h"

#include <cerrno>
#include <filesystem>
#include <system_error>

#include <sys/stat.h>
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

namespace {

/// Makes all folders of the path, and asks for none whether it is there.
std::error_code make_each(const std::string& path) {
    int error = 0;
    std::filesystem::path made;
    for (const std::filesystem::path& part : std::filesystem::path(path)) {
        made /= part;
        const bool exists = ::mkdir(made.c_str(), 0777) == 0 || errno == EEXIST;
        error = exists ? 0 : errno;
    }
    return {error, std::generic_category()};
}

}  // namespace

void create_folder(const std::string& path) {
    std::error_code failure;
    std::filesystem::create_directories(path, failure);
    if (failure == std::errc::file_exists) {
        // Another machine made it at the same moment, and a network file system does not show it
        // yet: it exists for who makes it, but not for who looks for it.
        failure = make_each(path);
    }
    if (failure) {
        throw Error("'" + path + "': the folder cannot be created: " + failure.message());
    }
}

}  // namespace carom::pipeline
