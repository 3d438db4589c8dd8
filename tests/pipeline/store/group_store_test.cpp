#include "pipeline/store/group_store.h"

#include <cerrno>
#include <filesystem>
#include <functional>
#include <stop_token>

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <grp.h>
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.h"
#include "core/group_folder.h"
#include "pipeline/store/pins.h"
#include "tests/folders.h"
#include "tests/pipeline/store/child_process.h"
#include "tests/pipeline/store/sample_frames.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

using carom::testing::ChildProcess;
using carom::testing::make_film;
using carom::testing::make_key;
using carom::testing::ScratchFolder;
using carom::testing::write_text;
using ::testing::ThrowsMessage;

namespace fs = std::filesystem;

/// The user's mask, until the end of a test.
class Mask {
  public:
    explicit Mask(mode_t mask) : before_(::umask(mask)) {}
    ~Mask() { ::umask(before_); }
    Mask(const Mask&) = delete;
    Mask& operator=(const Mask&) = delete;
    Mask(Mask&&) = delete;
    Mask& operator=(Mask&&) = delete;

  private:
    mode_t before_;
};

mode_t mode_of(const std::string& path) {
    struct stat status {};
    EXPECT_EQ(::lstat(path.c_str(), &status), 0) << path;
    return status.st_mode & 07777U;
}

/// The modes of all that is below a folder, "2775 frames", except what has the mode that it should
/// have in a group's store.
std::vector<std::string> wrong_modes(const std::string& folder) {
    std::vector<std::string> wrong;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const mode_t mode = mode_of(entry.path());
        const mode_t folder_mode = entry.path() == folder + "/farm" ? 03775U : 02775U;
        if (mode != (entry.is_directory() ? folder_mode : 0664U)) {
            wrong.push_back(
                fmt::format("{:o} {}", mode, entry.path().lexically_relative(folder).string()));
        }
    }
    return wrong;
}

std::string own_group() {
    return ::getgrgid(::getegid())->gr_name;
}

/// What a film leaves in a store while it is made.
void use(const std::string& store, const std::function<void()>& look) {
    const FrameStore frames(store + "/frames");
    const std::optional<Claim> claim = frames.claim(make_key(1));
    const PartialFile partial = frames.begin_file(make_key(2));
    frames.write(make_key(3), make_film(3), {});
    frames.write_noisy(make_key(3), make_film(3));
    const Pin pin(store, {});
    write_job_pin(store, {"a-1", "", 0}, {});
    look();
}

TEST(GroupStore, WhateverTheMask_AllInItIsTheGroups) {
    const ScratchFolder folder;
    const std::string store = folder.path("a/store");
    const Mask mask(077);
    give_to_group(store, own_group(), {});
    EXPECT_TRUE(is_group_folder(store));
    EXPECT_EQ(mode_of(store), 03775U) << "nobody may replace the folders of others";
    EXPECT_EQ(mode_of(store + "/farm"), 03775U) << "nor their jobs";
    use(store, [&] { EXPECT_THAT(wrong_modes(store), ::testing::IsEmpty()); });
}

TEST(GroupStore, OtherStores_FollowTheMask) {
    const ScratchFolder folder;
    const std::string store = folder.path("store");
    const Mask mask(027);
    use(store, [&] {
        for (const auto& entry : fs::recursive_directory_iterator(store)) {
            EXPECT_EQ(mode_of(entry.path()), entry.is_directory() ? 0750U : 0640U) << entry.path();
        }
    });
}

TEST(GroupStore, StoreThatExists_IsGivenWithItsContentButNotItsJobs) {
    const ScratchFolder folder;
    const std::string store = folder.path("store");
    {
        const Mask mask(077);
        use(store, [] {});
        fs::create_directories(store + "/farm/a-1");
        write_text(store + "/farm/a-1/worker.sh", "");
        write_text(folder.path("outside"), "");
        fs::create_symlink(folder.path("outside"), store + "/frames/link");
    }
    give_to_group(store, own_group(), {});
    EXPECT_THAT(wrong_modes(store),
                ::testing::UnorderedElementsAre("700 farm/a-1", "600 farm/a-1/worker.sh",
                                                "777 frames/link"));
    EXPECT_EQ(mode_of(folder.path("outside")), 0600U);
}

TEST(GroupStore, StoreThatKeepsOthersOut_StaysSo) {
    const ScratchFolder folder;
    const std::string store = folder.path("store");
    give_to_group(store, own_group(), {});
    ::chmod(store.c_str(), 02770);
    give_to_group(store, own_group(), {});
    EXPECT_EQ(mode_of(store), 03770U);
}

TEST(GroupStore, Stop_EndsIt) {
    const ScratchFolder folder;
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(give_to_group(folder.path("store"), own_group(), stop.get_token()), Stopped);
}

TEST(GroupStore, LinkInThePlaceOfANewFolder_ChangesNothing) {
    const ScratchFolder folder;
    const std::string store = folder.path("store");
    give_to_group(store, own_group(), {});
    fs::create_directory(folder.path("private"));
    fs::permissions(folder.path("private"), fs::perms(0700));
    fs::create_directory_symlink(folder.path("private"), store + "/frames");
    share_folder(store + "/frames");
    EXPECT_EQ(mode_of(folder.path("private")), 0700U);
}

TEST(GroupStore, GroupThatDoesNotExist_IsAnError) {
    const ScratchFolder folder;
    EXPECT_THAT([&] { give_to_group(folder.path("store"), "no such group", {}); },
                ThrowsMessage<Error>("there is no group 'no such group'"));
    EXPECT_FALSE(fs::exists(folder.path("store")));
}

TEST(GroupStore, MissingPermission_IsAnErrorThatSaysWhoHasIt) {
    const ScratchFolder folder;
    fs::permissions(folder.path(), fs::perms(0750));
    const auto problem = [&](int reason, const std::string& name) {
        const std::string path = folder.path(name);
        errno = reason;
        return system_problem(path, "a claim cannot be written");
    };
    EXPECT_EQ(problem(EACCES, "locks/claim"),
              fmt::format("'{0}/locks/claim': a claim cannot be written: Permission denied; '{0}' "
                          "belongs to the user {1} and the group {2}, mode 750",
                          folder.path(), ::getpwuid(::geteuid())->pw_name, own_group()));
    EXPECT_EQ(problem(ENOSPC, "a"),
              "'" + folder.path("a") + "': a claim cannot be written: No space left on device");
}

/// Another user of the group, which only the system's administrator can become.
TEST(GroupStore, AnotherUser_WorksInItAndReplacesWhatItMayNotRead) {
    if (::geteuid() != 0) {
        GTEST_SKIP() << "needs two users";
    }
    const ScratchFolder folder;
    fs::permissions(folder.path(), fs::perms(0755));
    const std::string store = folder.path("store");
    const Mask mask(077);
    give_to_group(store, "nogroup", {});
    const FrameStore frames(store + "/frames");
    frames.write(make_key(1), make_film(2), {});
    const auto take = [&] {
        return ChildProcess({"/usr/bin/setpriv", "--reuid=nobody", "--regid=nogroup",
                             "--clear-groups", CAROM_BINARY_DIR "/tests/carom_store_actor", "take",
                             store + "/frames"})
            .wait();
    };
    EXPECT_EQ(take(), 0);
    EXPECT_EQ(frames.read(make_key(1))->rgba, make_film(2).rgba) << "it is used as it is";
    ::chmod(frames.path_of(make_key(1)).c_str(), 0600);
    EXPECT_EQ(take(), 0);
    EXPECT_EQ(frames.read(make_key(1))->rgba, make_film(1).rgba) << "it is replaced";
    EXPECT_THAT(wrong_modes(store), ::testing::IsEmpty());
}

}  // namespace
}  // namespace carom::pipeline
