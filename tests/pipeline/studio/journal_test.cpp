// Unsaved texts outlive the program.
#include "pipeline/studio/journal.h"

#include <thread>

#include "tests/pipeline/store/child_process.h"
#include "tests/pipeline/studio/session_fixture.h"

namespace carom::studio {
namespace {

namespace fs = std::filesystem;

class StudioJournal : public StudioSession {
  protected:
    [[nodiscard]] JournalOptions quick() const {
        return {.folder = path("journal"), .interval = std::chrono::milliseconds(1)};
    }

    [[nodiscard]] std::size_t journals(const std::string& folder) const {
        std::size_t count = 0;
        for (const auto& entry : fs::directory_iterator(path(folder))) {
            count += entry.path().extension() == ".json" ? 1 : 0;
        }
        return count;
    }

    static std::vector<RecoveredText> one(const std::string& text) {
        return {{"/shot.yaml", text, "aa", ""}};
    }
};

TEST_F(StudioJournal, KeptText_IsFoundLater) {
    {
        Journal journal("/shot.yaml", quick());
        EXPECT_TRUE(journal.found().empty());
        journal.keep(one("older"));
        journal.keep(one("newer"));
    }
    const Journal again("/shot.yaml", quick());
    ASSERT_EQ(again.found().size(), 1U);
    EXPECT_EQ(again.found().front().text, "newer");
    EXPECT_EQ(again.found().front().base_hash, "aa");
    const Journal other("/other.yaml", quick());
    EXPECT_TRUE(other.found().empty());
}

TEST_F(StudioJournal, SavedText_IsRemoved) {
    {
        Journal journal("/shot.yaml", quick());
        journal.keep(one("text"));
        journal.keep({});
    }
    EXPECT_EQ(journals("journal"), 0U);
    EXPECT_TRUE(fs::is_empty(path("journal")));
}

TEST_F(StudioJournal, SecondStudio_HasAJournalOfItsOwn) {
    {
        Journal first("/shot.yaml", quick());
        Journal second("/shot.yaml", quick());
        first.keep(one("first"));
        second.keep(one("second"));
    }
    const Journal again("/shot.yaml", quick());
    ASSERT_EQ(again.found().size(), 1U);
    const Journal next("/shot.yaml", quick());
    ASSERT_EQ(next.found().size(), 1U);
    EXPECT_NE(again.found().front().text, next.found().front().text);
}

TEST_F(StudioJournal, DamagedFile_IsNoJournal) {
    { Journal("/shot.yaml", quick()).keep(one("text")); }
    for (const auto& entry : fs::directory_iterator(path("journal"))) {
        write_file(entry.path().string(), R"({"t":"recovered","files":[{"file":)");
    }
    EXPECT_TRUE(Journal("/shot.yaml", quick()).found().empty());
}

TEST_F(StudioJournal, FolderThatCannotBeMade_IsNoError) {
    write_file(path("journal"), "a file");
    Journal journal("/shot.yaml", quick());
    journal.keep(one("text"));
    EXPECT_TRUE(journal.found().empty());
}

TEST_F(StudioJournal, Session_OffersWhatWasNotSaved) {
    const std::string file = path("shot.yaml");
    const std::string unsaved = read_file(file) + "# unsaved\n";
    start();
    say(TextChange{2, file, unsaved});
    session_.reset();
    forget();
    EXPECT_EQ(journals("cache/studio"), 1U);

    start();
    const auto recovered = wait_for<Recovered>();
    ASSERT_EQ(recovered.files.size(), 1U);
    EXPECT_EQ(recovered.files.front().text, unsaved);
    EXPECT_EQ(recovered.files.front().hash, recovered.files.front().base_hash);
    EXPECT_EQ(wait_for<Files>().files.front().text, read_file(file));
    say(Recover{true});
    const auto files =
        wait_for<Files>([&](const Files& all) { return all.files.front().text == unsaved; });
    EXPECT_TRUE(files.files.front().changed);
    wait_for<Problems>([&](const Problems& all) { return all.v == files.v; });
    say(Save{file, unsaved, files.files.front().hash});
    wait_for<Saved>();
    session_.reset();
    EXPECT_TRUE(fs::is_empty(path("cache/studio")));
}

TEST_F(StudioJournal, RefusedText_IsForgotten) {
    const std::string file = path("shot.yaml");
    start();
    say(TextChange{2, file, "carom: 1\n"});
    session_.reset();
    forget();
    start();
    wait_for<Recovered>();
    say(Recover{false});
    session_.reset();
    EXPECT_TRUE(fs::is_empty(path("cache/studio")));
}

TEST_F(StudioJournal, TextOutsideTheRoot_IsOfferedWhenItCanBeUsed) {
    fs::create_directories(path("inner"));
    write_file(path("looks.yaml"), "render: {samples: 16}\n");
    write_file(path("inner/shot.yaml"), "carom: 1\ninclude: ../looks.yaml\ntable: {kind: cloth}\n");
    SessionOptions wide = options();
    wide.shot = path("inner/shot.yaml");
    SessionOptions narrow = wide;
    narrow.root = path("inner");
    start(wide);
    wait_for<Problems>([](const Problems& all) { return all.complete; });
    say(TextChange{2, path("looks.yaml"), "render: {samples: 32}\n"});
    session_.reset();
    start(narrow);
    wait_for<Problems>([](const Problems& all) { return all.complete; });
    session_.reset();
    forget();
    start(wide);
    EXPECT_EQ(wait_for<Recovered>().files.front().text, "render: {samples: 32}\n");
}

TEST_F(StudioJournal, UnansweredText_IsStillOfferedAfterSaveAs) {
    const std::string unsaved = "carom: 1\n# unsaved\n";
    start();
    say(TextChange{2, path("shot.yaml"), unsaved});
    session_.reset();
    start();
    wait_for<Recovered>();
    say(SaveAs{"copy", false});
    wait_for<Welcome>([&](const Welcome& one) { return one.shot == path("copy.yaml"); });
    session_.reset();
    forget();
    start();
    EXPECT_EQ(wait_for<Recovered>().files.front().text, unsaved);
}

TEST_F(StudioJournal, UndoneChange_IsNotKept) {
    start();
    say(TextChange{2, path("shot.yaml"), "carom: 1\n"});
    say(TextChange{3, path("shot.yaml"), read_file(path("shot.yaml"))});
    session_.reset();
    EXPECT_TRUE(fs::is_empty(path("cache/studio")));
}

// The process is this program with this test alone: one that was forked would have none of the
// threads that earlier tests have left to libraries, nor the locks that they held.
TEST_F(StudioJournal, KilledProcess_LeavesTheText) {
    if (is_started_by_test()) {
        start();
        say(TextChange{2, path("shot.yaml"), "carom: 1\n# unsaved\n"});
        std::this_thread::sleep_for(std::chrono::minutes(1));
        FAIL() << "nobody has killed it";
    }
    carom::testing::ChildProcess child(
        {"/usr/bin/env",
         kFolderVariable + ("=" + fs::path(path("shot.yaml")).parent_path().string()),
         fs::read_symlink("/proc/self/exe").string(),
         "--gtest_filter=StudioJournal.KilledProcess_LeavesTheText"});
    ASSERT_TRUE(child.wait_until([&] {
        std::error_code code;
        return fs::exists(path("cache/studio"), code) && journals("cache/studio") == 1;
    }));
    child.kill();
    (void)child.wait();
    start();
    const auto recovered = wait_for<Recovered>();
    ASSERT_EQ(recovered.files.size(), 1U);
    EXPECT_EQ(recovered.files.front().text, "carom: 1\n# unsaved\n");
}

}  // namespace
}  // namespace carom::studio
