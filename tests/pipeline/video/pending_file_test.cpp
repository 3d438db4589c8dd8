#include "pipeline/video/pending_file.h"

#include <filesystem>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

using carom::testing::read_text;
using carom::testing::ScratchFolder;
using carom::testing::write_text;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::string message_of(const std::string& target) {
    try {
        const PendingFile file(target);
        return {};
    } catch (const Error& error) {
        return error.what();
    }
}

TEST(PendingFile, Committed_ExistsOnlyUnderItsName) {
    const ScratchFolder folder;
    PendingFile file(folder.path("a.png"));
    EXPECT_TRUE(file.temporary_path().ends_with(".png"));
    write_text(file.temporary_path(), "whole");
    file.commit();
    EXPECT_THAT(folder.names(), ElementsAre("a.png"));
    EXPECT_EQ(read_text(folder.path("a.png")), "whole");
}

TEST(PendingFile, Abandoned_LeavesOnlyTheOldTarget) {
    const ScratchFolder folder;
    write_text(folder.path("a.txt"), "old");
    {
        const PendingFile file(folder.path("a.txt"));
        write_text(file.temporary_path(), "half");
    }
    EXPECT_THAT(folder.names(), ElementsAre("a.txt"));
    EXPECT_EQ(read_text(folder.path("a.txt")), "old");
}

TEST(PendingFile, SymbolicLink_StaysAndItsFileIsReplaced) {
    const ScratchFolder folder;
    write_text(folder.path("stored"), "old");
    std::filesystem::create_symlink("stored", folder.path("a.png"));
    PendingFile file(folder.path("a.png"));
    EXPECT_TRUE(file.temporary_path().ends_with(".png"));
    write_text(file.temporary_path(), "new");
    file.commit();
    EXPECT_THAT(folder.names(), ::testing::UnorderedElementsAre("a.png", "stored"));
    EXPECT_TRUE(std::filesystem::is_symlink(folder.path("a.png")));
    EXPECT_EQ(read_text(folder.path("stored")), "new");
}

TEST(PendingFile, TwoForOneTarget_DoNotInterfere) {
    const ScratchFolder folder;
    PendingFile first(folder.path("a"));
    PendingFile second(folder.path("a"));
    write_text(first.temporary_path(), "first");
    write_text(second.temporary_path(), "second");
    first.commit();
    EXPECT_EQ(read_text(folder.path("a")), "first");
    second.commit();
    EXPECT_EQ(read_text(folder.path("a")), "second");
    EXPECT_THAT(folder.names(), ElementsAre("a"));
}

TEST(PendingFile, LeftoverOfAKilledProcess_IsRemoved) {
    const ScratchFolder folder;
    write_text(folder.path(".a.mp4.123-0.part.mp4"), "half");  // no process holds its lock
    write_text(folder.path(".b.mp4.123-0.part.mp4"), "another target's");
    { const PendingFile file(folder.path("a.mp4")); }
    EXPECT_THAT(folder.names(), ElementsAre(".b.mp4.123-0.part.mp4"));
}

TEST(PendingFile, Folder_IsRefused) {
    const ScratchFolder folder;
    EXPECT_EQ(message_of(folder.path()), "cannot write '" + folder.path() + "': it is a folder");
}

TEST(PendingFile, Pipe_IsRefused) {
    const ScratchFolder folder;
    const std::string target = folder.path("pipe.mp4");
    ASSERT_EQ(::mkfifo(target.c_str(), 0600), 0);
    EXPECT_EQ(message_of(target), "cannot write '" + target + "': it is a pipe or a device");
}

TEST(PendingFile, MissingFolder_IsReportedWithTheReason) {
    const ScratchFolder folder;
    const std::string target = folder.path("none/a.mp4");
    EXPECT_EQ(message_of(target), "cannot write '" + target + "': No such file or directory");
}

TEST(PendingFile, UnwritableFolder_IsReportedWithTheReason) {
    if (::geteuid() == 0) {
        // Permissions do not apply to root, but /proc refuses new files from root too.
        EXPECT_THAT(message_of("/proc/a.mp4"),
                    ::testing::StartsWith("cannot write '/proc/a.mp4': "));
        return;
    }
    const ScratchFolder folder;
    std::filesystem::permissions(
        folder.path(), std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
    const std::string target = folder.path("a.mp4");
    EXPECT_EQ(message_of(target), "cannot write '" + target + "': Permission denied");
}

}  // namespace
}  // namespace carom::pipeline
