#include "render/texture/relief_picture.h"

#include <algorithm>
#include <vector>

#include "render/image_files/picture_light.h"
#include "render/texture/scalar_kernels.h"

namespace carom::render {
namespace {

/// Of normals: steeper ones come from pictures that are not of normals.
constexpr float kLeastOutwards = 0.1f;

ColourWithAlpha slopes(float right, float up) {
    return {right, up, right * right + up * up, 1};
}

float height_of(const RawPicture& picture, std::size_t pixel, PictureChannel channel) {
    const PixelLight light = pixel_light(picture, pixel, true);
    const V3f colour = light.alpha > 0 ? light.colour / light.alpha : light.colour;
    return scalar::part_of<scalar::One>({colour, light.alpha}, channel);
}

RawPicture read_colours(const std::string& path, const ReadPicture& read) {
    RawPicture picture = read(path);
    check_fits(path, picture, ColourPyramid::fits(picture.width, picture.height));
    return picture;
}

}  // namespace

std::shared_ptr<const SlopePicture> SlopePicture::of_normals(const std::string& path,
                                                             const ReadPicture& read) {
    const RawPicture picture = read_colours(path, read);
    const auto width = static_cast<std::size_t>(picture.width);
    const auto slope_at = [&](int x, int y) {
        const std::size_t pixel = static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
        const V3f normal = pixel_light(picture, pixel, true).colour * 2.0f - V3f(1);
        const float outwards = std::max(normal.z, kLeastOutwards);
        return HalfColourCodec::encode(slopes(normal.x / outwards, normal.y / outwards));
    };
    return std::shared_ptr<const SlopePicture>(
        new SlopePicture(ColourPyramid(picture.width, picture.height, Wrap::repeat, slope_at)));
}

std::shared_ptr<const SlopePicture> SlopePicture::of_heights(const std::string& path,
                                                             PictureChannel channel,
                                                             const ReadPicture& read) {
    const RawPicture picture = read_colours(path, read);
    std::vector<float> heights;
    heights.reserve(picture.pixel_count());
    for (std::size_t pixel = 0; pixel < picture.pixel_count(); ++pixel) {
        heights.push_back(height_of(picture, pixel, channel));
    }
    const auto height_at = [&](int x, int y) {
        const int column = (x + picture.width) % picture.width;
        const int row = (y + picture.height) % picture.height;
        return heights[static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width) +
                       static_cast<std::size_t>(column)];
    };
    // A normal leans down the slope; rows of the picture run down.
    const auto slope_at = [&](int x, int y) {
        return HalfColourCodec::encode(slopes((height_at(x - 1, y) - height_at(x + 1, y)) / 2,
                                              (height_at(x, y + 1) - height_at(x, y - 1)) / 2));
    };
    return std::shared_ptr<const SlopePicture>(
        new SlopePicture(ColourPyramid(picture.width, picture.height, Wrap::repeat, slope_at)));
}

ImageTables SlopePicture::tables() const {
    ImageTables tables;
    tables.levels = levels_.tables();
    tables.width = levels_.width();
    tables.height = levels_.height();
    return tables;
}

}  // namespace carom::render
