#include "pipeline/config/closing_check.h"

#include <gtest/gtest.h>

namespace carom::pipeline::config {
namespace {

/// "offset message", or "fine".
std::string problem_of(std::string_view text) {
    const std::optional<ClosingProblem> problem = find_closing_problem(text);
    return problem ? std::to_string(problem->offset) + " " + problem->message : "fine";
}

TEST(ClosingCheck, UnclosedQuote_IsAProblemAtTheOpeningQuote) {
    EXPECT_EQ(problem_of("a: 'shot 7\nb: 1\n"),
              "3 YAML syntax: the quote opened here is never closed");
    EXPECT_EQ(problem_of("a: \"shot 7\\\"\nb: 1\n"),
              "3 YAML syntax: the quote opened here is never closed");
    EXPECT_EQ(problem_of("- a\n- 'b''\n"), "6 YAML syntax: the quote opened here is never closed");
    EXPECT_EQ(problem_of("'"), "0 YAML syntax: the quote opened here is never closed");
}

TEST(ClosingCheck, QuoteOverLinesThatAreNotIndented_IsAProblem) {
    const std::string later = " YAML syntax: the quote opened here is closed only on line ";
    const std::string shallow =
        "; further lines of a quoted text must be indented more deeply than its key, but line ";
    EXPECT_EQ(problem_of("a: 'x\nb: 'y'\n"), "3" + later + "2" + shallow + "2 is not");
    EXPECT_EQ(problem_of("a:\n  b: 'x\n\n  c: 1\nd: 'y'\n"),
              "8" + later + "5" + shallow + "4 is not");
    EXPECT_EQ(problem_of("- a: \"x\n  b: \"y\"\n"), "5" + later + "2" + shallow + "2 is not");
    EXPECT_EQ(problem_of("- 'x\n- 'y'\n"), "2" + later + "2" + shallow + "2 is not");
    EXPECT_EQ(problem_of("a: [1, 'x, 2]\nb: ['y']\n"), "7" + later + "2" + shallow + "2 is not");
    EXPECT_EQ(problem_of("a: 1\n'b\nc: 'd'\n"), "5" + later + "3" + shallow + "3 is not");
    EXPECT_EQ(problem_of("a:\n  'x\ny'\n"), "5" + later + "3" + shallow + "3 is not");
    EXPECT_EQ(problem_of("---\na: 'x\nb: 'y'\n"), "7" + later + "3" + shallow + "3 is not");
}

TEST(ClosingCheck, TextAfterTheClosingQuote_IsAProblem) {
    EXPECT_EQ(problem_of("a: 'Bob's shot'\n"),
              "8 YAML syntax: 's shot'' follows a closing quote; is a quote or a comma missing? An "
              "apostrophe in single quotes is written twice: ''");
    EXPECT_EQ(problem_of("a: [\"x\" \"y\"]\n"),
              "8 YAML syntax: '\"y\"]' follows a closing quote; is a quote or a comma missing?");
    EXPECT_EQ(problem_of("a: [x, 'y,\n    'z']\n"),
              "7 YAML syntax: the quote opened here is closed only on line 2, where 'z']' follows "
              "it");
}

TEST(ClosingCheck, BracketsOverLinesThatAreNotIndented_AreAProblem) {
    EXPECT_EQ(problem_of("a: {b: 1\nc: 2\nd: {e: 3}\n"),
              "3 YAML syntax: this '{' must be closed before line 2, which is not indented more "
              "deeply than its key");
    EXPECT_EQ(problem_of("a:\n  - {b: [1, 2}\n"), "11 YAML syntax: this '[' is closed by a '}'");
    EXPECT_EQ(problem_of("a: [1,\n    {b: 1,\n    c: 2]\n"),
              "11 YAML syntax: this '{' is closed by a ']' on line 3");
    EXPECT_EQ(problem_of("- a: [1\n  b: 2\n"),
              "5 YAML syntax: this '[' must be closed before line 2, which is not indented more "
              "deeply than its key");
    EXPECT_EQ(problem_of("a:\n# comment\n  [b: 1\nc: 2\n"),
              "15 YAML syntax: this '[' must be closed before line 4, which is not indented more "
              "deeply than its key");
    EXPECT_EQ(problem_of("a:\n{ b: 1\n  c: 2\nd: 3\n"),
              "3 YAML syntax: this '{' must be closed before line 4, which is not indented more "
              "deeply than its key");
}

TEST(ClosingCheck, BracketsOverIndentedLines_AreFine) {
    EXPECT_EQ(problem_of("a: [1,\n  {b: 1,\n c: 2}\n]\nd: {\n}\n"), "fine");
    EXPECT_EQ(problem_of("a:\n  b: [\n    1,\n# comment\n\n    2\n  ]\n"), "fine");
    EXPECT_EQ(problem_of("{a: 1,\nb: [2,\n3]}\n"), "fine");
}

TEST(ClosingCheck, QuoteOverIndentedLines_IsFine) {
    EXPECT_EQ(problem_of("a: 'one\n two'\nb: 1\n"), "fine");
    EXPECT_EQ(problem_of("a:\n  b: \"one\n\n    two\\\n    three\"\n  c: 1\n"), "fine");
    EXPECT_EQ(problem_of("a: {b: 'one\n  two', c: 1}\n"), "fine");
    EXPECT_EQ(problem_of("'one\ntwo'\n"), "fine");
}

TEST(ClosingCheck, AMillionQuotesOnALine_AreReadQuickly) {
    std::string text = "a: [";
    for (int i = 0; i < 1'000'000; ++i) {
        text += "'',";
    }
    EXPECT_EQ(problem_of(text + "]\n"), "fine");
}

TEST(ClosingCheck, QuotesThatOpenNothing_AreFine) {
    EXPECT_EQ(problem_of("a: Bob's shot  # isn't it\n# it's\nb: 3 in\"\n"), "fine");
    EXPECT_EQ(problem_of("a: word\n  'still the word\nb: 1\n"), "fine");
    EXPECT_EQ(problem_of("a: [word\n  'still the word, x]\nb: 1\n"), "fine");
    EXPECT_EQ(problem_of("a: |\n  'text\n\n  \"text\nb: >-\n 'text\nc: 1\n"), "fine");
    EXPECT_EQ(problem_of("a:\n- |\n  'text\n- 1\n"), "fine");
    EXPECT_EQ(problem_of("? 'a'\n: 'b'\n'c': &x 'd'\ne: {'f': 'g', \"h\":\"i\"}\nj: *x\n"), "fine");
    EXPECT_EQ(problem_of("a: 'it''s'\nb: \"say \\\"x\\\"\"\nc: ''\nd: ['', \"\"] # '\n"), "fine");
    EXPECT_EQ(problem_of("a: 'x'\r\nb: 'y' # '\r\n"), "fine");
}

}  // namespace
}  // namespace carom::pipeline::config
