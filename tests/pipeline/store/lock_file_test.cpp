#include "pipeline/store/lock_file.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/file.h>

#include "core/error.h"
#include "pipeline/store/wait_notice.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

using carom::testing::read_text;
using carom::testing::ScratchFolder;
using carom::testing::write_text;
using std::chrono::seconds;
using ::testing::ThrowsMessage;

/// Opens a file and locks it, as another process would.
FileDescriptor locked_elsewhere(const std::string& path) {
    FileDescriptor file(::open(path.c_str(), O_RDWR | O_CLOEXEC));
    EXPECT_EQ(::flock(file.get(), LOCK_EX | LOCK_NB), 0);
    return file;
}

TEST(LockFile, FileThatAnotherHasLocked_IsBusyAndKeepsItsContent) {
    const ScratchFolder folder;
    const std::string path = folder.path("lock");
    write_text(path, "of another");
    FileDescriptor other = locked_elsewhere(path);
    EXPECT_EQ(try_lock(path).state, LockState::busy);
    EXPECT_EQ(lock_state_of(path), LockState::busy);
    EXPECT_EQ(read_text(path), "of another");
    other.reset();
    EXPECT_EQ(lock_state_of(path), LockState::acquired);
    EXPECT_EQ(try_lock(path).state, LockState::acquired);
    EXPECT_EQ(read_text(path), "of another");
}

TEST(LockFile, OwnFileThatAnotherKeepsLocked_IsAnErrorAfterAWhile) {
    const ScratchFolder folder;
    const std::string path = folder.path("lock");
    write_text(path, "");
    const FileDescriptor other = locked_elsewhere(path);
    EXPECT_THAT([&] { (void)lock_own_file(path); },
                ThrowsMessage<Error>("'" + path +
                                     "': the file cannot be locked: another process has locked it "
                                     "for 5 s"));
}

TEST(WaitNotice, LongWait_IsToldAtGrowingIntervals) {
    WaitNotice wait;
    const WaitNotice::Clock::time_point begin{};
    std::vector<std::string> told;
    for (int second = 0; second <= 600; ++second) {
        if (const auto waited = wait.due(begin + seconds(second))) {
            told.push_back(*waited);
        }
    }
    EXPECT_THAT(told, ::testing::ElementsAre("30 s", "60 s", "2 min", "4 min", "8 min"));
    wait.end();
    EXPECT_FALSE(wait.due(begin + seconds(601)));
    EXPECT_TRUE(wait.due(begin + seconds(631)));
}

}  // namespace
}  // namespace carom::pipeline
