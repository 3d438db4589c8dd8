#include "pipeline/cli/terminal/console.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace carom::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Records what a console writes, with a clock that the test sets.
struct Recorder {
    std::string text;
    double time = 1000;

    ConsoleSettings settings() {
        ConsoleSettings settings;
        settings.clock = [this] { return time; };
        settings.write = [this](std::string_view written) { text += written; };
        return settings;
    }
};

ProgressSnapshot progress_at(double fraction) {
    ProgressSnapshot snapshot;
    snapshot.stage = "bake";
    snapshot.fraction = fraction;
    return snapshot;
}

/// Replaces all digits, so that texts with times can be compared.
std::string with_digits_as_zero(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char letter) { return letter >= '0' && letter <= '9'; }, '0');
    return text;
}

TEST(Console, Messages_AreLinesWithTheirLevel) {
    Recorder recorder;
    Console console(recorder.settings());
    console.info("done {} %s");  // not a format string
    console.warning("odd");
    console.error("bad");
    EXPECT_EQ(recorder.text, "carom: done {} %s\ncarom: warning: odd\ncarom: error: bad\n");
}

// Such characters may be in the name of a file.
TEST(Console, ControlCharactersInMessages_AreReplaced) {
    Recorder recorder;
    Console console(recorder.settings());
    console.error("no file '\x1b]0;title\x07'");
    EXPECT_EQ(recorder.text, "carom: error: no file '?]0;title?'\n");
}

TEST(Console, Quiet_PrintsOnlyWarningsAndErrors) {
    Recorder recorder;
    ConsoleSettings settings = recorder.settings();
    settings.quiet = true;
    Console console(settings);
    console.info("information");
    console.progress(progress_at(0.5));
    console.event("note", {}, "note\n", false);
    console.warning("odd");
    console.event("problem", {}, "shot.yaml:1:1: error: bad\n", true);
    EXPECT_EQ(recorder.text, "carom: warning: odd\nshot.yaml:1:1: error: bad\n");
}

TEST(Console, Colour_IsUsedOnlyWhenWanted) {
    Recorder recorder;
    ConsoleSettings settings = recorder.settings();
    {
        Console console(settings);
        console.error("bad");
    }
    EXPECT_THAT(recorder.text, Not(HasSubstr("\x1b")));
    EXPECT_EQ(Console(settings).error_word("error:"), "error:");
    settings.colour = true;
    Console console(settings);
    EXPECT_EQ(console.warning_word("warning:"), "\x1b[1;33mwarning:\x1b[0m");
    console.error("bad");
    EXPECT_THAT(recorder.text, HasSubstr("\x1b[1;31merror:\x1b[0m bad"));
}

TEST(Console, Json_IsOneObjectPerLine) {
    Recorder recorder;
    ConsoleSettings settings = recorder.settings();
    settings.json = true;
    settings.terminal = true;  // makes no difference
    settings.colour = true;
    Console console(settings);
    console.warning("say \"hi\"");
    JsonMembers members;
    members.add("line", 3);
    console.event("problem", members, "text for people\n", true);
    console.progress(progress_at(0.5));
    EXPECT_EQ(with_digits_as_zero(recorder.text),
              R"({"time":"0000-00-00T00:00:00.000Z","level":"warning","message":"say \"hi\""})"
              "\n"
              R"({"time":"0000-00-00T00:00:00.000Z","event":"problem","line":0})"
              "\n"
              R"({"time":"0000-00-00T00:00:00.000Z","event":"progress","stage":"bake",)"
              R"("fraction":0.0,"seconds_elapsed":0})"
              "\n");
}

TEST(Console, ProgressWithoutTerminal_IsALineEveryFewSeconds) {
    Recorder recorder;
    Console console(recorder.settings());
    for (int i = 0; i < 100; ++i) {
        recorder.time += 0.11;
        console.progress(progress_at(i / 100.0));
    }
    EXPECT_EQ(recorder.text, "carom: bake: 19 %\ncarom: bake: 65 %\n");
    EXPECT_THAT(recorder.text, Not(HasSubstr("\r")));
}

TEST(Console, Bar_IsRedrawnBelowTheLines) {
    Recorder recorder;
    ConsoleSettings settings = recorder.settings();
    settings.terminal = true;
    settings.columns = [] { return 31; };
    Console console(settings);
    console.progress(progress_at(0.5));
    console.progress(progress_at(0.6));  // too soon
    recorder.time += 0.2;
    console.progress(progress_at(1));
    console.warning("odd");
    console.end_progress();
    console.end_progress();  // twice does no harm
    const std::string erase = "\r\x1b[K";
    EXPECT_EQ(recorder.text, erase + "bake [========>       ]   50 %" +      //
                                 erase + "bake [================]  100 %" +  //
                                 erase + "carom: warning: odd\nbake [================]  100 %" +
                                 erase);
}

TEST(Console, Destructor_ErasesTheBar) {
    Recorder recorder;
    ConsoleSettings settings = recorder.settings();
    settings.terminal = true;
    {
        Console console(settings);
        console.progress(progress_at(0.5));
    }
    EXPECT_TRUE(recorder.text.ends_with("\r\x1b[K"));
}

}  // namespace
}  // namespace carom::cli
