// The light of a picture's pixels.
#pragma once

#include <cstddef>

#include <Imath/ImathVec.h>

#include "render/image_files/raw_picture.h"

namespace carom::render {

/// What an infinite value becomes: the largest number of a half float.
inline constexpr float kBrightestPixel = 65504;

struct PixelLight {
    Imath::V3f colour{0, 0, 0};  // linear, multiplied by alpha, each channel >= 0 and finite
    float alpha = 1;             // [0, 1]
    bool is_clamped = false;     // a value was negative, infinite or undefined (NaN)
};

/// The pixel at that place in `picture.values`. If `is_linear`, the integers of the file are taken
/// as linear; otherwise they are decoded by its gamma or from sRGB (IEC 61966-2-1). Values in
/// floating point are linear. Negative and undefined values become 0.
[[nodiscard]] PixelLight pixel_light(const RawPicture& picture, std::size_t pixel, bool is_linear);

}  // namespace carom::render
