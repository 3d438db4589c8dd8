#include "render/image_files/radiance_file.h"

#include <cmath>
#include <fstream>
#include <iterator>

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>

#include "core/error.h"
#include "render/image_files/read_picture.h"
#include "tests/folders.h"
#include "tests/render/image_files/by_openimageio.h"

namespace carom::render {
namespace {

using testing::ThrowsMessage;

class RadianceFile : public PictureFolder {
  protected:
    std::string write(int width, int height) {
        std::vector<float> values;
        for (int i = 0; i < 3 * width * height; ++i) {
            // Exponents from -30 to 30, with runs and single values. Beyond, OpenImageIO's powers
            // of two are rounded to seven decimal digits.
            const int pixel = i / 3;
            values.push_back(i % 11 == 0 ? 0
                                         : std::ldexp(1 + 0.01f * static_cast<float>(i % 83),
                                                      (pixel / 9) % 61 - 30));
        }
        const std::string file = path("a.hdr");
        const auto output = OIIO::ImageOutput::create(file);
        EXPECT_TRUE(output->open(file, OIIO::ImageSpec(width, height, 3, OIIO::TypeDesc::FLOAT)));
        EXPECT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, values.data()));
        EXPECT_TRUE(output->close());
        return file;
    }
};

std::string text_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

RawPicture decode(const std::string& text) {
    return decode_radiance(std::as_bytes(std::span(text)), "sky.hdr");
}

TEST_F(RadianceFile, HasTheValuesThatOpenImageIOReads) {
    const std::string file = write(301, 77);
    const RawPicture theirs = by_openimageio(file);
    const RawPicture ours = decode(text_of(file));
    EXPECT_EQ(ours.width, 301);
    EXPECT_EQ(ours.height, 77);
    EXPECT_EQ(ours.channels, 3);
    EXPECT_TRUE(ours.is_floating_point);
    EXPECT_EQ(values_of(ours), values_of(theirs));
}

TEST_F(RadianceFile, EnvironmentsOfTheLooks_HaveTheValuesThatOpenImageIOReads) {
    for (const std::string name : {"club_room", "daylight_room", "studio_room"}) {
        const std::string file = CAROM_SOURCE_DIR "/configs/looks/" + name + ".hdr";
        const RawPicture ours = decode(text_of(file));
        EXPECT_EQ(values_of(ours), values_of(by_openimageio(file))) << name;
    }
}

// Rows of fewer than 8 pixels are not compressed.
TEST_F(RadianceFile, NarrowPicture_HasTheValuesThatOpenImageIOReads) {
    const std::string narrow = write(5, 4);
    EXPECT_EQ(values_of(decode(text_of(narrow))), values_of(by_openimageio(narrow)));
}

TEST_F(RadianceFile, AnyByteChanged_IsRefusedOrReadWithoutHarm) {
    const std::string whole = text_of(write(64, 9));
    for (std::size_t at = 0; at < whole.size(); ++at) {
        std::string changed = whole;
        changed[at] = static_cast<char>(changed[at] ^ 0x55);
        try {
            const RawPicture picture = decode(changed);
            const int pixels = picture.width * picture.height;
            EXPECT_EQ(values_of(picture).size(), 3 * static_cast<std::size_t>(pixels)) << at;
        } catch (const Error&) {
        }
    }
}

TEST_F(RadianceFile, Damaged_IsRefusedWithTheRow) {
    const std::string whole = text_of(write(64, 9));
    const std::size_t rows = whole.find("+X 64\n") + 6;
    const auto reading = [](std::string text) {
        return [text = std::move(text)] { static_cast<void>(decode(text)); };
    };
    EXPECT_THAT(reading(whole.substr(0, whole.size() - 1)),
                ThrowsMessage<Error>("image 'sky.hdr' cannot be read: row 8 is damaged"));
    std::string long_run = whole;
    long_run[rows + 4] = '\xff';  // 127 pixels of 64
    EXPECT_THAT(reading(long_run),
                ThrowsMessage<Error>("image 'sky.hdr' cannot be read: row 0 is damaged"));
    std::string no_run = whole;
    no_run[rows + 4] = '\0';
    EXPECT_THAT(reading(no_run),
                ThrowsMessage<Error>("image 'sky.hdr' cannot be read: row 0 is damaged"));
    for (std::size_t keep = rows + 4; keep < whole.size(); keep += 13) {
        EXPECT_THROW(reading(whole.substr(0, keep))(), Error) << keep;
    }
    const std::string head("\x02\x02\x02\0", 4);
    EXPECT_THAT(reading("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 50000 +X 512\n" + head),
                ThrowsMessage<Error>(
                    "image 'sky.hdr' cannot be read: the file is too short for its pixels"));
    EXPECT_THAT(reading("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 999999 +X 512\n" + head),
                ThrowsMessage<Error>("image 'sky.hdr' is 512 x 999999 pixels; at most 67108864 are "
                                     "read; CAROM_LIMITS=2 in the environment doubles all such "
                                     "limits"));
}

}  // namespace
}  // namespace carom::render
