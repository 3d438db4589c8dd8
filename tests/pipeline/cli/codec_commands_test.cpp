// End-to-end tests of films in other codecs and as image sequences.
#include "tests/pipeline/cli/end_to_end.h"
#include "tests/pipeline/video/decoded_video.h"

namespace carom::cli {
namespace {

using carom::testing::decode_video;
using carom::testing::EndToEnd;
using carom::testing::RunResult;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class CodecCommands : public EndToEnd {};

TEST_F(CodecCommands, OtherCodecs_RenderNothingAgain) {
    ASSERT_EQ(run({"render", "tiny.yaml", "-o", "a.mp4"}).exit_code, 0);
    const RunResult hdr = run({"render", "tiny.yaml", "-o", "hdr.mp4", "--set", "output.hdr10={}"});
    EXPECT_EQ(hdr.exit_code, 0) << hdr.err;
    EXPECT_THAT(hdr.err, HasSubstr("6 frames, 0 of them rendered now"));
    EXPECT_EQ(decode_video(path("hdr.mp4")).transfer, "smpte2084");
    const RunResult web = run({"render", "tiny.yaml", "-o", "a.webm"});
    EXPECT_EQ(web.exit_code, 0) << web.err;
    EXPECT_EQ(decode_video(path("a.webm")).codec, "vp9");
    EXPECT_EQ(web.err.find("libvpx"), std::string::npos) << "encoders print no messages";
    const RunResult pro =
        run({"render", "tiny.yaml", "-o", "a.mov", "--set", "output.codec=prores"});
    EXPECT_EQ(pro.exit_code, 0) << pro.err;
    const auto video = decode_video(path("a.mov"));
    EXPECT_EQ(video.codec, "prores");
    EXPECT_EQ(video.frames.size(), 6U);
}

TEST_F(CodecCommands, Avi_HoldsJpegsOrPlainPicturesAndSound) {
    const RunResult jpegs = run({"render", "tiny.yaml", "-o", "a.avi"});
    EXPECT_EQ(jpegs.exit_code, 0) << jpegs.err;
    EXPECT_EQ(decode_video(path("a.avi")).codec, "mjpeg");
    EXPECT_EQ(decode_video(path("a.avi")).frames.size(), 6U);
    const RunResult plain =
        run({"mux", "tiny.yaml", "-o", "b.avi", "--set", "output.codec=uncompressed"});
    EXPECT_EQ(plain.exit_code, 0) << plain.err;
    EXPECT_EQ(decode_video(path("b.avi")).codec, "rawvideo");
    const RunResult wrong =
        run({"render", "tiny.yaml", "-o", "c.avi", "--set", "output.codec=h264"});
    EXPECT_EQ(wrong.exit_code, 2);
    EXPECT_THAT(wrong.err, HasSubstr(".avi files cannot hold h264"));
}

TEST_F(CodecCommands, Title_IsInTheMetadataWithShotAndVersions) {
    ASSERT_EQ(
        run({"render", "tiny.yaml", "-o", "a.mp4", "--set", "output.title=A break"}).exit_code, 0);
    const auto video = decode_video(path("a.mp4"));
    EXPECT_EQ(video.metadata.at("title"), "A break");
    EXPECT_THAT(video.metadata.at("comment"), HasSubstr("shot=tiny"));
    EXPECT_THAT(video.metadata.at("comment"), HasSubstr("carom_version="));
}

TEST_F(CodecCommands, Sequence_IsOnePicturePerFrame) {
    const RunResult result = run({"render", "tiny.yaml", "-o", "f.####.exr", "--frames", "1-5x2"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, "f.####.exr\n");
    EXPECT_THAT(results(), ElementsAre("f.0001.exr", "f.0003.exr", "f.0005.exr", "f.wav"));
}

TEST_F(CodecCommands, SequenceInAVideoFormat_IsRejectedBeforeTheWork) {
    const RunResult result = run({"render", "tiny.yaml", "-o", "f.####.mp4"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr("the known types are .exr, .png, .jpg, .bmp and .tga"));
    EXPECT_THAT(results(), IsEmpty());
    EXPECT_EQ(stored_frames(), 0);
}

/// x265 3.5 would write beyond the end of its rows of blocks (encoder_options.cpp).
TEST_F(CodecCommands, HevcOfANarrowPicture_IsWritten) {
    for (const char* size : {"16,16", "48,36", "48,64", "50,36"}) {
        const RunResult result =
            run({"render", "tiny.yaml", "-o", "a.mp4", "--set", "output.codec=hevc", "--set",
                 std::string("render.size=[") + size + "]"});
        EXPECT_EQ(result.exit_code, 0) << size << ": " << result.err;
        EXPECT_EQ(decode_video(path("a.mp4")).frames.size(), 6U) << size;
    }
}

}  // namespace
}  // namespace carom::cli
