// A whole session, from the texts of a page to the messages that it gets.
#include "pipeline/studio/session.h"

#include <filesystem>
#include <fstream>
#include <set>

#include "tests/folders.h"
#include "tests/pipeline/studio/session_fixture.h"

namespace carom::studio {
namespace {

namespace fs = std::filesystem;

TEST_F(StudioSession, Hello_IsAnsweredWithTheWholeShot) {
    start();
    const auto welcome = wait_for<Welcome>([](const Welcome&) { return true; });
    EXPECT_EQ(welcome.shot, path("shot.yaml"));
    const auto files = wait_for<Files>([](const Files&) { return true; });
    EXPECT_EQ(files.files.front().name, "shot.yaml");
    EXPECT_TRUE(files.files.front().writable);
    const auto shot = wait_for<ShotState>([](const ShotState& state) { return state.v == 1; });
    EXPECT_FALSE(shot.objects.empty());
    EXPECT_FALSE(shot.cameras.empty());
    EXPECT_FALSE(shot.places.empty());
    const auto problems = wait_for<Problems>([](const Problems& all) { return all.complete; });
    EXPECT_TRUE(problems.list.empty());
    const auto scene = wait_for<SceneMeshes>([](const SceneMeshes&) { return true; });
    EXPECT_TRUE(session_->find("/scene/" + scene.hash + ".glb"));
    EXPECT_FALSE(session_->find("/scene/none.glb"));
    EXPECT_TRUE(session_->find("/schema.json"));
    const std::optional<Download> configs = session_->find("/configs.json");
    ASSERT_TRUE(configs);
    EXPECT_THAT(*configs->bytes, testing::HasSubstr(R"("name":"tables/pool_9ft.yaml")"));
    EXPECT_THAT(*configs->bytes, testing::Not(testing::HasSubstr("templates/")));
    const std::lock_guard lock(mutex_);
    std::set<std::string> slots;
    for (const Outgoing& message : sent_) {
        if (message.binary) {
            slots.insert(message.slot);
        }
    }
    EXPECT_THAT(slots, testing::ElementsAre("cameras", "timeline"));
}

TEST_F(StudioSession, TextWithErrors_IsAnsweredWithItsProblems) {
    start();
    const std::string file = path("shot.yaml");
    say(TextChange{7, file, "carom: 1\nnonsense: 1\n"});
    const auto problems = wait_for<Problems>([](const Problems& all) { return all.v == 7; });
    ASSERT_EQ(problems.list.size(), 1U);
    EXPECT_EQ(problems.list.front().place.file, file);
    EXPECT_EQ(problems.list.front().place.line, 2);
}

TEST_F(StudioSession, OnlyFilesOfTheShot_AreWritten) {
    start();
    say(TextChange{2, "/etc/passwd", ""});
    EXPECT_EQ(wait_for<Failed>([](const Failed&) { return true; }).what, "text");
    say(Save{"/etc/new.yaml", "", ""});
    wait_for<Failed>([](const Failed& failed) { return failed.what == "save"; });
    session_->received(1, "nonsense");
    wait_for<Failed>([](const Failed& failed) { return failed.what == "message"; });
}

TEST_F(StudioSession, SaveOverAnotherText_IsRefused) {
    start();
    const std::string file = path("shot.yaml");
    const auto files = wait_for<Files>([](const Files&) { return true; });
    std::ofstream(file) << "other: 1\n";
    say(Save{file, "carom: 1\n", files.files.front().hash});
    const auto refused = wait_for<DiskChanged>([](const DiskChanged&) { return true; });
    EXPECT_TRUE(refused.refused);
    EXPECT_EQ(refused.text, "other: 1\n");
    say(Save{file, "carom: 1\n", refused.hash});
    wait_for<Saved>([](const Saved&) { return true; });
    std::string text;
    std::getline(std::ifstream(file), text);
    EXPECT_EQ(text, "carom: 1");
}

TEST_F(StudioSession, AnotherShot_IsOpened) {
    start();
    fs::copy_file(CAROM_SOURCE_DIR "/examples/nine_ball_break.yaml", path("break.yaml"));
    say(Open{path("break.yaml"), "", "", false});
    wait_for<ShotState>([](const ShotState& state) { return state.name == "break"; });
}

TEST_F(StudioSession, MessagesWithoutAShot_AreRefused) {
    SessionOptions none = options();
    none.shot.clear();
    start(none);
    const std::vector<PageMessage> messages{
        TextChange{2, path("shot.yaml"), ""},
        Save{path("shot.yaml"), "", ""},
        Revert{2, path("shot.yaml")},
        SaveAs{"other", false},
        Recover{false},
        Recover{true},
        StartFilm{},
        Make{.q = 1, .what = "plan"},
    };
    for (const PageMessage& message : messages) {
        forget();
        say(message);
        EXPECT_FALSE(wait_for<Failed>().message.empty());
    }
    say(Simulate{1});
    say(Unsee{});
    say(Unfan{});
    say(Open{path("shot.yaml"), "", "", false});
    wait_for<ShotState>([](const ShotState& state) { return state.name == "shot"; });
}

TEST_F(StudioSession, NameThatTheSystemRefuses_IsAnError) {
    start();
    const std::string name = std::string(300, 'a') + ".yaml";
    say(Open{name, "", "", false});
    EXPECT_EQ(wait_for<Failed>().what, "open");
    forget();
    say(SaveAs{name, false});
    EXPECT_EQ(wait_for<Failed>().what, "save_as");
}

TEST_F(StudioSession, ErrorThatIsMended_IsNotToldToLaterPages) {
    start();
    wait_for<Problems>([](const Problems& all) { return all.complete; });
    forget();
    say(Hello{kProtocol});
    const std::lock_guard lock(mutex_);
    for (const Outgoing& one : sent_) {
        EXPECT_NE(one.slot, Failed::kName);
        EXPECT_NE(one.slot, Deferred::kName);
    }
}

}  // namespace
}  // namespace carom::studio
