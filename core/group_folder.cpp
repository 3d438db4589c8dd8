#include "core/group_folder.h"

#include <filesystem>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace carom {

bool is_group_folder(const std::string& path) {
    struct stat status {};
    return ::stat(path.empty() ? "." : path.c_str(), &status) == 0 && S_ISDIR(status.st_mode) &&
           (status.st_mode & S_ISGID) != 0 && (status.st_mode & S_IWGRP) != 0;
}

void share_file(int descriptor, const std::string& folder) {
    if (is_group_folder(folder)) {
        static_cast<void>(::fchmod(descriptor, 0664));
    }
}

void share_folder(const std::string& path) {
    if (!is_group_folder(std::filesystem::path(path).parent_path().string())) {
        return;
    }
    // By name, a member of the group could have put a link there.
    const int folder = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    struct stat status {};
    if (folder >= 0 && ::fstat(folder, &status) == 0 && status.st_uid == ::geteuid()) {
        static_cast<void>(::fchmod(folder, 02775));
    }
    if (folder >= 0) {
        ::close(folder);
    }
}

}  // namespace carom
