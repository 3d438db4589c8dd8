// What the table of options becomes: completions in real shells, the manual in the real man.
#include <cstdlib>

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

class Help : public EndToEnd {
  protected:
    /// Runs a shell's command in the test's folder; what it printed and its error are in files.
    int shell(const std::string& command) const {
        const std::string line = "cd '" + path("") + "' && { " + command + "; } > '" + path("out") +
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

    /// What bash offers for the last of these words.
    std::vector<std::string> bash_offers(const std::string& words) const {
        EXPECT_EQ(run({"completion", "bash", "-o", "carom.bash"}).exit_code, 0);
        const int code = shell("bash -c 'set -eu; source ./carom.bash; COMP_WORDS=(" + words +
                               "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _carom; "
                               "printf \"%s\\n\" \"${COMPREPLY[@]}\"'");
        EXPECT_EQ(code, 0) << text_of("err");
        EXPECT_EQ(text_of("err"), "");
        return lines();
    }
};

TEST_F(Help, Bash_CompletesCommands) {
    EXPECT_THAT(bash_offers("carom re"), ElementsAre("render", "retime", "report"));
    EXPECT_THAT(bash_offers("carom \"\""), IsSupersetOf({"render", "export", "manual", "cache"}));
    EXPECT_THAT(bash_offers("carom cache \"\""), ElementsAre("list", "prune", "verify"));
    EXPECT_THAT(bash_offers("carom --v"), ElementsAre("--version"));
}

TEST_F(Help, Bash_CompletesOptionsOfTheCommandThatIsThere) {
    EXPECT_THAT(bash_offers("carom render tiny.yaml --fr"), ElementsAre("--frames"));
    EXPECT_THAT(bash_offers("carom cache prune --un"), ElementsAre("--unused-for"));
    EXPECT_THAT(bash_offers("carom bake --"), Not(Contains("--frames")));
}

TEST_F(Help, Bash_CompletesValuesAndFiles) {
    EXPECT_THAT(bash_offers("carom render --quality \"\""),
                ElementsAre("draft", "preview", "final"));
    EXPECT_THAT(bash_offers("carom check --log j"), ElementsAre("json"));
    EXPECT_THAT(bash_offers("carom new s.yaml --template d"), ElementsAre("dominoes"));
    EXPECT_THAT(bash_offers("carom completion z"), ElementsAre("zsh"));
    carom::testing::write_text(path("my shot.yaml"), "");
    EXPECT_THAT(bash_offers("carom render \"my\""), ElementsAre("my shot.yaml"));
    EXPECT_THAT(bash_offers("carom render -o tin"), ElementsAre("tiny.yaml"));
    EXPECT_THAT(bash_offers("carom render --threads \"\""), ElementsAre(""));
}

TEST_F(Help, Zsh_TakesItsCompletion) {
    ASSERT_EQ(run({"completion", "zsh", "-o", "_carom"}).exit_code, 0);
    EXPECT_THAT(text_of("_carom"), StartsWith("#compdef carom\n"));
    EXPECT_THAT(text_of("_carom"),
                HasSubstr("'--quality[a preset, which keeps the picture'\\''s shape\\: draft, "
                          "preview or final]:NAME:(draft preview final)'"));
    EXPECT_EQ(shell("zsh -f -c 'autoload -U compinit; compinit -u -d ./dump; source ./_carom; "
                    "print $_comps[carom]; whence -w _carom_cache_prune'"),
              0);
    EXPECT_EQ(text_of("err"), "");
    EXPECT_THAT(lines(), ElementsAre("_carom", "_carom_cache_prune: function"));
}

TEST_F(Help, Fish_TakesItsCompletion) {
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
    EXPECT_THAT(offers("carom cache "), ElementsAre("list", "prune", "verify"));
}

TEST_F(Help, Manual_IsSetWithoutAWarningAndHasEveryCommand) {
    ASSERT_EQ(run({"manual", "-o", "carom.1"}).exit_code, 0);
    EXPECT_EQ(shell("MANWIDTH=100 LC_ALL=C.UTF-8 man --warnings=w -l ./carom.1"), 0);
    EXPECT_EQ(text_of("err"), "");
    for (const char* part :
         {"carom render SHOT|BAKE", "--quality NAME", "carom cache prune", "EXIT STATUS",
          "carom render shot.yaml -o film.mp4", "carom plan break.yaml -o break.svg"}) {
        EXPECT_THAT(text_of("out"), HasSubstr(part));
    }
}

TEST_F(Help, OfEveryCommand_HasAnExample) {
    for (const std::string& name : bash_offers("carom \"\"")) {
        EXPECT_THAT(run({name, "--help"}).out, ContainsRegex("\nExamples?:\n  carom ")) << name;
    }
}

TEST_F(Help, UnknownShell_IsRefused) {
    const RunResult result = run({"completion", "tcsh"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_THAT(results(), IsEmpty());
}

/// Everything where it belongs, and the program finds its configs from there.
TEST_F(Help, Installed_IsWhole) {
    const std::string prefix = path("usr local");
    ASSERT_EQ(
        shell(std::string("cmake --install '") + CAROM_BINARY_DIR + "' --prefix '" + prefix + "'"),
        0)
        << text_of("err");
    for (const char* name :
         {"bin/carom", "libexec/carom/carom-film", "share/carom/configs/rigs/orbit.yaml",
          "share/carom/configs/carom.schema.json", "share/bash-completion/completions/carom",
          "share/zsh/site-functions/_carom", "share/fish/vendor_completions.d/carom.fish",
          "share/man/man1/carom.1"}) {
        EXPECT_TRUE(exists("usr local/" + std::string(name))) << name;
    }
    const auto installed = [&](const std::vector<std::string>& arguments) {
        return carom::testing::RunningProgram(prefix + "/bin/carom", arguments, options()).wait();
    };
    const RunResult made = installed({"new", "shot.yaml", "--template", "bank"});
    EXPECT_EQ(made.exit_code, 0) << made.err;
    EXPECT_THAT(text_of("shot.yaml"),
                HasSubstr("/usr local/share/carom/configs/carom.schema.json\n"));
    const RunResult checked = installed({"check", "shot.yaml"});
    EXPECT_EQ(checked.exit_code, 0) << checked.err;
    const RunResult frame = installed({"frame", "tiny.yaml", "-o", "f.png"});
    EXPECT_EQ(frame.exit_code, 0) << frame.err;
}

}  // namespace
}  // namespace carom::cli
