#include "render/image_files/read_picture.h"

#include <fstream>

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>

#include "core/error.h"
#include "render/image_files/png_file.h"
#include "tests/render/image_files/by_openimageio.h"

namespace carom::render {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

class ReadPicture : public PictureFolder {};

TEST_F(ReadPicture, OtherFormats_AreReadByOpenImageIO) {
    const std::vector<float> values(std::size_t{3} * 32 * 16, 0.5f);
    for (const std::string name : {"a.jpg", "a.tif", "a.hdr", "a.bmp", "a.tga"}) {
        const auto output = OIIO::ImageOutput::create(path(name));
        ASSERT_TRUE(output) << name;
        const bool is_float = name == "a.hdr";
        ASSERT_TRUE(output->open(
            path(name),
            OIIO::ImageSpec(32, 16, 3, is_float ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8)));
        ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, values.data()));
        ASSERT_TRUE(output->close());
        const RawPicture picture = read_picture(path(name));
        EXPECT_EQ(picture.width, 32) << name;
        EXPECT_EQ(picture.height, 16) << name;
        EXPECT_EQ(picture.channels, 3) << name;
        EXPECT_EQ(picture.is_floating_point, is_float) << name;
        EXPECT_NEAR(picture.value(100), 0.5f, 0.01f) << name;
    }
}

TEST_F(ReadPicture, TheContentDecides_NotTheName) {
    const std::vector<std::uint8_t> rgb(std::size_t{3} * 8 * 4, 51);
    const std::vector<std::byte> bytes = encode_png(rgb, 8, 4, {});
    std::ofstream(path("a.jpg"), std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
    EXPECT_EQ(read_picture(path("a.jpg")).width, 8);
}

TEST_F(ReadPicture, Unreadable_IsNamedWithTheReason) {
    const auto read = [this](const std::string& name) {
        return [file = path(name)] { static_cast<void>(read_picture(file)); };
    };
    const auto message = [this](const std::string& name, const std::string& why) {
        return "image '" + path(name) + "' cannot be read: " + why;
    };
    EXPECT_THAT(read("none.png"),
                ThrowsMessage<Error>(message("none.png", "No such file or directory")));
    std::filesystem::create_directory(path("folder.png"));
    EXPECT_THAT(read("folder.png"), ThrowsMessage<Error>(message("folder.png", "Is a directory")));
    std::ofstream(path("text.png")) << "this is no picture";
    EXPECT_THAT(read("text.png"), ThrowsMessage<Error>(HasSubstr(message("text.png", ""))));
    std::ofstream(path("empty.png")).flush();
    EXPECT_THAT(read("empty.png"), ThrowsMessage<Error>(HasSubstr(message("empty.png", ""))));
}

}  // namespace
}  // namespace carom::render
