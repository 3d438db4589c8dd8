// Documents of a session: drawings to look at, and files that the program writes.
#include "pipeline/studio/documents.h"

#include <cstdlib>

#include "tests/pipeline/studio/session_fixture.h"

namespace carom::studio {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

class StudioDocuments : public StudioSession {
  protected:
    void start_simulated() {
        SessionOptions all = options();
        all.program = CAROM_BINARY_DIR "/bin/carom";
        StudioSession::start(std::move(all));
        wait_for<Problems>([](const Problems& problems) { return problems.complete; });
    }

    Made make(const Make& request) {
        say(request);
        return wait_for<Made>([&](const Made& made) { return made.q == request.q; });
    }

    Failed failure(const Make& request) {
        say(request);
        return wait_for<Failed>([&](const Failed& one) { return one.v == request.q; });
    }

    /// The bytes of what can be fetched.
    std::string fetched(const Made& made) {
        const auto download = session_->find(made.address);
        return !download ? "" : download->bytes ? *download->bytes : read_file(download->path);
    }

    /// What the command line writes into a file of that name.
    std::string written(const std::string& words, const std::string& name) {
        const std::string command = std::string(CAROM_BINARY_DIR "/bin/carom ") + words + " " +
                                    path("direct_" + name) + " -q --cache " + path("other") + " " +
                                    path("shot.yaml") + " > /dev/null";
        EXPECT_EQ(std::system(command.c_str()), 0) << command;  // NOLINT: a fixed command
        return read_file(path("direct_" + name));
    }
};

TEST_F(StudioDocuments, DrawingsToLookAt_HaveTheBytesOfTheCommandLine) {
    start_simulated();
    const Made plan = make({.q = 1, .what = "plan"});
    EXPECT_EQ(plan.file, "");
    EXPECT_GT(plan.v, 0);
    EXPECT_EQ(session_->find(plan.address)->type, "image/svg+xml");
    EXPECT_TRUE(fetched(plan) == written("plan -o", "plan.svg"));
    const Made plot = make({.q = 2, .what = "plot"});
    EXPECT_TRUE(fetched(plot) == written("report --plot", "plot.svg"));
    const Made report = make({.q = 3, .what = "report"});
    EXPECT_EQ(fetched(report), written("report -o", "report.txt"));
    EXPECT_FALSE(session_->find("/made/99.svg"));
}

TEST_F(StudioDocuments, Exports_HaveTheBytesOfTheCommandLine) {
    start_simulated();
    std::int64_t q = 0;
    for (const auto& [what, name, words] :
         std::vector<std::array<std::string, 3>>{{"plan", "p.svg", "plan -o"},
                                                 {"plan", "p.png", "plan -o"},
                                                 {"plot", "r.svg", "report --plot"},
                                                 {"report", "r.txt", "report -o"},
                                                 {"report", "r.json", "report --json -o"},
                                                 {"export", "t.csv", "export -o"},
                                                 {"export", "t.json", "export -o"},
                                                 {"export", "t.glb", "export -o"},
                                                 {"export", "t.usda", "export -o"},
                                                 {"events", "e.csv", "export --events"}}) {
        const Made made = make({.q = ++q, .what = what, .output = name});
        EXPECT_EQ(made.file, path(name));
        EXPECT_EQ(made.what, what);
        const std::string bytes = read_file(path(name));
        EXPECT_FALSE(bytes.empty()) << name;
        EXPECT_TRUE(bytes == written(words, name)) << name;
        EXPECT_TRUE(bytes == fetched(made)) << name;
    }
    const Made samples = make({.q = ++q, .what = "export", .output = "s.csv", .rate = 12.5});
    EXPECT_EQ(fetched(samples), written("export --rate 12.5 -o", "s.csv"));
}

TEST_F(StudioDocuments, Drawings_ShowTextsThatAreNotSaved) {
    start_simulated();
    const std::string before = fetched(make({.q = 1, .what = "report"}));
    std::string text = read_file(path("shot.yaml"));
    const std::size_t at = text.find("speed: ");
    ASSERT_NE(at, std::string::npos);
    text.insert(at + 7, "1");
    say(TextChange{.v = 5, .file = path("shot.yaml"), .text = text});
    wait_for<Problems>(
        [](const Problems& problems) { return problems.v == 5 && problems.complete; });
    const Made made = make({.q = 2, .what = "report"});
    EXPECT_EQ(made.v, 5);
    EXPECT_NE(fetched(made), before);
}

TEST_F(StudioDocuments, FileThatExists_IsReplacedOnlyIfAllowed) {
    start_simulated();
    write_file(path("mine.csv"), "mine");
    say(Make{.q = 1, .what = "export", .output = "mine.csv"});
    const auto exists = wait_for<Exists>();
    EXPECT_EQ(exists.what, "make");
    EXPECT_EQ(exists.name, "mine.csv");
    EXPECT_EQ(read_file(path("mine.csv")), "mine");
    make({.q = 2, .what = "export", .output = "mine.csv", .overwrite = true});
    EXPECT_THAT(read_file(path("mine.csv")), StartsWith("object,"));
}

TEST_F(StudioDocuments, InvalidRequests_AreRefused) {
    start_simulated();
    EXPECT_THAT(failure({.q = 1, .what = "export", .output = "../elsewhere.csv"}).message,
                HasSubstr("files can be written below"));
    EXPECT_THAT(failure({.q = 2, .what = "export", .output = "x.stl"}).message,
                HasSubstr("an export can only be written as .csv, .json, .glb or .usda"));
    EXPECT_THAT(failure({.q = 3, .what = "plan", .output = "none/x.svg"}).message,
                HasSubstr("does not exist"));
    say(Make{.q = 4, .what = "nothing"});
    wait_for<Failed>([](const Failed& one) { return one.message == "'nothing' cannot be made"; });
    say(Make{.q = 5, .what = "export"});
    wait_for<Failed>(
        [](const Failed& one) { return one.message == "an export needs the name of a file"; });
    say(Make{.q = 6, .what = "frame", .frame = -1});
    wait_for<Failed>([](const Failed& one) {
        return one.message == "neither frames nor rates can be negative";
    });
    EXPECT_THAT(
        failure({.q = 7, .what = "export", .output = "shot.yaml", .overwrite = true}).message,
        HasSubstr("this is the name of the open shot"));
    EXPECT_FALSE(fs::exists(path("x.stl")));
}

TEST_F(StudioDocuments, ContactSheet_IsRenderedAndCanBeStopped) {
    fs::copy_file(path("shot.yaml"), path("slow.yaml"));
    start_simulated();
    const Made sheet = make({.q = 1, .what = "contact_sheet"});
    EXPECT_EQ(session_->find(sheet.address)->type, "image/png");
    EXPECT_EQ(fetched(sheet).substr(1, 3), "PNG");
    EXPECT_GT(wait_for<Making>([](const Making& one) { return one.stage == "render"; }).fraction,
              0);
    say(Make{.q = 2, .what = "frame", .output = "f.png", .frame = 3});
    say(StopMaking{.q = 2});
    EXPECT_EQ(wait_for<Failed>([](const Failed& one) { return one.v == 2; }).message,
              "it was stopped");
    EXPECT_FALSE(fs::exists(path("f.png")));
    // What a page wanted to look at ends with it: what another page asks for does not wait for it.
    std::string slow = read_file(path("shot.yaml"));
    slow.insert(slow.find("render: {") + 9, "samples: 60000, ");
    write_file(path("shot.yaml"), slow);
    session_->opened(2);
    session_->received(2, to_json(PageMessage{Make{.q = 3, .what = "contact_sheet"}}));
    wait_for<Making>([](const Making& one) { return one.q == 3 && one.stage == "render"; });
    session_->closed(2);
    EXPECT_EQ(wait_for<Failed>([](const Failed& one) { return one.v == 3; }).message,
              "it was stopped");
    for (const auto& entry : fs::directory_iterator(path("cache") + "/studio")) {
        EXPECT_THAT(entry.path().filename().string(), testing::Not(StartsWith("look_")));
    }
}

}  // namespace
}  // namespace carom::studio
