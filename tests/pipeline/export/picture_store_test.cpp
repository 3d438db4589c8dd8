#include "pipeline/export/textures/picture_store.h"

#include <filesystem>

#include "core/error.h"
#include "pipeline/export/textures/baked_picture.h"
#include "render/image_files/format_module.h"
#include "tests/pipeline/export/picture_files.h"

namespace carom::pipeline {
namespace {

using carom::testing::PictureFiles;

class PictureStoreTest : public PictureFiles {
  protected:
    /// `exif`: bytes of a segment APP1 that is put into the file.
    std::string jpeg(const std::string& name, const std::string& exif = {}) const {
        const std::vector<std::uint8_t> grey(std::size_t{8} * 4 * 3, 128);
        const std::vector<std::byte> bytes =
            render::format_module().encode(grey, 8, 4, "picture.jpg", {});
        std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        carom::testing::write_text(folder_.path(name), text.insert(2, exif));
        return folder_.path(name);
    }

    PictureStore pictures_;
};

TEST_F(PictureStoreTest, Facts_SayWhatOthersCanUse) {
    const PictureFacts facts = pictures_.facts(png("a.png", 2, {{1, 2, 3}, {4, 5, 6}}));
    EXPECT_EQ(facts.format, PictureFormat::png);
    EXPECT_EQ(facts.width, 2);
    EXPECT_EQ(facts.channels, 3);
    EXPECT_TRUE(facts.is_plain_colour);
    EXPECT_EQ(facts.alpha, AlphaKind::opaque);
    EXPECT_EQ(pictures_.facts(png("b.png", 1, {{0, 0, 0, 255}}, 4)).alpha, AlphaKind::opaque);
    EXPECT_EQ(pictures_.facts(png("c.png", 1, {{0, 0, 0, 0}}, 4)).alpha, AlphaKind::cut_out);
    EXPECT_EQ(pictures_.facts(png("d.png", 1, {{0, 0, 0, 9}}, 4)).alpha, AlphaKind::varied);
}

TEST_F(PictureStoreTest, JpegThatExifTurns_IsNotPlain) {
    EXPECT_TRUE(pictures_.facts(jpeg("upright.jpg")).is_plain);
    // A TIFF header and one entry: Orientation (0x112), a short, 6.
    const std::string entry("\x01\x12\x00\x03\x00\x00\x00\x01\x00\x06\x00\x00", 12);
    const std::string tiff =
        std::string("MM\0\x2a\0\0\0\x08\0\x01", 10) + entry + std::string(4, 0);
    const std::string data = std::string("Exif\0\0", 6) + tiff;
    const std::string segment =
        "\xff\xe1" + std::string(1, '\0') + static_cast<char>(data.size() + 2) + data;
    const PictureFacts turned = pictures_.facts(jpeg("turned.jpg", segment));
    EXPECT_EQ(turned.format, PictureFormat::jpeg);
    EXPECT_FALSE(turned.is_plain);
    EXPECT_EQ(turned.width, 4);  // as it is to be seen
}

TEST_F(PictureStoreTest, LargePicture_BecomesSmaller) {
    PictureStore small({.most_side = 2, .skips_unreadable = false});
    const std::string path = png("wide.png", 4,
                                 {{0, 0, 0},
                                  {100, 0, 0},
                                  {50, 0, 0},
                                  {50, 0, 0},
                                  {0, 0, 0},
                                  {100, 0, 0},
                                  {50, 0, 0},
                                  {51, 0, 0}});
    EXPECT_TRUE(small.is_too_large(small.facts(path)));
    const auto picture = small.picture(path);
    EXPECT_EQ(picture->width, 2);
    EXPECT_EQ(picture->height, 1);
    EXPECT_EQ(std::get<std::vector<std::uint8_t>>(picture->values),
              (std::vector<std::uint8_t>{50, 0, 0, 50, 0, 0}));
}

TEST_F(PictureStoreTest, ChangedFile_IsReadAgain) {
    const std::string path = png("a.png", 1, {{0, 0, 0}});
    EXPECT_EQ(pictures_.facts(path).width, 1);
    png("a.png", 2, {{0, 0, 0}, {1, 1, 1}});
    std::filesystem::last_write_time(
        path, std::filesystem::last_write_time(path) + std::chrono::seconds(5));
    EXPECT_EQ(pictures_.facts(path).width, 2);
}

TEST_F(PictureStoreTest, MissingFile_IsNamed) {
    try {
        static_cast<void>(pictures_.facts("/nowhere/a.png"));
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()),
                  "image '/nowhere/a.png' cannot be read: No such file or directory");
    }
}

}  // namespace
}  // namespace carom::pipeline
