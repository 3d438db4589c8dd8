#include "pipeline/store/file_descriptor.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <system_error>
#include <thread>

#include <fmt/core.h>
#include <grp.h>
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.h"
#include "core/group_folder.h"

namespace carom::pipeline {

void FileDescriptor::reset() {
    if (descriptor_ >= 0) {
        ::close(descriptor_);
        descriptor_ = -1;
    }
}

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestEntry = 16384;  // bytes of what the system knows of a user or group

std::string name_of_user(uid_t user) {
    std::array<char, kLongestEntry> text{};
    passwd entry{};
    passwd* found = nullptr;
    (void)::getpwuid_r(user, &entry, text.data(), text.size(), &found);
    return found != nullptr ? found->pw_name : std::to_string(user);
}

std::string name_of_group(gid_t group) {
    std::array<char, kLongestEntry> text{};
    ::group entry{};
    ::group* found = nullptr;
    (void)::getgrgid_r(group, &entry, text.data(), text.size(), &found);
    return found != nullptr ? found->gr_name : std::to_string(group);
}

/// Whose the file is, or the folder in which it cannot be made.
std::string owner_text(fs::path path) {
    struct stat status {};
    while (::lstat(path.c_str(), &status) != 0) {
        if (!path.has_relative_path()) {
            return "";
        }
        path = path.has_parent_path() ? path.parent_path() : fs::path(".");
    }
    return fmt::format("; '{}' belongs to the user {} and the group {}, mode {:o}", path.string(),
                       name_of_user(status.st_uid), name_of_group(status.st_gid),
                       status.st_mode & 07777U);
}

/// Makes a folder and those above it that are missing. That it exists is no failure: another
/// machine may have made it at the same moment, and a network file system does not show it yet. Nor
/// can a folder be made in it until it is shown, for which this waits up to three seconds.
std::error_code make_folder(const fs::path& path) {
    std::error_code ignored;
    if (path.empty() || fs::is_directory(path, ignored)) {
        return {};
    }
    if (const std::error_code failure = make_folder(path.parent_path())) {
        return failure;
    }
    constexpr int kTries = 60;
    for (int i = 0; i < kTries; ++i) {
        if (::mkdir(path.c_str(), 0777) == 0) {
            share_folder(path.string());
            return {};
        }
        if (errno != ENOENT) {
            break;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    const int reason = errno;  // the next question sets it anew
    if (reason == EEXIST) {
        return {fs::is_regular_file(path, ignored) ? ENOTDIR : 0, std::generic_category()};
    }
    return {reason, std::generic_category()};
}

}  // namespace

std::string system_problem(const std::string& path, const std::string& what) {
    const int reason = errno;
    return fmt::format("'{}': {}: {}{}", path, what, std::generic_category().message(reason),
                       reason == EACCES || reason == EPERM ? owner_text(path) : "");
}

std::string name_of_owner(const std::string& path) {
    struct stat status {};
    return ::stat(path.c_str(), &status) == 0 ? name_of_user(status.st_uid) : "";
}

void create_folder(const std::string& path) {
    if (const std::error_code failure = make_folder(path)) {
        errno = failure.value();
        throw Error(system_problem(path, "the folder cannot be created"));
    }
}

}  // namespace carom::pipeline
