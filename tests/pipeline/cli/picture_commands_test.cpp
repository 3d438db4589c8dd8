// End-to-end tests of the files of `carom frame`, read by OpenImageIO like a compositor does.
#include <Imath/ImathMatrix.h>
#include <OpenImageIO/imageio.h>

#include "tests/pipeline/cli/end_to_end.h"

namespace carom::cli {
namespace {

using carom::testing::EndToEnd;
using carom::testing::run_carom;
using carom::testing::RunOptions;
using carom::testing::RunResult;
using ::testing::HasSubstr;
using ::testing::Not;

struct Picture {
    OIIO::ImageSpec spec;
    std::vector<float> values;

    [[nodiscard]] float at(int pixel, const std::string& channel) const {
        const int c = spec.channelindex(channel);
        EXPECT_GE(c, 0) << channel;
        return values[static_cast<std::size_t>(pixel * spec.nchannels + c)];
    }
};

Picture picture(const std::string& path) {
    Picture result;
    const auto input = OIIO::ImageInput::open(path);
    EXPECT_TRUE(input) << path;
    if (input) {
        result.spec = input->spec();
        result.values.resize(static_cast<std::size_t>(result.spec.image_pixels()) *
                             static_cast<std::size_t>(result.spec.nchannels));
        EXPECT_TRUE(input->read_image(0, 0, 0, result.spec.nchannels, OIIO::TypeFloat,
                                      result.values.data()));
    }
    return result;
}

class PictureCommands : public EndToEnd {
  protected:
    [[nodiscard]] Picture frame(const std::string& name,
                                std::vector<std::string> settings = {}) const {
        std::vector<std::string> command{"frame", "tiny.yaml", "--frame", "2", "-o", name};
        for (const std::string& setting : settings) {
            command.insert(command.end(), {"--set", setting});
        }
        const RunResult result = run(command);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return picture(path(name));
    }
};

TEST_F(PictureCommands, DisplayFormats_HaveTheSamePixels) {
    const Picture png = frame("a.png");
    ASSERT_EQ(png.spec.width, 64);
    ASSERT_EQ(png.spec.height, 36);
    EXPECT_EQ(frame("a.bmp").values, png.values);
    EXPECT_EQ(frame("a.tga").values, png.values);
    const Picture jpeg = frame("a.jpg");
    ASSERT_EQ(jpeg.values.size(), png.values.size());
    double error = 0;
    for (std::size_t i = 0; i < png.values.size(); ++i) {
        error += std::pow(static_cast<double>(jpeg.values[i] - png.values[i]), 2);
    }
    EXPECT_LT(std::sqrt(error / static_cast<double>(png.values.size())), 0.03);
    for (const char* name : {"a.png", "a.jpg", "a.tga"}) {
        EXPECT_THAT(picture(path(name)).spec.get_string_attribute("ImageDescription").c_str(),
                    HasSubstr("tiny, camera seat, frame 2, scene time 0.2 s, 4 samples"))
            << name;
    }
    EXPECT_EQ(png.spec.get_string_attribute("scene_time"), "0.2");
}

/// What the dynamic loader reports about the files that a process opens (ld.so(8), LD_DEBUG).
std::string files_loaded_by(const std::vector<std::string>& command, RunOptions options) {
    const std::filesystem::path folder = std::filesystem::path(options.folder) / "loader";
    std::filesystem::create_directory(folder);
    options.environment["LD_DEBUG"] = "files";
    options.environment["LD_DEBUG_OUTPUT"] = folder / "log";
    const RunResult result = run_carom(command, options);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    std::string text;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        text += carom::testing::read_text(entry.path().string());
    }
    std::filesystem::remove_all(folder);
    return text;
}

TEST_F(PictureCommands, ExrAndPng_DoNotLoadOpenImageIO) {
    const auto loaded_for = [this](const std::string& name) {
        return files_loaded_by({"frame", "tiny.yaml", "--frame", "2", "-o", name, "--set",
                                "output.overlay=[scene_time]"},
                               options());
    };
    for (const char* name : {"a.png", "a.exr"}) {
        const std::string files = loaded_for(name);
        EXPECT_THAT(files, HasSubstr("libpng")) << name;
        EXPECT_THAT(files, Not(HasSubstr("OpenImageIO"))) << name;
        EXPECT_THAT(files, Not(HasSubstr("carom-formats"))) << name;
    }
    const std::string files = loaded_for("a.jpg");
    EXPECT_THAT(files, HasSubstr("carom-formats.so"));
    EXPECT_THAT(files, HasSubstr("libOpenImageIO.so"));
}

TEST_F(PictureCommands, Exr_HasChannelsMattesAndMetadata) {
    const Picture exr =
        frame("a.exr", {"render.aovs=[depth, normal, albedo, motion, object_id, material_id, "
                        "cryptomatte_object, cryptomatte_material, variance]"});
    const std::vector<std::string> expected{"R",
                                            "G",
                                            "B",
                                            "A",
                                            "Z",
                                            "N.X",
                                            "N.Y",
                                            "N.Z",
                                            "albedo.R",
                                            "albedo.G",
                                            "albedo.B",
                                            "motion.X",
                                            "motion.Y",
                                            "object_id.X",
                                            "material_id.X",
                                            "variance.X",
                                            "CryptoObject00.R",
                                            "CryptoObject02.A",
                                            "CryptoMaterial00.R"};
    for (const std::string& channel : expected) {
        const int c = exr.spec.channelindex(channel);
        ASSERT_GE(c, 0) << channel;
        EXPECT_EQ(exr.spec.channelformat(c), c < 4 ? OIIO::TypeHalf : OIIO::TypeFloat) << channel;
    }
    EXPECT_EQ(exr.spec.nchannels, 4 + 12 + 2 * 12);
    EXPECT_EQ(exr.spec.get_string_attribute("shot"), "tiny");
    EXPECT_EQ(exr.spec.get_string_attribute("camera"), "seat");
    EXPECT_EQ(exr.spec.get_string_attribute("frame"), "2");
    EXPECT_EQ(exr.spec.get_string_attribute("scene_time"), "0.2");
    EXPECT_EQ(exr.spec.get_string_attribute("samples"), "4");
    EXPECT_NE(exr.spec.get_string_attribute("carom_version"), "");
    Imath::M44f world_to_ndc;
    ASSERT_TRUE(exr.spec.getattribute("worldToNDC", OIIO::TypeMatrix, &world_to_ndc));
    // The depth of a pixel of the cloth and the matrix give the height of the cloth.
    const int low_right = 64 * 30 + 60;
    const float depth = exr.at(low_right, "Z");
    const Imath::V3f ndc(60.5f / 64, 30.5f / 36, 1 - 0.001f / depth);
    EXPECT_NEAR((ndc * world_to_ndc.inverse()).z, 0, 2e-3);
    EXPECT_THAT(exr.spec.get_string_attribute("cryptomatte/3ae39a5/manifest").c_str(),
                HasSubstr("\"cue\":\""));
    for (int i = 0; i < 64 * 36; ++i) {
        float sum = 0;
        for (const char* channel : {"00.G", "00.A", "01.G", "01.A", "02.G", "02.A"}) {
            sum += exr.at(i, std::string("CryptoObject") + channel);
        }
        ASSERT_NEAR(sum, exr.at(i, "A"), 1e-6F);
    }
}

TEST_F(PictureCommands, StoredFrame_HasTheMattes) {
    const std::vector<std::string> settings{"render.aovs=[cryptomatte_object]"};
    const Picture fresh = frame("a.exr", settings);
    const Picture stored = frame("b.exr", settings);
    EXPECT_EQ(stored_frames(), 1);
    EXPECT_EQ(fresh.values, stored.values);
    const std::string manifest = "cryptomatte/3ae39a5/manifest";
    EXPECT_NE(fresh.spec.get_string_attribute(manifest), "");
    EXPECT_EQ(fresh.spec.get_string_attribute(manifest),
              stored.spec.get_string_attribute(manifest));
}

TEST_F(PictureCommands, GlowAndView_RenderNothingAgain) {
    const Picture plain = frame("a.png");
    const Picture glowing = frame("b.png", {"output.glow.strength=0.5", "output.view=agx"});
    EXPECT_EQ(stored_frames(), 1);
    EXPECT_NE(plain.values, glowing.values);
}

TEST_F(PictureCommands, OcioWithoutAConfiguration_IsAnErrorBeforeTheWork) {
    RunOptions without = options();
    without.environment["OCIO"] = "/no/such/config.ocio";
    for (const std::string command : {"frame", "render"}) {
        const RunResult result =
            run_carom({command, "tiny.yaml", "--set", "output.view=ocio"}, without);
        EXPECT_EQ(result.exit_code, 2) << command;
        EXPECT_THAT(result.err, HasSubstr("there is no OpenColorIO configuration "
                                          "'/no/such/config.ocio'"));
    }
    EXPECT_EQ(stored_frames(), 0);
}

}  // namespace
}  // namespace carom::cli
