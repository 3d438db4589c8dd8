#include "pipeline/store/group_store.h"

#include <array>
#include <memory>
#include <string_view>

#include <dirent.h>
#include <fcntl.h>
#include <grp.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.h"
#include "core/group_folder.h"
#include "pipeline/store/file_descriptor.h"

namespace carom::pipeline {
namespace {

gid_t number_of_group(const std::string& name) {
    constexpr std::size_t kLongest = 65536;  // of the group's members' names
    std::array<char, kLongest> text{};
    ::group entry{};
    ::group* found = nullptr;
    (void)::getgrnam_r(name.c_str(), &entry, text.data(), text.size(), &found);
    if (found == nullptr) {
        throw Error("there is no group '" + name + "'");
    }
    return found->gr_gid;
}

FileDescriptor open_in(int folder, const char* name) {
    return FileDescriptor(::openat(folder, name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
}

struct stat status_of(const FileDescriptor& file) {
    struct stat status {};
    (void)::fstat(file.get(), &status);
    return status;
}

/// `path` is only for messages: by name, another member of the group could have put something else
/// there.
void give(const FileDescriptor& file, mode_t mode, gid_t group, const std::string& path) {
    if (::fchown(file.get(), static_cast<uid_t>(-1), group) != 0 ||
        ::fchmod(file.get(), mode) != 0) {
        throw Error(system_problem(path, "it cannot be shared with the group"));
    }
}

/// What this user has in a folder, except what is in the folder `except`.
void give_content(const FileDescriptor& folder, gid_t group, const std::string& path,
                  std::string_view except) {
    const std::unique_ptr<DIR, int (*)(DIR*)> list(::fdopendir(::dup(folder.get())), ::closedir);
    while (const dirent* entry = list ? ::readdir(list.get()) : nullptr) {
        const std::string name = entry->d_name;
        const std::string entry_path = path + "/" + name;
        const FileDescriptor file = open_in(folder.get(), name.c_str());
        if (name == "." || name == ".." || !file.is_open()) {
            continue;  // a link, another user's, or removed just now
        }
        const struct stat status = status_of(file);
        const bool is_own = status.st_uid == ::geteuid();
        if (is_own && S_ISREG(status.st_mode)) {
            give(file, 0664, group, entry_path);
        } else if (is_own && S_ISDIR(status.st_mode)) {
            give(file, 02775 | (status.st_mode & S_ISVTX), group, entry_path);
        }
        if (S_ISDIR(status.st_mode) && name != except) {
            give_content(file, group, entry_path, "");
        }
    }
}

}  // namespace

void give_to_group(const std::string& store, const std::string& group) {
    const gid_t number = number_of_group(group);
    create_folder(store);
    const FileDescriptor folder(::open(store.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!folder.is_open()) {
        throw Error(system_problem(store, "the store cannot be shared with the group"));
    }
    const struct stat status = status_of(folder);
    const bool is_given = is_group_folder(store) && status.st_gid == number;
    if (!is_given || status.st_uid == ::geteuid()) {
        give(folder, 03775, number, store);
    }
    give_content(folder, number, store, "farm");
}

}  // namespace carom::pipeline
