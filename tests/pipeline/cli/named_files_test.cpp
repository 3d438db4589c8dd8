// Files that a shot names: what `check` passes can be rendered, and what cannot be read stops every
// command with the same sentence.
#include <filesystem>
#include <fstream>

#include <OpenImageIO/imageio.h>

#include "tests/pipeline/cli/end_to_end.h"

namespace carom::cli {
namespace {

using carom::testing::EndToEnd;
using carom::testing::RunResult;
using carom::testing::write_text;
using ::testing::HasSubstr;
using ::testing::Not;

class NamedFiles : public EndToEnd {
  protected:
    NamedFiles() {
        write_text(path("s.yaml"), R"(carom: 1
simulation: {duration: 0.1 s}
table: {kind: cloth}
materials:
  pic:
    standard:
      base: {image: a.png}
objects:
  m: {mesh: a.obj, at: [0, 0, 0.5], material: pic}
cameras:
  - {video: [0 s, 0.1 s], scene: 0 s, position: [0, -1, 0.8], target: [0, 0, 0]}
render: {size: [64, 36], fps: 10, samples: 1, max_bounces: 1}
)");
        write_text(path("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        write_picture("a.png", 3, {1, 0, 0});
    }

    /// The path of a file as messages have it.
    [[nodiscard]] std::string whole_path(const std::string& name) const {
        return std::filesystem::canonical(path(name)).string();
    }
    void write_picture(const std::string& name, int channels,
                       const std::vector<float>& pixel) const {
        std::vector<float> values;
        for (int i = 0; i < 64; ++i) {
            values.insert(values.end(), pixel.begin(), pixel.end());
        }
        const auto output = OIIO::ImageOutput::create(path(name));
        ASSERT_TRUE(output);
        ASSERT_TRUE(output->open(path(name),
                                 OIIO::ImageSpec(8, 8, channels,
                                                 name.ends_with(".exr") ? OIIO::TypeDesc::FLOAT
                                                                        : OIIO::TypeDesc::UINT8)));
        ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, values.data()));
        ASSERT_TRUE(output->close());
    }
};

TEST_F(NamedFiles, WrongOnes_StopEveryCommandWithTheSameSentences) {
    EXPECT_EQ(run({"check", "s.yaml"}).exit_code, 0);
    write_text(path("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
    std::filesystem::resize_file(path("a.png"), 50);
    write_text(path("film.yaml"), "carom: 1\nfilm: {shots: [s.yaml]}\n");
    const std::string of_mesh = "s.yaml:9:13: error: '";
    const std::string of_picture = "s.yaml:7:21: error: image '" + whole_path("a.png") +
                                   "' cannot be read: the file ends too early\n";
    const std::vector<std::vector<std::string>> commands{
        {"check", "s.yaml"},
        {"check", "film.yaml"},
        {"render", "s.yaml", "-o", "a.mkv"},
        {"render", "film.yaml", "-o", "a.mkv"},
        {"frame", "s.yaml", "-o", "a.png"},
        {"contact-sheet", "s.yaml"},
        {"export", "s.yaml", "-o", "a.glb"},
        {"farm", "submit", "s.yaml", "--dry-run", "--store", "cache"}};
    for (const std::vector<std::string>& command : commands) {
        const RunResult result = run(command);
        EXPECT_EQ(result.exit_code, 2) << command[0] << result.err;
        EXPECT_THAT(result.err, HasSubstr(of_mesh)) << command[0];
        EXPECT_THAT(result.err, HasSubstr(of_picture)) << command[0];
        EXPECT_THAT(result.err, HasSubstr("' has 2 errors\n")) << command[0];
    }
    EXPECT_FALSE(exists("a.mkv"));
    EXPECT_FALSE(exists("a.glb"));
}

TEST_F(NamedFiles, MusicAndViewsThatDoNotWork_AreFoundByCheck) {
    write_text(path("music.mp3"), "this is no music");
    const RunResult result = run({"check", "s.yaml", "--set", "output.music=music.mp3"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr("    1 | output.music=music.mp3\n"));
    EXPECT_THAT(result.err, HasSubstr("music.mp3'"));
    write_text(path("config.ocio"), "ocio_profile_version: 2\nroles: {unknown: x}\n");
    carom::testing::RunOptions with_ocio = options();
    with_ocio.environment["OCIO"] = path("config.ocio");
    for (const std::string command : {"check", "frame"}) {
        const RunResult view =
            carom::testing::run_carom({command, "s.yaml", "--set", "output.view=ocio"}, with_ocio);
        EXPECT_EQ(view.exit_code, 2) << view.err;
        EXPECT_THAT(view.err, HasSubstr("    1 | output.view=ocio\n")) << command;
        EXPECT_THAT(view.err, HasSubstr("config.ocio")) << command;
    }
}

TEST_F(NamedFiles, BlemishesAndTransparency_AreWarningsOfCheckAndOfFilms) {
    write_picture("a.png", 4, {1, 0, 0, 0.5f});
    write_picture("room.exr", 3, {1, -1, 1});
    const std::string lights = "lights={room: {environment: room.exr}}";
    for (const std::string command : {"check", "frame"}) {
        const RunResult result = run({command, "s.yaml", "--set", lights});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_THAT(result.err, HasSubstr("s.yaml:7:21: warning: image '" + whole_path("a.png") +
                                          "' is transparent in 64 of 64 pixels"));
        EXPECT_THAT(result.err, HasSubstr("warning: image '" + whole_path("room.exr") +
                                          "' has a negative, infinite or undefined value in 64 of "
                                          "64 pixels"));
    }
    const RunResult chosen =
        run({"check", "s.yaml", "--set",
             "materials.pic.standard.base.image={file: a.png, background: [0, 0, 1]}"});
    EXPECT_THAT(chosen.err, Not(HasSubstr("transparent")));
}

}  // namespace
}  // namespace carom::cli
