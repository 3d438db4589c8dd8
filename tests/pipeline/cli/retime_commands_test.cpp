// End-to-end tests of retime, and of films with another camera.
#include "tests/pipeline/cli/end_to_end.h"
#include "tests/pipeline/video/decoded_video.h"

namespace carom::cli {
namespace {

using carom::testing::decode_video;
using carom::testing::EndToEnd;
using carom::testing::RunResult;
using carom::testing::write_text;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class RetimeCommands : public EndToEnd {
  protected:
    [[nodiscard]] std::size_t frames_of(const std::string& film) const {
        return decode_video(path(film)).frames.size();
    }
};

TEST_F(RetimeCommands, SlowMotion_LengthensTheSelectedInterval) {
    ASSERT_EQ(run({"bake", "tiny.yaml"}).exit_code, 0);
    const RunResult result =
        run({"retime", "tiny.bake", "--speed", "0.125", "--from", "100ms", "--to", "0.2 s"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, "tiny_retimed.mp4\n");
    EXPECT_EQ(frames_of("tiny_retimed.mp4"), 8U);
    EXPECT_EQ(run({"retime", "tiny.bake", "--ramp", "0s:1,1s:1/10", "-o", "r.mp4"}).exit_code, 0);
    EXPECT_EQ(frames_of("r.mp4"), 10U);
}

TEST_F(RetimeCommands, Reverse_RendersOnlyTheLastFrame) {
    ASSERT_EQ(run({"render", "tiny.yaml"}).exit_code, 0);
    const RunResult result = run({"retime", "tiny.yaml", "--reverse", "-o", "back.mp4"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr("using the cached bake"));
    EXPECT_THAT(result.err, HasSubstr("6 frames, 1 of them rendered now"));
}

TEST_F(RetimeCommands, InvalidOptions_AreRejectedBeforeTheWork) {
    const std::vector<std::pair<std::vector<std::string>, std::string>> wrong{
        {{}, "no change is given; use --speed"},
        {{"--speed", "fast"}, "'fast' is not a speed; write 0.125 or 1/8"},
        {{"--speed", "1 s"}, "'1 s' is not a speed"},
        {{"--from", "noon"}, "'noon' is not a time; write 1.25s or 500ms"},
        {{"--ramp", "1s"}, "'1s' in --ramp is not a film time and a speed"},
        {{"--reverse", "--easing", "linear"}, "--easing has no effect without --ramp; give both"},
        {{"--from", "1s", "--to", "2s"}, "no camera shows scene time 1 s ('seat' 0 s to 0.6 s)"},
    };
    for (const auto& [options, text] : wrong) {
        std::vector<std::string> arguments{"retime", "tiny.yaml"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const RunResult result = run(arguments);
        EXPECT_EQ(result.exit_code, 2) << text;
        EXPECT_THAT(result.err, HasSubstr(text));
    }
    EXPECT_THAT(results(), IsEmpty());
}

TEST_F(RetimeCommands, OtherCamera_FilmsTheBakeAndReportsTheErrorOfItsPath) {
    write_text(
        path("other.yaml"),
        "cameras:\n"
        "  - {name: chase, video: [0 s, 0.4 s], scene: [0.1 s, 0.5 s], target: {follow: one},\n"
        "     position: {along: cue, from: 0.1 s, to: 0.5 s, offset: [0, -0.6, 0.4]}}\n"
        "render: {samples: 1}\n");
    ASSERT_EQ(run({"bake", "tiny.yaml"}).exit_code, 0);
    const RunResult result = run({"render", "tiny.bake", "--camera", "other.yaml", "-o", "b.mp4"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr("camera 'chase': the position along 'cue' is a Bezier curve "
                                      "of degree "));
    EXPECT_EQ(frames_of("b.mp4"), 4U);
    EXPECT_EQ(run({"frame", "tiny.bake", "--camera", "other.yaml", "--frame", "4"}).exit_code, 2);
}

TEST_F(RetimeCommands, ErrorsOfACameraFile_AreReportedWithItsName) {
    write_text(path("other.yaml"), "cameras: [{name: chase, video: [0 s, 1 s], scene: 0 s}]\n");
    ASSERT_EQ(run({"bake", "tiny.yaml"}).exit_code, 0);
    const RunResult result = run({"render", "tiny.bake", "--camera", "other.yaml", "-o", "b.mp4"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr("other.yaml:1:11: error: "));
    EXPECT_THAT(result.err, HasSubstr("carom: error: 'other.yaml' has 2 errors\n"));
}

}  // namespace
}  // namespace carom::cli
