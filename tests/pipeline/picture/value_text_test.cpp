#include "pipeline/picture/value_text.h"

#include <gmock/gmock.h>

namespace carom::pipeline {
namespace {

using ::testing::ElementsAre;

std::vector<TextPiece> pieces_of(const std::string& text) {
    auto parsed = parse_value_text(text);
    const auto* problem = std::get_if<TextProblem>(&parsed);
    EXPECT_EQ(problem, nullptr) << problem->sentence;
    return problem == nullptr ? std::get<std::vector<TextPiece>>(parsed) : std::vector<TextPiece>{};
}

/// The whole message.
std::string problem_of(const std::string& text) {
    const auto parsed = parse_value_text(text);
    const auto* problem = std::get_if<TextProblem>(&parsed);
    return problem != nullptr ? problem->sentence + problem->advice : "none";
}

constexpr const char* kValues =
    "; the values are frame, scene_time, video_time, playback_speed; of a ball or object, as in "
    "{cue.speed}, speed, spin, direction, distance, x, y, z; of two, as in {angle cue one}, angle, "
    "distance";

TEST(ValueText, Pieces_AreWordsAndValues) {
    const std::vector<TextPiece> pieces =
        pieces_of("v = {cue.speed:.1f} m/s at {scene_time}{angle cue one:3.0f}");
    ASSERT_EQ(pieces.size(), 5U);
    EXPECT_EQ(std::get<std::string>(pieces[0]), "v = ");
    const auto& speed = std::get<TextValue>(pieces[1]);
    EXPECT_EQ(std::get<ObjectValue>(speed.name).object, "cue");
    EXPECT_EQ(std::get<ObjectValue>(speed.name).name, "speed");
    EXPECT_EQ(speed.format, ".1f");
    EXPECT_EQ(std::get<std::string>(pieces[2]), " m/s at ");
    EXPECT_EQ(std::get<FrameValue>(std::get<TextValue>(pieces[3]).name).name, "scene_time");
    const auto& angle = std::get<PairValue>(std::get<TextValue>(pieces[4]).name);
    EXPECT_EQ(angle.name + angle.first + angle.second, "anglecueone");
    EXPECT_THAT(objects_of(pieces), ElementsAre("cue", "cue", "one"));
}

TEST(ValueText, DoubledBraces_AreBraces) {
    const std::vector<TextPiece> pieces = pieces_of("{{a}} {{");
    ASSERT_EQ(pieces.size(), 1U);
    EXPECT_EQ(std::get<std::string>(pieces[0]), "{a} {");
    EXPECT_TRUE(pieces_of("").empty());
}

TEST(ValueText, UnknownNames_AreListedWithTheKnownOnes) {
    EXPECT_EQ(problem_of("{speed}"), std::string("there is no value 'speed'") + kValues);
    EXPECT_EQ(problem_of("{cue.sped}"), std::string("there is no value 'cue.sped'") + kValues);
    EXPECT_EQ(problem_of("{between a b}"),
              std::string("there is no value 'between a b'") + kValues);
    EXPECT_EQ(problem_of("{}"), std::string("there is no name between the braces") + kValues);
    EXPECT_EQ(problem_of("{angle cue}"),
              "'angle cue' needs the names of two balls or objects, as in {angle cue one}");
}

TEST(ValueText, Formats_AreThoseOfNumbers) {
    for (const char* format : {".1f", "8.2f", "+.3g", "05.1f", ".0e", "6", ""}) {
        EXPECT_EQ(problem_of(std::string("{frame:") + format + "}"), "none") << format;
    }
    for (const char* format : {"d", "x", ".f", ".", "<5", "999", "{}", ".1f ", "s"}) {
        EXPECT_NE(problem_of(std::string("{frame:") + format + "}"), "none") << format;
    }
    EXPECT_EQ(problem_of("{frame:d}"),
              "'d' does not say how to write a number; write .1f for one decimal place, or 6.2f "
              "for a width of 6 and two decimal places");
}

TEST(ValueText, UnpairedBraces_AreProblems) {
    EXPECT_EQ(problem_of("a } b"), "a '}' has no '{' before it; write '}}' for the brace itself");
    EXPECT_EQ(problem_of("a { b"), "a '{' has no '}' after it; write '{{' for the brace itself");
}

}  // namespace
}  // namespace carom::pipeline
