#include "pipeline/cli/command_line.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pipeline/cli/program_description.h"

namespace carom::cli {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

template <class T>
T parsed(const std::vector<std::string>& arguments) {
    const auto result = parse_command_line(arguments);
    return std::get<T>(std::get<CommandLine>(result).command);
}

EarlyExit early_exit(const std::vector<std::string>& arguments) {
    return std::get<EarlyExit>(parse_command_line(arguments));
}

TEST(CommandLine, Help_ShowsFourFirstCommandsAndThenAllInGroups) {
    const EarlyExit help = early_exit({"--help"});
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_EQ(help.err, "");
    std::size_t at = 0;
    for (const char* part :
         {"Usage: carom COMMAND [OPTIONS]\n", "\n  carom new shot.yaml\n",
          "\n  carom check shot.yaml\n", "\n  carom plan shot.yaml -o shot.svg\n",
          "\n  carom render shot.yaml -o film.mp4\n", "\nMake a shot:\n  new  ", "\n  check  ",
          "\nLook at a shot:\n  plan  ", "\nFilm a shot:\n  render  ", "\nKeep results:\n",
          "\nTools:\n", "\nOptions:\n", "130"}) {
        at = help.out.find(part, at);
        ASSERT_NE(at, std::string::npos) << part << help.out;
    }
}

TEST(CommandLine, WordsAfterTheMark_AreForTheEngineWhereItHasSome) {
    const auto submit = parsed<FarmCommand>({"farm", "submit", "a.yaml", "--", "--qos=high", "-q"});
    EXPECT_EQ(submit.input.path, "a.yaml");
    EXPECT_THAT(submit.engine_options, ElementsAre("--qos=high", "-q"));
    EXPECT_THAT(parsed<FarmCommand>({"farm", "submit", "a.yaml"}).engine_options, IsEmpty());
    EXPECT_EQ(parsed<CheckCommand>({"check", "--", "-a.yaml"}).input.path, "-a.yaml");
}

std::vector<std::string> all_commands() {
    std::vector<std::string> names;
    ProgramOptions options;
    for (const CommandDescription& command : describe_program(options).commands) {
        names.push_back(command.name);
    }
    EXPECT_GE(names.size(), 17U);
    return names;
}

TEST(CommandLine, EveryCommandsHelp_HasAnExampleThatParses) {
    for (const std::string& name : all_commands()) {
        const EarlyExit help = early_exit({name, "--help"});
        EXPECT_EQ(help.exit_code, 0);
        const std::size_t heading = help.out.find("\nExample");
        ASSERT_NE(heading, std::string::npos) << name;
        const std::size_t begin = help.out.find("\n  carom ", heading) + 9;
        std::istringstream words(help.out.substr(begin, help.out.find('\n', begin) - begin));
        std::vector<std::string> arguments;
        for (std::string word; words >> word && word != "&&";) {
            arguments.push_back(word);
        }
        EXPECT_TRUE(std::holds_alternative<CommandLine>(parse_command_line(arguments))) << name;
    }
}

TEST(CommandLine, Version_IsPrinted) {
    EXPECT_THAT(early_exit({"--version"}).out, StartsWith("carom 0."));
    EXPECT_EQ(early_exit({"--version"}).exit_code, 0);
}

TEST(CommandLine, Render_TakesItsOptions) {
    const auto command = parsed<RenderCommand>(
        {"render", "a.yaml", "-o", "b.mp4", "--frames", "0-47x2", "--quality", "draft", "--set",
         "render.samples=4", "--set=output.crf=20", "--threads", "3", "--cache", "/c"});
    EXPECT_EQ(command.input.path, "a.yaml");
    EXPECT_EQ(command.output, "b.mp4");
    EXPECT_EQ(command.frames, "0-47x2");
    EXPECT_EQ(command.input.quality, "draft");
    EXPECT_THAT(command.input.overrides, ElementsAre("render.samples=4", "output.crf=20"));
    EXPECT_EQ(command.threads, 3);
    EXPECT_EQ(command.cache.folder, "/c");
}

TEST(CommandLine, Retime_TakesItsOptions) {
    const auto command = parsed<RetimeCommand>(
        {"retime", "a.bake", "--speed", "1/8", "--from", "1.2s", "--to", "2 s", "--reverse",
         "--rig", "slow", "--camera", "c.yaml", "-o", "b.mp4", "--threads", "2"});
    EXPECT_EQ(command.render.input.path, "a.bake");
    EXPECT_EQ(command.render.input.camera_file, "c.yaml");
    EXPECT_EQ(command.render.output, "b.mp4");
    EXPECT_EQ(command.render.threads, 2);
    EXPECT_EQ(command.retime.speed, "1/8");
    EXPECT_EQ(command.retime.from, "1.2s");
    EXPECT_EQ(command.retime.to, "2 s");
    EXPECT_TRUE(command.retime.reverse);
    EXPECT_EQ(command.retime.rig, "slow");
    const auto ramp =
        parsed<RetimeCommand>({"retime", "a.bake", "--ramp", "0s:1, 1s:1/8", "--easing", "linear"});
    EXPECT_EQ(ramp.retime.ramp, "0s:1, 1s:1/8");
    EXPECT_EQ(ramp.retime.easing, "linear");
}

TEST(CommandLine, SetBeforeTheShot_DoesNotSwallowIt) {
    const auto command =
        parsed<RenderCommand>({"render", "--set", "a=1", "--set", "b=2", "s.yaml"});
    EXPECT_EQ(command.input.path, "s.yaml");
    EXPECT_THAT(command.input.overrides, ElementsAre("a=1", "b=2"));
}

TEST(CommandLine, SetWithListsAndSpaces_IsKeptWhole) {
    const auto command =
        parsed<CheckCommand>({"check", "s.yaml", "--set", "render.size=[640, 360]"});
    EXPECT_THAT(command.input.overrides, ElementsAre("render.size=[640, 360]"));
}

TEST(CommandLine, Defaults_AreEmpty) {
    const auto command = parsed<RenderCommand>({"render", "a.yaml"});
    EXPECT_EQ(command.output, "");
    EXPECT_EQ(command.threads, 0);
    EXPECT_THAT(command.input.overrides, IsEmpty());
    EXPECT_FALSE(parsed<FrameCommand>({"frame", "a.yaml"}).frame.has_value());
    EXPECT_FALSE(parsed<ExportCommand>({"export", "a.yaml"}).rate.has_value());
}

TEST(CommandLine, LoggingOptions_AreReadAfterTheCommand) {
    const auto result = parse_command_line({"check", "a.yaml", "--log", "json", "-q"});
    EXPECT_TRUE(std::get<CommandLine>(result).logging.json);
    EXPECT_TRUE(std::get<CommandLine>(result).logging.quiet);
}

TEST(CommandLine, FrameAndAt_ExcludeEachOther) {
    EXPECT_EQ(parsed<FrameCommand>({"frame", "a.yaml", "--frame", "12"}).frame, 12);
    EXPECT_EQ(parsed<FrameCommand>({"frame", "a.yaml", "--at", "1.25s"}).at, "1.25s");
    EXPECT_EQ(early_exit({"frame", "a.yaml", "--frame", "1", "--at", "1s"}).exit_code, 2);
}

TEST(CommandLine, Report_TakesItsOptions) {
    const auto command = parsed<ReportCommand>({"report", "a.bake", "--json", "-o", "r.json"});
    EXPECT_EQ(command.input.path, "a.bake");
    EXPECT_EQ(command.output, "r.json");
    EXPECT_TRUE(command.json);
    EXPECT_FALSE(parsed<ReportCommand>({"report", "a.yaml"}).json);
}

TEST(CommandLine, WrongUsage_IsExitCode2WithAPointerToHelp) {
    const std::vector<std::vector<std::string>> wrong{
        {"rendr", "a.yaml"},
        {"render"},
        {"render", "a.yaml", "b.yaml"},
        {"render", "a.yaml", "--frobnicate"},
        {"render", "a.yaml", "--threads", "-1"},
        {"render", "a.yaml", "--threads", "many"},
        {"frame", "a.yaml", "--frame", "-3"},
        {"export", "a.yaml", "--rate", "0"},
        {"check", "a.yaml", "--log", "xml"},
    };
    for (const auto& arguments : wrong) {
        const EarlyExit result = early_exit(arguments);
        EXPECT_EQ(result.exit_code, 2);
        EXPECT_EQ(result.out, "");
        EXPECT_THAT(result.err, StartsWith("carom: error: "));
        EXPECT_THAT(result.err, HasSubstr("\nSee 'carom "));
    }
}

TEST(CommandLine, MisspeltCommand_GetsAHint) {
    EXPECT_THAT(early_exit({"rendr", "a.yaml"}).err,
                StartsWith("carom: error: unknown command 'rendr' (did you mean 'render'?)\n"));
    EXPECT_THAT(early_exit({"shot.yaml"}).err,
                StartsWith("carom: error: unknown command 'shot.yaml'\n"));
    EXPECT_THAT(early_exit({"--verison"}).err,
                StartsWith("carom: error: unknown option '--verison'"));
}

TEST(CommandLine, RepeatedOption_IsNamed) {
    const std::string see = "\nSee 'carom render --help'.\n";
    EXPECT_EQ(early_exit({"render", "a.yaml", "--frames", "1", "--frames", "2"}).err,
              "carom: error: --frames is given twice; give it once" + see);
    EXPECT_EQ(early_exit({"render", "-o", "a", "a.yaml", "-o", "b", "--output", "c"}).err,
              "carom: error: --output is given 3 times; give it once" + see);
    EXPECT_THAT(early_exit({"cache", "list", "--cache", "a", "--cache", "b"}).err,
                StartsWith("carom: error: --cache is given twice; give it once\n"));
    const auto quiet = parsed<RenderCommand>({"render", "a.yaml", "--set", "a=1", "--set", "b=2"});
    EXPECT_THAT(quiet.input.overrides, ElementsAre("a=1", "b=2"));
}

TEST(CommandLine, MissingShot_IsNamed) {
    EXPECT_THAT(early_exit({"render"}).err, StartsWith("carom: error: SHOT|BAKE is required\n"));
}

TEST(CommandLine, NoArguments_GiveTheHelpOnStderr) {
    const EarlyExit result = early_exit({});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, early_exit({"--help"}).out);
}

TEST(CommandLine, Help_FitsEightyColumns) {
    std::vector<std::string> names = all_commands();
    names.emplace_back("--help");
    for (const std::string& name : names) {
        std::istringstream lines(early_exit({name, "--help"}).out);
        for (std::string line; std::getline(lines, line);) {
            EXPECT_LE(line.size(), 80U) << line;
        }
    }
}

}  // namespace
}  // namespace carom::cli
