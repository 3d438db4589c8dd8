#include "core/atomic_file.h"

#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

class AtomicFile : public testing::Test {
  protected:
    AtomicFile() {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    ~AtomicFile() override { fs::remove_all(folder_); }

    static void write(const fs::path& path, std::string_view text) {
        write_file_atomically(path.string(), std::as_bytes(std::span(text)));
    }
    static std::string read(const fs::path& path) {
        std::ifstream file(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    [[nodiscard]] std::vector<std::string> names() const {
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator(folder_)) {
            names.push_back(entry.path().filename());
        }
        return names;
    }

    fs::path folder_ = fs::path(testing::TempDir()) /
                       (std::string("carom_atomic_file_") +
                        testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(AtomicFile, NewFile_HasTheBytesAndNoTemporaryFileRemains) {
    const std::string text(3'000'000, 'z');
    write(folder_ / "a.bake", text);
    EXPECT_EQ(read(folder_ / "a.bake"), text);
    EXPECT_THAT(names(), testing::ElementsAre("a.bake"));
}

TEST_F(AtomicFile, NoBytes_GiveAnEmptyFile) {
    write(folder_ / "a", "");
    EXPECT_EQ(fs::file_size(folder_ / "a"), 0U);
}

TEST_F(AtomicFile, ExistingFile_IsReplaced) {
    write(folder_ / "a", "old and long");
    write(folder_ / "a", "new");
    EXPECT_EQ(read(folder_ / "a"), "new");
    EXPECT_THAT(names(), testing::ElementsAre("a"));
}

TEST_F(AtomicFile, LeftoverOfAnotherRun_IsNotTouched) {
    const fs::path leftover = folder_ / (".carom-" + std::to_string(getpid()) + "-0.part");
    std::ofstream(leftover) << "theirs";
    write(folder_ / "a", "mine");
    EXPECT_EQ(read(folder_ / "a"), "mine");
    EXPECT_EQ(read(leftover), "theirs");
}

TEST_F(AtomicFile, RelativeName_IsWrittenToTheWorkingFolder) {
    const fs::path before = fs::current_path();
    fs::current_path(folder_);
    write("plain", "text");
    fs::current_path(before);
    EXPECT_EQ(read(folder_ / "plain"), "text");
}

TEST_F(AtomicFile, TargetIsAFolder_FailsAndLeavesNothing) {
    fs::create_directory(folder_ / "taken");
    EXPECT_THAT([&] { write(folder_ / "taken", "text"); },
                testing::ThrowsMessage<Error>("cannot write '" + (folder_ / "taken").string() +
                                              "': Is a directory"));
    EXPECT_THAT(names(), testing::ElementsAre("taken"));
}

// For example a link to another disk, which has to remain a link.
TEST_F(AtomicFile, Link_IsKeptAndItsTargetIsReplaced) {
    fs::create_directory(folder_ / "far");
    write(folder_ / "far" / "a", "old");
    fs::create_symlink("far/a", folder_ / "relative");
    fs::create_symlink(folder_ / "relative", folder_ / "absolute");
    write(folder_ / "absolute", "new");
    EXPECT_EQ(read(folder_ / "far" / "a"), "new");
    EXPECT_TRUE(fs::is_symlink(folder_ / "relative"));
    EXPECT_TRUE(fs::is_symlink(folder_ / "absolute"));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "far"), {}), 1);
}

TEST_F(AtomicFile, LinkToAMissingFile_CreatesTheFile) {
    fs::create_symlink("b", folder_ / "a");
    write(folder_ / "a", "text");
    EXPECT_EQ(read(folder_ / "b"), "text");
    EXPECT_TRUE(fs::is_symlink(folder_ / "a"));
}

TEST_F(AtomicFile, CycleOfLinks_IsRefused) {
    fs::create_symlink("b", folder_ / "a");
    fs::create_symlink("a", folder_ / "b");
    EXPECT_THAT([&] { write(folder_ / "a", "text"); },
                testing::ThrowsMessage<Error>("cannot write '" + (folder_ / "a").string() +
                                              "': Too many levels of symbolic links"));
    EXPECT_THAT(names(), testing::UnorderedElementsAre("a", "b"));
}

// As root, a bake written to /dev/null would otherwise replace that device.
TEST_F(AtomicFile, PipeOrDevice_IsRefusedAndKept) {
    const fs::path pipe = folder_ / "pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_THAT([&] { write(pipe, "text"); },
                testing::ThrowsMessage<Error>("cannot write '" + pipe.string() +
                                              "': it is a pipe or a device"));
    EXPECT_TRUE(fs::is_fifo(pipe));
    EXPECT_THAT(names(), testing::ElementsAre("pipe"));
}

TEST_F(AtomicFile, MissingFolder_FailsWithTheSystemsReason) {
    EXPECT_THAT([&] { write(folder_ / "no" / "a", "text"); },
                testing::ThrowsMessage<Error>("cannot write '" + (folder_ / "no/a").string() +
                                              "': No such file or directory"));
    EXPECT_THAT(names(), testing::IsEmpty());
}

TEST_F(AtomicFile, FolderThatIsAFile_FailsWithTheSystemsReason) {
    write(folder_ / "a", "text");
    EXPECT_THAT([&] { write(folder_ / "a" / "b", "text"); },
                testing::ThrowsMessage<Error>(testing::HasSubstr("Not a directory")));
}

TEST_F(AtomicFile, ReplacedFile_KeepsItsPermissions) {
    const fs::perms own = fs::perms::owner_read | fs::perms::owner_write;
    write(folder_ / "a", "private");
    fs::permissions(folder_ / "a", own);
    write(folder_ / "a", "changed");
    EXPECT_EQ(fs::status(folder_ / "a").permissions(), own);
}

TEST_F(AtomicFile, UnwritableFolder_FailsAndLeavesNothing) {
    // The superuser may write anywhere except to /proc.
    const std::string path = geteuid() == 0 ? "/proc/carom_test" : (folder_ / "a").string();
    fs::permissions(folder_, fs::perms::owner_read | fs::perms::owner_exec);
    EXPECT_THROW(write(path, "text"), Error);
    fs::permissions(folder_, fs::perms::owner_all);
    EXPECT_THAT(names(), testing::IsEmpty());
}

TEST_F(AtomicFile, FullDisk_FailsAndKeepsTheOldFile) {
    write(folder_ / "a", "old");
    // A limit on file sizes simulates a full disk: the write fails midway.
    rlimit before{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
    rlimit small = before;
    small.rlim_cur = 100'000;
    const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    const std::string text(1'000'000, 'z');
    EXPECT_THAT([&] { write(folder_ / "a", text); },
                testing::ThrowsMessage<Error>(testing::HasSubstr("File too large")));
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, old_handler);
    EXPECT_EQ(read(folder_ / "a"), "old");
    EXPECT_THAT(names(), testing::ElementsAre("a"));
}

TEST_F(AtomicFile, EmptyName_IsRefused) {
    EXPECT_THAT([] { write("", "text"); },
                testing::ThrowsMessage<Error>("cannot write a file without a name"));
}

}  // namespace
}  // namespace carom
