#include "pipeline/config/problem.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pipeline/config/load_shot.h"

namespace carom::pipeline {
namespace {

Problem unknown_key() {
    Problem problem;
    problem.place = {"shot.yaml", 14, 9, 7};
    problem.message = "unknown key 'postion' in camera 'opening' (did you mean 'position'?)";
    problem.source_line = "        postion: [0, -2, 1]";
    return problem;
}

TEST(Problem, Formatted_LooksLikeACompilersMessage) {
    EXPECT_EQ(format(unknown_key()),
              "shot.yaml:14:9: error: unknown key 'postion' in camera 'opening' (did you mean "
              "'position'?)\n"
              "   14 |         postion: [0, -2, 1]\n"
              "      |         ^~~~~~~\n");
}

TEST(Problem, Warning_IsFormattedAsAWarning) {
    Problem problem = unknown_key();
    problem.severity = Severity::warning;
    EXPECT_THAT(format(problem), testing::StartsWith("shot.yaml:14:9: warning: unknown"));
    EXPECT_FALSE(has_errors({problem}));
    EXPECT_TRUE(has_errors({problem, unknown_key()}));
}

TEST(Problem, OfAnIncludedFile_HasTheIncludingPlace) {
    Problem problem = unknown_key();
    problem.included_by = {{"looks.yaml", 2, 10, 1}, {"--quality", 0, 0, 1}};
    EXPECT_THAT(format(problem), testing::EndsWith("      |         ^~~~~~~\n"
                                                   "      = included by looks.yaml:2:10\n"
                                                   "      = included by --quality\n"));
}

TEST(Problem, Suggestion_IsWhatTheMessageOffers) {
    const std::vector<Problem> problems =
        load_shot_text("carom: 1\nrendr: {}\nsimulation: {duration: x}\n", "s.yaml").problems;
    ASSERT_EQ(problems.size(), 2U);
    EXPECT_EQ(problems[0].message, "unknown key 'rendr' in the shot (did you mean 'render'?)");
    EXPECT_EQ(problems[0].suggestion, "render");
    EXPECT_EQ(problems[1].suggestion, "");
}

TEST(Problem, SeverityWord_MayBeAnother) {
    const std::string text = format(unknown_key(), "<b>error:</b>");
    EXPECT_THAT(text, testing::StartsWith("shot.yaml:14:9: <b>error:</b> unknown key 'postion'"));
}

TEST(Problem, WithoutALine_IsOneLine) {
    Problem problem;
    problem.place.file = "gone.yaml";
    problem.message = "the file does not exist";
    EXPECT_EQ(format(problem), "gone.yaml: error: the file does not exist\n");
}

TEST(Problem, TabsAndWideText_KeepTheCaretUnderItsToken) {
    Problem problem;
    problem.place = {"a.yaml", 3, 6, 2};
    problem.message = "m";
    problem.source_line = "\tk\xC3\xA9y: no";
    EXPECT_EQ(format(problem),
              "a.yaml:3:6: error: m\n"
              "    3 | \tk\xC3\xA9y: no\n"
              "      | \t    ^~\n");
}

TEST(Problem, ControlCharacters_AreEscaped) {
    Problem problem;
    problem.place = {"a.yaml", 1, 1, 1};
    problem.message = "'\x1b[2J'";
    problem.source_line = "\x1b[2J";
    EXPECT_EQ(format(problem).find('\x1b'), std::string::npos);
}

TEST(Problem, LongLine_IsShownAroundTheToken) {
    Problem problem;
    problem.place = {"a.yaml", 1, 1001, 3};
    problem.message = "m";
    problem.source_line = std::string(1000, 'a') + "bcd" + std::string(1000, 'e');
    const std::string text = format(problem);
    EXPECT_LT(text.size(), 500U);
    EXPECT_THAT(text, testing::HasSubstr("    1 | ...aaa"));
    EXPECT_THAT(text, testing::HasSubstr("eee...\n"));
    // The caret has the same column as the token.
    const std::size_t line = text.find("bcd") - text.find("    1 | ");
    const std::size_t caret = text.find('^') - text.rfind("      | ");
    EXPECT_EQ(line, caret);
}

}  // namespace
}  // namespace carom::pipeline
