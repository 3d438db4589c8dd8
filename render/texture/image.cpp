#include "render/texture/image.h"

#include <algorithm>
#include <cmath>

#include <Imath/half.h>
#include <fmt/core.h>

#include "core/elementary_float.h"
#include "core/error.h"
#include "render/image_files/read_picture.h"

namespace carom::render {
namespace {

// IEC 61966-2-1:1999, 5.2.
float srgb_to_linear(float v) {
    return v <= 0.04045f ? v / 12.92f : power((v + 0.055f) / 1.055f, 2.4f);
}

bool is_usable(const V3f& c) {
    const auto usable = [](float x) { return std::isfinite(x) && x >= 0; };
    return usable(c.x) && usable(c.y) && usable(c.z);
}

}  // namespace

LinearImage read_linear_image(const std::string& path, bool is_linear) {
    const RawPicture picture = read_picture(path);
    const bool decode = !is_linear && !picture.is_floating_point;
    const std::size_t channels = static_cast<std::size_t>(picture.channels);
    const std::size_t width = static_cast<std::size_t>(picture.width);
    const std::size_t count = width * static_cast<std::size_t>(picture.height);
    LinearImage image{picture.width, picture.height, {}};
    if (count > ImagePyramid::kMostTexels) {
        throw Error(fmt::format("image '{}' is {} x {} pixels; at most {} are read", path,
                                picture.width, picture.height, ImagePyramid::kMostTexels));
    }
    image.pixels.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const float* value = &picture.values[i * channels];
        V3f colour = channels >= 3 ? V3f(value[0], value[1], value[2]) : V3f(value[0]);
        if (!is_usable(colour)) {
            throw Error(fmt::format(
                "image '{}' holds a negative, infinite or undefined value at pixel ({}, {})", path,
                i % width, i / width));
        }
        if (decode) {
            colour = {srgb_to_linear(colour.x), srgb_to_linear(colour.y), srgb_to_linear(colour.z)};
        }
        image.pixels.push_back(colour);
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

std::shared_ptr<const ImagePyramid> load_image_pyramid(const std::string& path, bool is_linear) {
    const LinearImage image = read_linear_image(path, is_linear);
    std::vector<HalfColourCodec::Texel> texels;
    texels.reserve(image.pixels.size());
    for (const V3f& colour : image.pixels) {
        texels.push_back(HalfColourCodec::encode(colour));
    }
    return std::make_shared<const ImagePyramid>(image.width, image.height, texels, Wrap::repeat);
}

}  // namespace carom::render
