// Colour pictures from files, in linear light.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "render/geometry/ray.h"
#include "render/texture/mip_pyramid.h"

namespace carom::render {

/// width * height linear Rec.709 colours, row by row from the top left.
struct LinearImage {
    int width = 0;
    int height = 0;
    std::vector<V3f> pixels;
    std::size_t clamped = 0;      // pixels with a negative, infinite or undefined value in the file
    std::size_t transparent = 0;  // pixels through which the background is seen
};

/// Reads any format of render/image_files/read_picture.h. Grey pictures become colours, which are
/// pixel_light (render/image_files/picture_light.h) over the background. Throws Error with the
/// file's name if it is unreadable or too large.
[[nodiscard]] LinearImage read_linear_image(const std::string& path, bool is_linear,
                                            const V3f& background = V3f(0));

/// Half-float storage: 8 bytes per texel.
struct HalfColourCodec {
    struct Texel {
        std::uint16_t r, g, b, unused;
    };
    using Value = V3f;
    static Value decode(const Texel& texel);
    static Texel encode(const Value& value);
    static Value look_up(const PyramidTables& pyramid, const scalar::Two<float>& uv,
                         float footprint) {
        return scalar::vector_of(scalar::look_up_half_colour<scalar::One>(pyramid, uv, footprint));
    }
};

using ImagePyramid = MipPyramid<HalfColourCodec>;

/// Of a picture that repeats.
[[nodiscard]] std::shared_ptr<const ImagePyramid> load_image_pyramid(
    const std::string& path, bool is_linear, const V3f& background = V3f(0));

}  // namespace carom::render
