#include "core/group_folder.h"

#include <filesystem>

#include <sys/stat.h>

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
    if (is_group_folder(std::filesystem::path(path).parent_path().string())) {
        static_cast<void>(::chmod(path.c_str(), 02775));
    }
}

}  // namespace carom
