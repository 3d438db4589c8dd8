#include "pipeline/store/group_store.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <memory>
#include <system_error>
#include <utility>
#include <vector>

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
    constexpr std::size_t kShort = 4096;
    constexpr std::size_t kLongest = std::size_t{1} << 26U;  // of the group's members' names
    std::vector<char> text(kShort);
    ::group entry{};
    ::group* found = nullptr;
    int failure = 0;
    while ((failure = ::getgrnam_r(name.c_str(), &entry, text.data(), text.size(), &found)) ==
               ERANGE &&
           text.size() < kLongest) {
        text.resize(2 * text.size());
    }
    if (found != nullptr) {
        return found->gr_gid;
    }
    // getgrnam(3): some systems say by these that there is none
    constexpr std::array kNone{0, ENOENT, ESRCH, EBADF, EPERM};
    if (std::ranges::find(kNone, failure) != kNone.end()) {
        throw Error("there is no group '" + name + "'");
    }
    throw Error("the group '" + name +
                "' cannot be looked up: " + std::generic_category().message(failure));
}

[[noreturn]] void fail(const std::string& path) {
    throw Error(system_problem(path, "it cannot be shared with the group"));
}

/// Sets the mode and the group if they are other ones. `path` is only for messages: by name,
/// another member of the group could have put something else there.
void give(const FileDescriptor& file, mode_t mode, gid_t group, const std::string& path) {
    struct stat status {};
    if (::fstat(file.get(), &status) != 0) {
        fail(path);
    }
    // chown clears set-group-ID.
    const bool is_of_group = status.st_gid == group;
    if ((!is_of_group && ::fchown(file.get(), static_cast<uid_t>(-1), group) != 0) ||
        ((!is_of_group || (status.st_mode & 07777U) != mode) && ::fchmod(file.get(), mode) != 0)) {
        fail(path);
    }
}

/// What this user has in a folder of the store.
class Content {
  public:
    Content(gid_t group, std::stop_token stop) : group_(group), stop_(std::move(stop)) {}

    /// Gives all that is in the folder, and below it if it is not that of jobs.
    void give_all_in(const FileDescriptor& folder, const std::string& path, bool is_store) const {
        const int again = ::fcntl(folder.get(), F_DUPFD_CLOEXEC, 0);
        const std::unique_ptr<DIR, int (*)(DIR*)> list(::fdopendir(again), ::closedir);
        if (!list) {
            const FileDescriptor unused(again);
            fail(path);
        }
        while (const dirent* entry = next(*list, path)) {
            const std::string name = entry->d_name;
            if (name != "." && name != "..") {
                std::string below = path;
                below.append("/").append(name);
                give_one(folder, name, below, is_store && name == "farm");
            }
        }
    }

  private:
    [[nodiscard]] const dirent* next(DIR& list, const std::string& path) const {
        if (stop_.stop_requested()) {
            throw Stopped();
        }
        errno = 0;
        const dirent* entry = ::readdir(&list);
        if (entry == nullptr && errno != 0) {
            fail(path);
        }
        return entry;
    }

    /// Files that are right already are not opened, for a store may have a million.
    void give_one(const FileDescriptor& folder, const std::string& name, const std::string& path,
                  bool is_of_jobs) const {
        struct stat status {};
        if (::fstatat(folder.get(), name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0) {
            return;  // removed just now
        }
        const bool is_own = status.st_uid == ::geteuid();
        const bool is_folder = S_ISDIR(status.st_mode);
        const bool is_right = status.st_gid == group_ && (status.st_mode & 07777U) == kFileMode;
        if (!is_folder && (!is_own || is_right || !S_ISREG(status.st_mode))) {
            return;
        }
        const FileDescriptor file(
            ::openat(folder.get(), name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
        struct stat opened {};
        if (!file.is_open() || ::fstat(file.get(), &opened) != 0 ||
            opened.st_uid != status.st_uid || S_ISDIR(opened.st_mode) != is_folder) {
            return;  // another user's, or it was replaced just now
        }
        if (is_own) {
            const mode_t sticky = is_of_jobs ? S_ISVTX : opened.st_mode & S_ISVTX;
            give(file, is_folder ? 02775 | sticky : kFileMode, group_, path);
        }
        if (is_folder && !is_of_jobs) {
            give_all_in(file, path, false);
        }
    }

    static constexpr mode_t kFileMode = 0664;

    gid_t group_;
    std::stop_token stop_;
};

}  // namespace

void give_to_group(const std::string& store, const std::string& group,
                   const std::stop_token& stop) {
    const gid_t number = number_of_group(group);
    create_folder(store);
    const FileDescriptor folder(::open(store.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    struct stat status {};
    if (!folder.is_open() || ::fstat(folder.get(), &status) != 0) {
        throw Error(system_problem(store, "the store cannot be shared with the group"));
    }
    // One that is the group's may keep all others out.
    const bool is_given = is_group_folder(store) && status.st_gid == number;
    if (!is_given || status.st_uid == ::geteuid()) {
        give(folder, is_given ? (status.st_mode & 07777U) | S_ISVTX : 03775, number, store);
    }
    // Now, so that it belongs to whoever gives the store away: its owner can replace jobs in it.
    create_folder(store + "/farm");
    Content(number, stop).give_all_in(folder, store, true);
}

}  // namespace carom::pipeline
