#include "render/image_files/exr_colours.h"

#include <fstream>
#include <iterator>

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>

#include "core/error.h"
#include "render/image_files/read_picture.h"
#include "tests/render/image_files/by_openimageio.h"

namespace carom::render {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

class ExrColours : public PictureFolder {
  protected:
    /// Writes a picture with these channels; returns its path.
    std::string write(const std::vector<std::string>& channels, OIIO::TypeDesc type, int tile = 0,
                      int x = 0, int y = 0) {
        OIIO::ImageSpec spec(33, 21, static_cast<int>(channels.size()), type);
        spec.channelnames = channels;
        spec.alpha_channel = -1;
        spec.tile_width = spec.tile_height = tile;
        spec.x = spec.full_x = x;
        spec.y = spec.full_y = y;
        std::vector<float> values;
        for (std::size_t i = 0; i < spec.image_pixels() * channels.size(); ++i) {
            values.push_back(static_cast<float>(i % 301) * 0.25f);
        }
        const std::string file = path("a.exr");
        const auto output = OIIO::ImageOutput::create(file);
        EXPECT_TRUE(output->open(file, spec));
        EXPECT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, values.data()));
        EXPECT_TRUE(output->close());
        OIIO::ImageCache::create(true)->invalidate_all(true);
        return file;
    }
};

TEST_F(ExrColours, UsualFiles_HaveTheColoursThatOpenImageIOReads) {
    const std::vector<std::vector<std::string>> lists{
        {"R", "G", "B"}, {"R", "G", "B", "A"}, {"Y"}, {"Y", "A"}};
    for (const auto& channels : lists) {
        for (const OIIO::TypeDesc type : {OIIO::TypeDesc::HALF, OIIO::TypeDesc::FLOAT}) {
            for (const int tile : {0, 16}) {
                const std::string file = write(channels, type, tile, 5, -7);
                const auto ours = read_exr_colours(file);
                ASSERT_TRUE(ours) << channels.size();
                const RawPicture theirs = by_openimageio(file);
                EXPECT_EQ(ours->width, theirs.width);
                EXPECT_EQ(ours->height, theirs.height);
                EXPECT_EQ(ours->channels, theirs.channels);
                EXPECT_EQ(values_of(*ours), values_of(theirs)) << channels.size() << " " << tile;
                EXPECT_TRUE(ours->is_associated);
                EXPECT_TRUE(ours->is_floating_point);
            }
        }
    }
}

// The module for other formats reads them.
TEST_F(ExrColours, UnusualFiles_AreLeftToOpenImageIO) {
    for (const auto& channels : std::vector<std::vector<std::string>>{
             {"Z"}, {"R", "G", "B", "depth.Z"}, {"diffuse.R", "diffuse.G", "diffuse.B"}}) {
        const std::string file = write(channels, OIIO::TypeDesc::HALF);
        EXPECT_FALSE(read_exr_colours(file)) << channels.front();
        std::vector<float> colours = values_of(by_openimageio(file));
        if (channels.size() == 4) {
            std::size_t index = 0;
            std::erase_if(colours, [&index](float) { return index++ % 4 == 3; });
        }
        EXPECT_EQ(values_of(read_picture(file)), colours) << channels.front();
    }
    EXPECT_FALSE(read_exr_colours(write({"R", "G", "B"}, OIIO::TypeDesc::UINT32)));
}

TEST_F(ExrColours, DamagedFile_IsNamedWithTheReason) {
    const std::string file = write({"R", "G", "B"}, OIIO::TypeDesc::FLOAT);
    std::ifstream in(file, std::ios::binary);
    const std::string whole{std::istreambuf_iterator<char>(in), {}};
    std::ofstream(path("b.exr"), std::ios::binary) << whole.substr(0, whole.size() / 2);
    EXPECT_THAT([&] { static_cast<void>(read_picture(path("b.exr"))); },
                ThrowsMessage<Error>(HasSubstr("image '" + path("b.exr") + "' cannot be read: ")));
    std::ofstream(path("c.exr"), std::ios::binary) << whole.substr(0, 20);
    EXPECT_THAT([&] { static_cast<void>(read_picture(path("c.exr"))); },
                ThrowsMessage<Error>(HasSubstr("image '" + path("c.exr") + "' cannot be read: ")));
}

}  // namespace
}  // namespace carom::render
