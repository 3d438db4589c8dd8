// Shots that are opened, begun from templates and examples, copied, imported and added from.
#include <cstdlib>
#include <set>

#include "core/error.h"
#include "pipeline/studio/output_path.h"
#include "pipeline/studio/paths.h"
#include "pipeline/studio/recent_files.h"
#include "pipeline/studio/shot_copy.h"
#include "pipeline/studio/shot_parts.h"
#include "pipeline/studio/shot_root.h"
#include "pipeline/studio/start_page.h"
#include "tests/folders.h"
#include "tests/pipeline/studio/session_fixture.h"

namespace carom::studio {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::HasSubstr;
using testing::StartsWith;

class StudioFiles : public StudioSession {
  protected:
    void start_without_shot() {
        SessionOptions none = options();
        none.shot.clear();
        start(none);
    }

    /// The path of a template or example.
    static std::string path_of(const std::vector<StartFile>& files, const std::string& name) {
        for (const StartFile& file : files) {
            if (file.name == name) {
                return file.file;
            }
        }
        return "";
    }

    void expect_opened(const std::string& name) {
        const auto shot =
            wait_for<ShotState>([&](const ShotState& state) { return state.name == name; });
        const auto problems = wait_for<Problems>([](const Problems& all) { return all.complete; });
        for (const Problem& problem : problems.list) {
            EXPECT_NE(problem.severity, "error") << problem.message;
        }
    }
};

TEST_F(StudioFiles, StartPage_HasTemplatesAndExamplesWithStills) {
    start_without_shot();
    EXPECT_EQ(wait_for<Welcome>().shot, "");
    const auto offered = wait_for<Start>([](const Start& start) {
        return std::ranges::all_of(start.templates, [](const StartFile& one) {
            return !one.still.empty();  // drawn one after the other
        });
    });
    EXPECT_EQ(offered.templates.front().name, "empty");
    EXPECT_EQ(offered.examples.size(), 22U);
    EXPECT_TRUE(offered.recent.empty());
    for (const StartFile& one : offered.examples) {
        EXPECT_NE(one.still, "") << one.name;
        EXPECT_NE(one.about, "") << one.name;
        const std::optional<Download> still = session_->find(one.still);
        ASSERT_TRUE(still) << one.name;
        EXPECT_EQ(still->type, "image/jpeg");
        EXPECT_TRUE(fs::is_regular_file(still->path));
    }
    const std::optional<Download> sketch = session_->find(offered.templates.back().still);
    ASSERT_TRUE(sketch);
    EXPECT_EQ(sketch->type, "image/svg+xml");
    EXPECT_NE(sketch->bytes->find("<svg"), std::string::npos);
    EXPECT_FALSE(session_->find("/still/../../etc/passwd"));
}

TEST_F(StudioFiles, FirstSentence_IsWhatTheCommentSays) {
    EXPECT_EQ(
        first_sentence("# yaml-language-server: $schema=x\n# One\n#   two. Three.\ncarom: 1\n"),
        "One two.");
    EXPECT_EQ(first_sentence("carom: 1\n# later\n"), "");
    EXPECT_EQ(first_sentence("# 1.5 m away"), "1.5 m away");
}

TEST_F(StudioFiles, Template_BecomesANewFile) {
    start_without_shot();
    const auto offered = wait_for<Start>();
    say(Open{"mine", path_of(offered.templates, "bank"), "", false});
    expect_opened("mine");
    const std::string text = read_file(path("mine.yaml"));
    EXPECT_THAT(text, StartsWith("# yaml-language-server: $schema=carom.schema.json\n"));
    EXPECT_THAT(text, HasSubstr("tables/pool_9ft.yaml"));
    forget();
    say(Open{"mine.yaml", path_of(offered.templates, "jump"), "", false});
    const auto exists = wait_for<Exists>();
    EXPECT_EQ(exists.what, "open");
    EXPECT_EQ(exists.name, "mine.yaml");
    EXPECT_EQ(read_file(path("mine.yaml")), text);
    say(Open{"mine.yaml", path_of(offered.templates, "jump"), "", true});
    wait_for<Welcome>();
    EXPECT_NE(read_file(path("mine.yaml")), text);
}

TEST_F(StudioFiles, EveryExample_IsCopiedWithWhatItNeeds) {
    start_without_shot();
    const auto offered = wait_for<Start>();
    fs::create_directories(path("copies"));
    for (const StartFile& one : offered.examples) {
        forget();
        say(Open{"copies/my_" + one.name, one.file, "", false});
        const auto problems =
            wait_for<Problems>([](const Problems& all) { return !all.list.empty() || all.v > 0; });
        EXPECT_TRUE(problems.list.empty()) << one.name << ": " << problems.list.front().message;
    }
    EXPECT_TRUE(fs::exists(path("copies/assets/ramp.obj")));
    EXPECT_TRUE(fs::exists(path("copies/nine_ball_break.yaml")));  // which slow_motion includes
}

TEST_F(StudioFiles, ChangedCopyOfAnInclude_IsNotWrittenOver) {
    start_without_shot();
    const auto offered = wait_for<Start>();
    write_file(path("nine_ball_break.yaml"), "carom: 1\n# mine\n");
    say(Open{"slow", path_of(offered.examples, "slow_motion"), "", false});
    expect_opened("slow");
    EXPECT_EQ(read_file(path("nine_ball_break.yaml")), "carom: 1\n# mine\n");
    EXPECT_THAT(read_file(path("slow.yaml")), HasSubstr("include: nine_ball_break_2.yaml    #"));
}

TEST_F(StudioFiles, SecretOutsideOfTheRoot_IsNeitherCopiedNorRead) {
    fs::create_directories(path("root/inner"));
    write_file(path("secret.yaml"), "balls: {secret: {at: [0, 0]}}\n");
    write_file(path("root/shot.yaml"), "carom: 1\ninclude: ../secret.yaml\ntable: {kind: cloth}\n");
    SessionOptions narrow = options();
    narrow.shot = path("root/shot.yaml");
    narrow.root = path("root");
    start(narrow);
    wait_for<Problems>([](const Problems& all) { return all.complete; });
    say(ReadParts{"shot.yaml", ""});
    for (const Part& part : wait_for<Parts>().parts) {
        EXPECT_NE(part.name, "secret");
    }
    say(SaveAs{"inner/copy", false});
    wait_for<Welcome>([&](const Welcome& one) { return one.shot == path("root/inner/copy.yaml"); });
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(path("root/inner"))) {
        names.push_back(entry.path().filename().string());
    }
    EXPECT_EQ(names, std::vector<std::string>{"copy.yaml"});
}

// A link that leads out of the folder, also one whose target does not exist yet.
TEST_F(StudioFiles, LinksOutOfTheRoot_AreNotWrittenThrough) {
    fs::create_directories(path("root"));
    fs::create_directories(path("out"));
    fs::copy_file(path("shot.yaml"), path("root/shot.yaml"));
    fs::create_symlink("../out/new.yaml", path("root/dangling.yaml"));
    fs::create_symlink(path("root/dangling.yaml"), path("root/chain.yaml"));
    fs::create_symlink("../out/folder", path("root/folder"));
    SessionOptions narrow = options();
    narrow.shot = path("root/shot.yaml");
    narrow.root = path("root");
    start(narrow);
    wait_for<Welcome>();
    for (const char* name : {"dangling.yaml", "chain.yaml", "folder/new.yaml"}) {
        forget();
        say(Save{path("root/") + name, "carom: 1\n", "", true});
        EXPECT_EQ(wait_for<Failed>().what, "save") << name;
        forget();
        say(SaveAs{name, true});
        EXPECT_EQ(wait_for<Failed>().what, "save_as") << name;
    }
    fs::create_symlink("../out/new.mp4", path("root/film.mp4"));
    for (const char* name : {"film.mp4", "folder/new.mp4"}) {
        EXPECT_THROW((void)output_path(name, path("root/shot.yaml"), "", path("root"), ".mp4"),
                     Error);
    }
    // The shot itself becomes a link while it is open.
    fs::remove(path("root/shot.yaml"));
    fs::create_symlink("../out/new.yaml", path("root/shot.yaml"));
    forget();
    say(Save{path("root/shot.yaml"), "carom: 1\n", "", true});
    EXPECT_THAT(wait_for<Failed>().message, HasSubstr("it has become a link"));
    EXPECT_TRUE(fs::is_empty(path("out")));
    // A link inside of the folder is followed.
    fs::create_symlink("inner.yaml", path("root/alias.yaml"));
    EXPECT_EQ(whole_path(path("root/alias.yaml")), path("root/inner.yaml"));
}

// The folder of shots and the one of what they share lie side by side.
TEST_F(StudioFiles, FilesBesideTheShotsFolder_AreReadAndWrittenWithoutARoot) {
    fs::create_directories(path("project/shots"));
    fs::create_directories(path("project/shared/rigs"));
    write_file(path("project/shots/a.yaml"),
               "carom: 1\ninclude: [tables/pool_9ft.yaml, ../shared/balls.yaml]\n");
    write_file(path("project/shared/balls.yaml"),
               "include: rigs/more.yaml\nballs: {cue: {at: [0, 0]}}\n");
    write_file(path("project/shared/rigs/more.yaml"), "balls: {one: {at: [0.5, 0]}}\n");
    SessionOptions free = options();
    free.shot = path("project/shots/a.yaml");
    free.root.clear();
    start(free);
    EXPECT_EQ(session_->files_root(), path("project"));
    const auto problems = wait_for<Problems>([](const Problems& all) { return all.complete; });
    for (const Problem& problem : problems.list) {
        EXPECT_NE(problem.severity, "error") << problem.message;
    }
    for (const OpenFile& file :
         wait_for<Files>([](const Files& all) { return all.files.size() == 4; }).files) {
        EXPECT_EQ(file.writable, file.name.find("pool_9ft") == std::string::npos) << file.file;
    }
}

TEST_F(StudioFiles, FilesOfOthersAndOfTheHomeFolder_NeedARoot) {
    fs::create_directories(path("home/project"));
    write_file(path("home/secret.yaml"), "balls: {secret: {at: [0, 0]}}\n");
    const std::string shot = path("home/project/a.yaml");
    write_file(shot, "carom: 1\ninclude: [tables/pool_9ft.yaml, ../secret.yaml]\n");
    const std::string own = path("home/project");
    const char* before = std::getenv("HOME");
    const std::string home = before == nullptr ? "" : before;
    ::setenv("HOME", path("home").c_str(), 1);
    EXPECT_EQ(shot_root(shot, own, {}), own);
    ::setenv("HOME", path("home/project/me").c_str(), 1);
    EXPECT_EQ(shot_root(shot, own, {}), own);
    ::setenv("HOME", home.c_str(), 1);
    EXPECT_EQ(shot_root(shot, own, {}), path("home"));
    write_file(shot, "carom: 1\ninclude: [tables/pool_9ft.yaml, /etc/passwd]\n");
    EXPECT_EQ(shot_root(shot, own, {}), own);
    write_file(shot, "carom: 1\ninclude: [tables/pool_9ft.yaml, ../missing.yaml]\n");
    EXPECT_EQ(shot_root(shot, own, {}), own);
    write_file(shot, "carom: 1\ninclude: tables/pool_9ft.yaml\nobjects: {o: {mesh: ../m.obj}}\n");
    write_file(path("home/m.obj"), "v 0 0 0\n");
    EXPECT_EQ(shot_root(shot, own, {}), path("home"));
}

TEST_F(StudioFiles, NamesOutsideOfTheRoot_AreRefused) {
    start_without_shot();
    const auto offered = wait_for<Start>();
    const std::string bank = path_of(offered.templates, "bank");
    fs::create_directories(path("folder.yaml"));
    for (const char* name :
         {"../out.yaml", "/tmp/out.yaml", ".hidden", "a/b/c.yaml", "a\nb", "folder"}) {
        forget();
        say(Open{name, bank, "", true});
        EXPECT_EQ(wait_for<Failed>().what, "open") << name;
    }
    say(Open{"out", "/etc/passwd", "", false});
    wait_for<Failed>([](const Failed& failed) {
        return failed.message.find("neither a template nor an example") != std::string::npos;
    });
    EXPECT_FALSE(fs::exists(path("out.yaml")));
    forget();
    say(Open{"/etc/passwd", "", "", false});
    EXPECT_THAT(wait_for<Failed>().message, HasSubstr("is not below"));
    forget();
    say(ListFolder{"/etc"});
    EXPECT_THAT(wait_for<Failed>().message, HasSubstr("is not below"));
    forget();
    say(ReadParts{"/etc/passwd", ""});
    EXPECT_EQ(wait_for<Failed>().what, "read_parts");
}

TEST_F(StudioFiles, Folder_ListsShotsAndFolders) {
    fs::create_directories(path("a folder/inner"));
    write_file(path("a folder/other.yaml"), "carom: 1\n");
    write_file(path("a folder/notes.txt"), "");
    write_file(path("a folder/.hidden.yaml"), "");
    start();
    say(ListFolder{""});
    const auto top = wait_for<Folder>();
    EXPECT_EQ(top.folder, folder_.string());
    EXPECT_EQ(top.name, "");
    EXPECT_EQ(top.parent, "");
    EXPECT_EQ(top.entries.back().name, "shot.yaml");
    forget();
    say(ListFolder{"a folder"});
    const auto inner = wait_for<Folder>();
    EXPECT_EQ(inner.name, "a folder");
    EXPECT_EQ(inner.parent, folder_.string());
    ASSERT_EQ(inner.entries.size(), 2U);
    EXPECT_TRUE(inner.entries[0].is_folder);
    EXPECT_EQ(inner.entries[1].file, path("a folder/other.yaml"));
}

TEST_F(StudioFiles, OpenedShots_AreRecent) {
    write_file(path("other.yaml"), "carom: 1\n");
    start();
    say(Open{path("other.yaml"), "", "", false});
    say(Open{});
    const auto offered = wait_for<Start>();
    ASSERT_EQ(offered.recent.size(), 2U);
    EXPECT_EQ(offered.recent[0].file, path("other.yaml"));
    EXPECT_EQ(offered.recent[1].file, path("shot.yaml"));
    fs::remove(path("other.yaml"));
    forget();
    say(Offer{});
    EXPECT_EQ(wait_for<Start>().recent.size(), 1U);
    forget();
    say(Forget{path("shot.yaml")});
    EXPECT_TRUE(wait_for<Start>().recent.empty());
}

TEST_F(StudioFiles, RecentFiles_OutliveTheProgram) {
    RecentFiles recent(path("state"));
    for (int i = 0; i < 25; ++i) {
        write_file(path(std::to_string(i) + ".yaml"), "");
        recent.add(path(std::to_string(i) + ".yaml"));
    }
    recent.add(path("7.yaml"));
    const std::vector<std::string> files = RecentFiles(path("state")).list();
    ASSERT_EQ(files.size(), 20U);
    EXPECT_EQ(files[0], path("7.yaml"));
    EXPECT_EQ(files[1], path("24.yaml"));
    RecentFiles("").add(path("7.yaml"));
    EXPECT_TRUE(RecentFiles("").list().empty());
    RecentFiles("/proc/none").add(path("7.yaml"));
}

TEST_F(StudioFiles, SaveAs_WritesTheTextOfThePage) {
    fs::create_directories(path("inner"));
    write_file(path("looks.yaml"), "render: {samples: 16}\n");
    write_file(path("block.obj"),
               "v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nv 0 0 0.1\n"
               "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    const std::string text =
        "# ä shot\ncarom: 1\ninclude: [tables/pool_9ft.yaml, looks.yaml]\n"
        "objects: {block: {mesh: \"block.obj\", at: [0, 0, 0.1]}}\n";
    write_file(path("shot.yaml"), text);
    start();
    wait_for<Problems>([](const Problems& all) { return all.complete; });
    say(TextChange{7, path("shot.yaml"), text + "# changed\n"});
    say(TextChange{8, path("looks.yaml"), "render: {samples: 32}\n"});
    forget();
    say(SaveAs{"inner/copy", false});
    const auto welcome = wait_for<Welcome>();
    EXPECT_EQ(welcome.shot, path("inner/copy.yaml"));
    EXPECT_EQ(welcome.root, folder_.string());
    EXPECT_EQ(read_file(path("shot.yaml")), text);
    EXPECT_EQ(read_file(path("inner/copy.yaml")),
              "# ä shot\ncarom: 1\ninclude: [tables/pool_9ft.yaml, ../looks.yaml]\n"
              "objects: {block: {mesh: \"../block.obj\", at: [0, 0, 0.1]}}\n# changed\n");
    expect_opened("copy");
    // The change of the included file is still only in the page.
    const auto files = wait_for<Files>([](const Files& all) {
        return all.files.size() > 2 && all.files.back().name == "../looks.yaml";
    });
    EXPECT_EQ(files.files.back().text, "render: {samples: 32}\n");
    EXPECT_EQ(read_file(path("looks.yaml")), "render: {samples: 16}\n");
    forget();
    say(SaveAs{"shot", false});
    EXPECT_EQ(wait_for<Exists>().what, "save_as");
    say(SaveAs{"inner/copy.yaml", true});
    EXPECT_EQ(wait_for<Failed>().what, "save_as");
}

TEST_F(StudioFiles, SceneOfTheOlderFormat_IsImported) {
    start();
    say(Import{"sample_scene.txt", read_file(CAROM_SOURCE_DIR "/tests/examples/sample_scene.txt")});
    const auto imported = wait_for<Imported>();
    EXPECT_THAT(imported.yaml, HasSubstr("carom: 1"));
    EXPECT_FALSE(imported.notes.empty());
    forget();
    say(ReadParts{"sample", imported.yaml});
    const auto parts = wait_for<Parts>();
    std::set<std::string> sections;
    for (const Part& part : parts.parts) {
        sections.insert(part.section);
        EXPECT_FALSE(part.about.empty());
    }
    EXPECT_THAT(sections, Contains("objects"));
    EXPECT_THAT(sections, Contains("materials"));
    forget();
    say(Import{"broken.txt", "object {"});
    const auto broken = wait_for<Imported>();
    EXPECT_EQ(broken.yaml, "");
    EXPECT_FALSE(broken.problems.empty());
}

TEST_F(StudioFiles, AddedParts_GetFreeNamesAndTheirMaterials) {
    const ShotText from{
        "objects:\n"
        "  cup: {sphere: 10 mm, material: clay, at: [0, 0]}\n"
        "  lid: {box: [1 cm, 1 cm, 1 cm], material: felt, on: {of: cup}}\n"
        "materials: {clay: {colour: red}, felt: {colour: blue}}\n"
        "cameras: [{name: top, target: {of: cup}}]\n",
        folder_.string()};
    const ShotText to{
        "objects: {cup: {box: [1, 1, 1]}}\n"
        "materials: {clay: {colour: green}, felt: {colour: blue}}\n"
        "cameras: [{name: top}]\n",
        folder_.string()};
    const std::vector<Part> parts = read_parts(from, to);
    ASSERT_EQ(parts.size(), 5U);
    EXPECT_TRUE(parts[0].exists);
    EXPECT_FALSE(parts[1].exists);
    const std::vector<Addition> added =
        parts_to_add(from, to, {{"objects", "lid"}, {"objects", "cup"}, {"cameras", "top"}});
    ASSERT_EQ(added.size(), 4U);
    EXPECT_EQ(added[0].section, "materials");
    EXPECT_EQ(added[0].name, "clay_2");
    EXPECT_EQ(added[1].name, "lid");
    EXPECT_THAT(added[1].yaml, HasSubstr("of: \"cup_2\""));
    EXPECT_THAT(added[1].yaml, HasSubstr("material: felt"));
    EXPECT_EQ(added[2].name, "cup_2");
    EXPECT_EQ(added[2].of, "cup");
    EXPECT_THAT(added[2].yaml, HasSubstr("material: \"clay_2\""));
    EXPECT_EQ(added[3].name, "top_2");
    EXPECT_THAT(added[3].yaml, HasSubstr("name: \"top_2\""));
    EXPECT_THROW(static_cast<void>(parts_to_add(from, to, {{"objects", "none"}})), std::exception);
    EXPECT_THROW(static_cast<void>(read_parts({"a: [", folder_.string()}, to)), std::exception);
}

}  // namespace
}  // namespace carom::studio
