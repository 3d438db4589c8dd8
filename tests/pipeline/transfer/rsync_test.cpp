#include "pipeline/transfer/rsync.h"

#include <filesystem>

#include <gmock/gmock.h>

#include "core/error.h"
#include "tests/scratch_folder.h"

namespace carom::transfer {
namespace {

using carom::testing::ScratchFolder;
using carom::testing::write_text;
using ::testing::HasSubstr;

TEST(RsyncPlace, Texts_AreFoldersHereOrThere) {
    EXPECT_EQ(rsync_place("/a/cache"), "/a/cache/");
    EXPECT_EQ(rsync_place("-x"), "./-x/");
    EXPECT_EQ(rsync_place("./a:b"), "./a:b/");
    EXPECT_EQ(rsync_place("host:cache"), "host:cache/");
    EXPECT_EQ(rsync_place("user@host:"), "user@host:./") << "not the root of the file system";
    EXPECT_EQ(rsync_place("rsync://host/module"), "rsync://host/module/");
    EXPECT_EQ(rsync_place("host::module"), "host::module/");
    EXPECT_FALSE(is_remote("./a:b"));
    EXPECT_TRUE(is_remote("a:b"));
    EXPECT_THROW((void)rsync_place(""), Error);
    EXPECT_THROW((void)rsync_place("-oProxyCommand=true:x"), Error);
}

TEST(RunRsync, NamesAndLines_ArePassedAsTheyAre) {
    const ScratchFolder folder;
    const std::string strange = folder.path("-a b's $(x) *");
    std::filesystem::create_directories(strange);
    write_text(strange + "/file", "text");
    std::vector<std::string> lines;
    const RsyncCall call{{"--recursive", "--out-format=%n"},
                         {rsync_place(strange), rsync_place(folder.path("to"))},
                         {}};
    const RsyncResult result =
        run_rsync(call, [&](const std::string& line) { lines.push_back(line); }, {});
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_THAT(lines, ::testing::Contains("file"));
    EXPECT_TRUE(std::filesystem::exists(folder.path("to/file")));
}

TEST(RunRsync, Failure_HasItsCodeAndText) {
    const RsyncResult result = run_rsync({{}, {"/nowhere/at/all/", "/tmp/"}, {}}, {}, {});
    EXPECT_EQ(result.exit_code, 23);
    try {
        throw_rsync_error("this fails", result);
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("this fails: rsync ended with exit code 23: rsync: "));
        EXPECT_THAT(error.what(), HasSubstr("No such file or directory"));
    }
}

TEST(RunRsync, Stop_EndsIt) {
    std::stop_source stop;
    stop.request_stop();
    // It waits for an answer of this shell.
    const RsyncCall call{{"--rsh=sh -c 'exec sleep 20' remote"}, {"host:/x/", "/tmp/"}, {}};
    EXPECT_THROW((void)run_rsync(call, {}, stop.get_token()), Stopped);
}

}  // namespace
}  // namespace carom::transfer
