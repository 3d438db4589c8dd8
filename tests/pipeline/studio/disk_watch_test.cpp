// Files that other programs change while a shot is open.
#include "tests/pipeline/studio/session_fixture.h"

namespace carom::studio {
namespace {

namespace fs = std::filesystem;

class StudioDisk : public StudioSession {
  protected:
    StudioDisk() : original_(read_file(path("shot.yaml"))) {}

    void open() {
        start();
        wait_for<Problems>([](const Problems& all) { return all.complete; });
        forget();
    }

    /// The text of the shot with another comment at its end.
    [[nodiscard]] std::string with_comment(const std::string& comment) const {
        return original_ + "# " + comment + "\n";
    }

    void expect_reloaded(const std::string& text) {
        const auto files =
            wait_for<Files>([&](const Files& all) { return all.files.front().text == text; });
        EXPECT_FALSE(files.files.front().changed);
        wait_for<Problems>([&](const Problems& all) { return all.v == files.v; });
        forget();
    }

    std::string original_;
};

TEST_F(StudioDisk, OverwrittenFile_IsUsedAtOnce) {
    open();
    write_file(path("shot.yaml"), with_comment("overwritten"));
    expect_reloaded(with_comment("overwritten"));
}

TEST_F(StudioDisk, RenamedFiles_ReplaceTheShot) {
    open();
    // An editor that keeps a backup: first the old file gets another name.
    fs::rename(path("shot.yaml"), path("shot.yaml~"));
    write_file(path("shot.yaml"), with_comment("after a backup"));
    expect_reloaded(with_comment("after a backup"));
    // One that writes beside the file and renames.
    write_file(path(".shot.yaml.new"), with_comment("renamed"));
    fs::rename(path(".shot.yaml.new"), path("shot.yaml"));
    expect_reloaded(with_comment("renamed"));
    // A checkout of another branch: the file is removed and written.
    fs::remove(path("shot.yaml"));
    write_file(path("shot.yaml"), with_comment("checked out"));
    expect_reloaded(with_comment("checked out"));
}

TEST_F(StudioDisk, ReplacedFolder_IsWatchedAgain) {
    fs::create_directories(path("inner"));
    fs::rename(path("shot.yaml"), path("inner/shot.yaml"));
    SessionOptions inner = options();
    inner.shot = path("inner/shot.yaml");
    start(inner);
    wait_for<Problems>([](const Problems& all) { return all.complete; });
    fs::rename(path("inner"), path("before"));
    fs::create_directories(path("inner"));
    write_file(path("inner/shot.yaml"), with_comment("in a new folder"));
    expect_reloaded(with_comment("in a new folder"));
    write_file(path("inner/shot.yaml"), with_comment("and again"));
    expect_reloaded(with_comment("and again"));
}

TEST_F(StudioDisk, DeletedFile_RemainsInThePageAsUnsaved) {
    open();
    fs::remove(path("shot.yaml"));
    const auto gone = wait_for<DiskChanged>();
    EXPECT_EQ(gone.file, path("shot.yaml"));
    EXPECT_TRUE(gone.hash.empty());
    EXPECT_EQ(gone.gone, "was deleted");
    EXPECT_FALSE(gone.refused);
    say(Hello{kProtocol});
    const auto files = wait_for<Files>();
    EXPECT_EQ(files.files.front().text, original_);
    EXPECT_TRUE(files.files.front().changed);
    say(Save{path("shot.yaml"), original_, ""});
    wait_for<Saved>();
    EXPECT_EQ(read_file(path("shot.yaml")), original_);
}

TEST_F(StudioDisk, FileThatIsNoMore_IsToldWithWhatBecameOfIt) {
    open();
    const auto fate = [&] {
        const auto changed =
            wait_for<DiskChanged>([](const DiskChanged& one) { return !one.refused; });
        EXPECT_TRUE(changed.text.empty() && changed.hash.empty());
        return changed.gone;
    };
    const auto write_again = [&] {
        say(Save{path("shot.yaml"), original_, ""});
        wait_for<Saved>();
        EXPECT_EQ(read_file(path("shot.yaml")), original_);
        forget();
    };
    fs::rename(path("shot.yaml"), path("other.yaml"));
    EXPECT_EQ(fate(), "was renamed to 'other.yaml'");
    // Before the page knows of that, a save is refused and says the same.
    say(Save{path("shot.yaml"), original_, "of before"});
    const auto refused = wait_for<DiskChanged>([](const DiskChanged& one) { return one.refused; });
    EXPECT_EQ(refused.hash, "");
    write_again();
    fs::rename(path("shot.yaml"), path("third.yaml"));
    EXPECT_EQ(fate(), "was renamed to 'third.yaml'");
    write_again();
    fs::remove(path("shot.yaml"));
    fs::create_directories(path("shot.yaml"));
    EXPECT_EQ(fate(), "is a folder");
    say(Save{path("shot.yaml"), original_, ""});
    EXPECT_NE(wait_for<Failed>().message.find("shot.yaml"), std::string::npos);
    fs::remove(path("shot.yaml"));
    forget();
    write_file(path("shot.yaml"), original_);
    expect_reloaded(original_);
    forget();
    write_file(path("shot.yaml"), std::string(5 << 20, '#'));
    EXPECT_NE(fate().find("has more than"), std::string::npos);
}

TEST_F(StudioDisk, ChangedFileWithAnUnsavedText_IsAConflict) {
    open();
    say(TextChange{5, path("shot.yaml"), with_comment("mine")});
    write_file(path("shot.yaml"), with_comment("theirs"));
    const auto conflict = wait_for<DiskChanged>();
    EXPECT_EQ(conflict.text, with_comment("theirs"));
    EXPECT_FALSE(conflict.refused);
    forget();
    say(Hello{kProtocol});
    EXPECT_EQ(wait_for<Files>().files.front().text, with_comment("mine"));
    forget();
    // The same text on both sides is no conflict.
    write_file(path("shot.yaml"), with_comment("mine"));
    expect_reloaded(with_comment("mine"));
}

TEST_F(StudioDisk, IncludedFile_IsWatchedToo) {
    write_file(path("looks.yaml"), "render: {samples: 16}\n");
    write_file(path("shot.yaml"),
               "carom: 1\ninclude: [tables/pool_9ft.yaml, balls/pool.yaml, "
               "looks.yaml]\nballs: {cue: {at: [0, 0]}}\n");
    open();
    write_file(path("looks.yaml"), "render: {samples: 16, nonsense: 1}\n");
    const auto problems = wait_for<Problems>([](const Problems& all) { return !all.list.empty(); });
    EXPECT_EQ(problems.list.front().place.file, path("looks.yaml"));
}

TEST_F(StudioDisk, MissingFile_IsReadWhenItAppears) {
    write_file(path("shot.yaml"), "carom: 1\ninclude: [later.yaml]\ntable: {kind: cloth}\n");
    start();
    const auto problems = wait_for<Problems>([](const Problems& all) { return all.complete; });
    ASSERT_EQ(problems.list.size(), 1U);
    write_file(path("later.yaml"), "balls: {cue: {at: [0, 0]}}\n");
    wait_for<ShotState>([](const ShotState& state) { return !state.objects.empty(); });
}

TEST_F(StudioDisk, ChangedMesh_IsReadAgain) {
    const std::string corners = "v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nv 0 0 0.1\n";
    const std::string faces = "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    write_file(path("block.obj"), corners + faces);
    write_file(path("shot.yaml"),
               original_ + "objects: {block: {mesh: block.obj, at: [0.3, 0.2, 0.1]}}\n");
    start();
    const auto before = wait_for<SceneMeshes>();
    fs::remove(path("block.obj"));
    write_file(path("block.obj"), "v 0 0 0\nv 0.2 0 0\nv 0 0.1 0\nv 0 0 0.1\n" + faces);
    wait_for<SceneMeshes>([&](const SceneMeshes& scene) { return scene.hash != before.hash; });
}

}  // namespace
}  // namespace carom::studio
