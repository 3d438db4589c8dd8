// End-to-end tests of the help: completions in real shells, the manual with the real man.
#include <cstdlib>
#include <filesystem>
#include <regex>

#include "tests/folders.h"
#include "tests/pipeline/cli/end_to_end.h"

namespace carom::cli {
namespace {

using carom::testing::EndToEnd;
using carom::testing::RunResult;
using ::testing::Contains;
using ::testing::ContainsRegex;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;
using ::testing::Not;
using ::testing::StartsWith;
using ::testing::UnorderedElementsAre;

class Help : public EndToEnd {
  protected:
    /// Runs a shell command in the test's folder and writes its output and its errors to files.
    int shell(const std::string& command) const {
        const std::string folder =
            std::filesystem::path(carom::testing::carom_program()).parent_path();
        const std::string line = "cd '" + path("") + "' && export PATH='" + folder +
                                 "':\"$PATH\" && { " + command + "; } > '" + path("out") +
                                 "' 2> '" + path("err") + "'";
        return WEXITSTATUS(std::system(line.c_str()));
    }
    [[nodiscard]] std::vector<std::string> lines() const {
        std::istringstream text(text_of("out"));
        std::vector<std::string> result;
        for (std::string line; std::getline(text, line);) {
            result.push_back(line);
        }
        return result;
    }

    /// The words of a line as bash passes them to a completion: with their quotes, with "=" and ":"
    /// as separate words, and with an empty word after a blank at the end.
    static std::string bash_words(const std::string& line) {
        static const std::regex kWord(R"(("[^"]*"?|[^\s=:"])+|[=:]+|\s$)");
        std::string words;
        for (std::sregex_iterator word(line.begin(), line.end(), kWord), end; word != end; ++word) {
            words += word->str() == " " ? "\"\" " : "$'" + word->str() + "' ";
        }
        return words;
    }

    /// The completions that bash offers when the tab key is pressed after this line.
    std::vector<std::string> bash_offers(const std::string& line) const {
        EXPECT_EQ(run({"completion", "bash", "-o", "carom.bash"}).exit_code, 0);
        carom::testing::write_text(path("press_tab"),
                                   "set -eu; source ./carom.bash; COMP_LINE=$'" + line +
                                       "'; COMP_WORDS=(" + bash_words(line) +
                                       "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _carom; "
                                       "printf '%s\\n' \"${COMPREPLY[@]}\"\n");
        const int code = shell("bash ./press_tab");
        EXPECT_EQ(code, 0) << text_of("err");
        EXPECT_EQ(text_of("err"), "");
        return lines();
    }
};

TEST_F(Help, Bash_CompletesCommands) {
    EXPECT_THAT(bash_offers("carom re"), UnorderedElementsAre("render", "retime", "report"));
    EXPECT_THAT(bash_offers("carom "), IsSupersetOf({"render", "export", "compare", "cache"}));
    EXPECT_THAT(bash_offers("carom cache "),
                UnorderedElementsAre("list", "prune", "verify", "push", "pull", "merge"));
    EXPECT_THAT(bash_offers("carom --v"), ElementsAre("--version"));
}

TEST_F(Help, Bash_CompletesOptionsOfTheTypedCommand) {
    EXPECT_THAT(bash_offers("carom render tiny.yaml --fr"), ElementsAre("--frames"));
    EXPECT_THAT(bash_offers("carom cache prune --un"), ElementsAre("--unused-for"));
    EXPECT_THAT(bash_offers("carom bake --"), Not(Contains("--frames")));
}

TEST_F(Help, Bash_CompletesValuesAndFiles) {
    EXPECT_THAT(bash_offers("carom render --quality "),
                UnorderedElementsAre("draft", "preview", "final"));
    EXPECT_THAT(bash_offers("carom check --log j"), ElementsAre("json"));
    EXPECT_THAT(bash_offers("carom new s.yaml --template d"), ElementsAre("dominoes"));
    EXPECT_THAT(bash_offers("carom completion z"), ElementsAre("zsh"));
    EXPECT_THAT(bash_offers("carom sweep tiny.yaml --sampling l"), ElementsAre("latin"));
    EXPECT_THAT(bash_offers("carom sweep tiny.yaml --measure reb"), ElementsAre("rebound_angle:"));
    carom::testing::write_text(path("my shot.yaml"), "");
    EXPECT_THAT(bash_offers("carom render my"), ElementsAre("my shot.yaml"));
    EXPECT_THAT(bash_offers("carom render -o tin"), ElementsAre("tiny.yaml"));
    EXPECT_THAT(bash_offers("carom render --threads "), ElementsAre(""));
    EXPECT_THAT(bash_offers("carom render \"my s"), ElementsAre("my shot.yaml"));
    EXPECT_THAT(bash_offers("carom check --log=j"), ElementsAre("json"));
    EXPECT_THAT(bash_offers("carom render --output=tin"), ElementsAre("tiny.yaml"));
    EXPECT_THAT(bash_offers("carom render --output="), Contains("tiny.yaml"));
}

TEST_F(Help, Bash_OffersFilesByTheirEnding) {
    carom::testing::write_text(path("a.bake"), "");
    carom::testing::write_text(path("a.mp4"), "");
    EXPECT_THAT(bash_offers("carom render "), UnorderedElementsAre("a.bake", "tiny.yaml"));
    EXPECT_THAT(bash_offers("carom bake "), ElementsAre("tiny.yaml"));
    EXPECT_THAT(bash_offers("carom export -o a.m"), ElementsAre("a.mp4"));
}

TEST_F(Help, Bash_CompletesKeysAndTheirValues) {
    EXPECT_THAT(bash_offers("carom render --set render.sam"), ElementsAre("render.samples="));
    EXPECT_THAT(bash_offers("carom render --set rend"), ElementsAre("render."));
    // bash passes "=" as a separate word and completes the word after it.
    EXPECT_THAT(bash_offers("carom render --set ball_set.kind=s"), ElementsAre("snooker"));
    EXPECT_THAT(bash_offers("carom render --set=ball_set.kind=s"), ElementsAre("snooker"));
    EXPECT_THAT(bash_offers("carom render --set ball_set.kind="),
                ElementsAre("pool", "snooker", "carom"));
    EXPECT_THAT(bash_offers("carom render --set ball_set.kind= --qua"), ElementsAre("--quality"));
    EXPECT_THAT(bash_offers("carom render --set no.such.key."), ElementsAre(""));
}

TEST_F(Help, Bash_CompletesNamesOfTheShot) {
    carom::testing::write_text(path("named.yaml"),
                               "carom: 1\nunknown: [1, 2]\ntable: {include: pool_9ft}\n"
                               "rack: {set: nine_ball}\nballs: {mine: {at: [0, 0]}, cue: {}}\n"
                               "cameras: [{name: opening}, {position: [1, 1, 1]}]\n");
    EXPECT_THAT(bash_offers("carom retime named.yaml --rig "), ElementsAre("opening"));
    EXPECT_THAT(bash_offers("carom retime \"named.yaml\" --rig=o"), ElementsAre("opening"));
    EXPECT_THAT(bash_offers("carom render named.yaml --set balls.m"), ElementsAre("balls.mine."));
    EXPECT_THAT(bash_offers("carom render named.yaml --set balls.n"), ElementsAre("balls.nine."));
    EXPECT_THAT(bash_offers("carom render named.yaml --set balls.mine.a"),
                Contains("balls.mine.at="));
    EXPECT_THAT(bash_offers("carom render named.yaml --set cameras."),
                ElementsAre("cameras.opening.", "cameras.1."));
    EXPECT_THAT(bash_offers("carom render --set balls.m"), ElementsAre(""));
}

/// A message would disturb the user while typing.
TEST_F(Help, CompletionOfUnreadableFiles_PrintsNoErrors) {
    carom::testing::write_text(path("broken.yaml"), "carom: 1\nballs: {cue: [}\n");
    carom::testing::write_text(path("broken.bake"), "no bake");
    const std::vector<std::vector<std::string>> lines{
        {"__complete"},
        {"__complete", ""},
        {"__complete", "nonsense", ""},
        {"__complete", "retime", "broken.yaml", "--rig", ""},
        {"__complete", "retime", "broken.bake", "--rig", ""},
        {"__complete", "retime", "missing.yaml", "--rig", ""},
        {"__complete", "retime", ".", "--rig", ""},
        {"__complete", "render", "broken.yaml", "--set", "=.[]]"},
        {"__complete", "render", "broken.yaml", "--set=balls.", "="},
    };
    for (const auto& words : lines) {
        const RunResult result = run(words);
        EXPECT_EQ(result.exit_code, 0);
        EXPECT_EQ(result.err, "");
    }
}

TEST_F(Help, Zsh_LoadsItsCompletion) {
    ASSERT_EQ(run({"completion", "zsh", "-o", "_carom"}).exit_code, 0);
    EXPECT_THAT(text_of("_carom"), StartsWith("#compdef carom\n"));
    EXPECT_EQ(shell("zsh -f -c 'autoload -U compinit; compinit -u -d ./dump; source ./_carom; "
                    "print $_comps[carom]'"),
              0);
    EXPECT_EQ(text_of("err"), "");
    EXPECT_THAT(lines(), ElementsAre("_carom"));
}

TEST_F(Help, Zsh_OffersTheCompletionsOfTheProgram) {
    ASSERT_EQ(run({"completion", "zsh", "-o", "_carom"}).exit_code, 0);
    // The last words of compadd and _files form the menu.
    const auto offers = [&](const std::string& words) {
        EXPECT_EQ(shell("zsh -f -c 'compdef() {}; compadd() { [[ $1 != -S ]] || print "
                        "\"suffix<$2>\"; while [[ $1 != -- ]]; do shift; done; "
                        "shift; print -l -- $@ }; _files() { print -l -- files $@ }; "
                        "compset() {}; source ./_carom; words=(" +
                        words + "); CURRENT=$#words; _carom || true'"),
                  0);
        EXPECT_EQ(text_of("err"), "");
        return lines();
    };
    EXPECT_THAT(offers("carom re"), UnorderedElementsAre("render", "retime", "report"));
    EXPECT_THAT(offers("carom render --quality \"\""), ElementsAre("draft", "final", "preview"));
    EXPECT_THAT(offers("carom render --set render.sam"),
                ElementsAre("suffix<>", "render.samples="));
    EXPECT_THAT(offers("carom render tiny.yaml --set ball_set.kind=s"),
                ElementsAre("ball_set.kind=snooker"));
    EXPECT_THAT(offers("carom render \"\""), ElementsAre("files", "-g", "*.(yaml|yml|bake)"));
    EXPECT_THAT(offers("carom render --cache \"\""), ElementsAre("files", "-/"));
    EXPECT_THAT(offers("carom render --threads \"\""), IsEmpty());
}

TEST_F(Help, Fish_OffersTheCompletionsOfTheProgram) {
    ASSERT_EQ(run({"completion", "fish", "-o", "carom.fish"}).exit_code, 0);
    const auto offers = [&](const std::string& line) {
        EXPECT_EQ(
            shell("HOME=. fish -c 'source ./carom.fish; complete -C \"" + line + "\" | cut -f1'"),
            0);
        EXPECT_EQ(text_of("err"), "");
        return lines();
    };
    EXPECT_THAT(offers("carom re"), ElementsAre("render", "report", "retime"));
    EXPECT_THAT(offers("carom render --qual"), ElementsAre("--quality"));
    EXPECT_THAT(offers("carom render --quality "), ElementsAre("draft", "final", "preview"));
    EXPECT_THAT(offers("carom cache "),
                UnorderedElementsAre("list", "prune", "verify", "push", "pull", "merge"));
    EXPECT_THAT(offers("carom render --set render.sam"), ElementsAre("render.samples="));
    carom::testing::write_text(path("a.mp4"), "");
    EXPECT_THAT(offers("carom render tiny.yaml --set ball_set.kind=s"),
                ElementsAre("ball_set.kind=snooker"));
    EXPECT_THAT(offers("carom render ./"), ElementsAre("./tiny.yaml"));
    EXPECT_THAT(offers("carom render --output=a"), ElementsAre("--output=a.mp4"));
    EXPECT_THAT(offers("carom render --camera="), ElementsAre("--camera=tiny.yaml"));
}

TEST_F(Help, Manual_HasAPageForEveryCommandThatIsFormattedWithoutAWarning) {
    std::filesystem::create_directory(path("man1"));
    ASSERT_EQ(run({"__manual", "man1"}).exit_code, 0);
    std::vector<std::string> pages{"carom"};
    for (const std::string& name : bash_offers("carom ")) {
        pages.push_back("carom-" + name);
    }
    EXPECT_GE(pages.size(), 18U);
    for (const std::string& page : pages) {
        const std::string file = "./man1/" + page + ".1";
        EXPECT_EQ(shell("MANWIDTH=100 LC_ALL=C.UTF-8 man --warnings=w -l " + file), 0) << page;
        EXPECT_EQ(text_of("err"), "") << page;
        EXPECT_THAT(text_of("out"), HasSubstr("\nEXAMPLES\n")) << page;
        EXPECT_EQ(shell("groff -ww -man -Tutf8 " + file), 0) << page;
        EXPECT_EQ(text_of("err"), "") << page;
    }
    EXPECT_EQ(shell("MANWIDTH=100 LC_ALL=C.UTF-8 man -l man1/carom-render.1"), 0);
    for (const char* part : {"carom-render - simulate a shot", "carom render [OPTIONS] SHOT|BAKE",
                             "--quality NAME", "-o, --output FILE", "carom(1)"}) {
        EXPECT_THAT(text_of("out"), HasSubstr(part));
    }
    EXPECT_EQ(shell("MANWIDTH=100 LC_ALL=C.UTF-8 man -l man1/carom.1"), 0);
    for (const char* part : {"carom-render(1)", "Film a shot", "CAROM_CACHE_SIZE", "130"}) {
        EXPECT_THAT(text_of("out"), HasSubstr(part));
    }
}

TEST_F(Help, Manual_ThatCannotBeWritten_IsAnError) {
    const RunResult result = run({"__manual", "no/such/folder"});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, StartsWith("carom: error: "));
}

TEST_F(Help, OfEveryCommand_HasAnExample) {
    for (const std::string& name : bash_offers("carom ")) {
        EXPECT_THAT(run({name, "--help"}).out, ContainsRegex("\nExamples?:\n  carom ")) << name;
    }
}

TEST_F(Help, UnknownShell_IsRejected) {
    const RunResult result = run({"completion", "tcsh"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_THAT(results(), IsEmpty());
}

/// All files are in the right folders, and the installed program finds its configs.
TEST_F(Help, Installation_IsComplete) {
    const std::string prefix = path("usr local");
    ASSERT_EQ(
        shell(std::string("cmake --install '") + CAROM_BINARY_DIR + "' --prefix '" + prefix + "'"),
        0)
        << text_of("err");
    for (const char* name :
         {"bin/carom", "libexec/carom/carom-film", "share/carom/configs/rigs/orbit.yaml",
          "share/carom/configs/carom.schema.json", "share/bash-completion/completions/carom",
          "share/zsh/site-functions/_carom", "share/fish/vendor_completions.d/carom.fish",
          "share/man/man1/carom.1", "share/man/man1/carom-render.1"}) {
        EXPECT_TRUE(exists("usr local/" + std::string(name))) << name;
    }
    const auto installed = [&](const std::vector<std::string>& arguments) {
        return carom::testing::RunningProgram(prefix + "/bin/carom", arguments, options()).wait();
    };
    const RunResult made = installed({"new", "shot.yaml", "--template", "bank"});
    EXPECT_EQ(made.exit_code, 0) << made.err;
    EXPECT_THAT(text_of("shot.yaml"),
                HasSubstr("$schema=usr local/share/carom/configs/carom.schema.json\n"));
    const RunResult checked = installed({"check", "shot.yaml"});
    EXPECT_EQ(checked.exit_code, 0) << checked.err;
    const RunResult frame = installed({"frame", "tiny.yaml", "-o", "f.png"});
    EXPECT_EQ(frame.exit_code, 0) << frame.err;
}

}  // namespace
}  // namespace carom::cli
