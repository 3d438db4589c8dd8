#include "render/texture/image.h"

#include <algorithm>

#include <Imath/half.h>
#include <fmt/core.h>

#include "core/error.h"
#include "render/image_files/picture_light.h"
#include "render/image_files/read_picture.h"

namespace carom::render {
LinearImage read_linear_image(const std::string& path, bool is_linear, const V3f& background) {
    const RawPicture picture = read_picture(path);
    const std::size_t count =
        static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    LinearImage image{picture.width, picture.height, {}};
    if (count > ImagePyramid::kMostTexels) {
        throw Error(fmt::format("image '{}' is {} x {} pixels; at most {} are read", path,
                                picture.width, picture.height, ImagePyramid::kMostTexels));
    }
    image.pixels.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const PixelLight light = pixel_light(picture, i, is_linear);
        const bool is_transparent = light.alpha < 1;
        image.clamped += light.is_clamped ? 1 : 0;
        image.transparent += is_transparent ? 1 : 0;
        image.pixels.push_back(is_transparent ? light.colour + (1 - light.alpha) * background
                                              : light.colour);
    }
    return image;
}

V3f HalfColourCodec::decode(const Texel& texel) {
    const auto both = std::uint32_t{texel.r} | std::uint32_t{texel.g} << 16;
    return scalar::vector_of(scalar::half_colour<scalar::One>(both, texel.b));
}

HalfColourCodec::Texel HalfColourCodec::encode(const V3f& value) {
    const auto narrow = [](float x) { return imath_float_to_half(std::min(x, 65504.0f)); };
    return {narrow(value.x), narrow(value.y), narrow(value.z), 0};
}

std::shared_ptr<const ImagePyramid> load_image_pyramid(const std::string& path, bool is_linear,
                                                       const V3f& background) {
    const LinearImage image = read_linear_image(path, is_linear, background);
    std::vector<HalfColourCodec::Texel> texels;
    texels.reserve(image.pixels.size());
    for (const V3f& colour : image.pixels) {
        texels.push_back(HalfColourCodec::encode(colour));
    }
    return std::make_shared<const ImagePyramid>(image.width, image.height, texels, Wrap::repeat);
}

}  // namespace carom::render
