// The number on a ball, drawn once from a font's outlines.
#pragma once

#include <cmath>
#include <memory>

#include "render/texture/mip_pyramid.h"

namespace carom::render {

/// Coverage by ink in [0, 1], 8 bits per texel.
struct CoverageCodec {
    using Texel = std::uint8_t;
    using Value = float;
    static Value decode(Texel texel) { return scalar::coverage_value<scalar::One>(texel); }
    static Texel encode(float value) {
        return static_cast<Texel>(std::lrint(std::clamp(value, 0.0f, 1.0f) * 255.0f));
    }
};

using CoverageMask = MipPyramid<CoverageCodec>;

inline constexpr int kNumberMaskSize = 1024;

/// `number` (0 to 999) in DejaVu Sans Bold, centred and fitted into the circle inscribed in a
/// square of kNumberMaskSize texels; numbers such as 6 and 9 or 66 and 99 are underlined to tell
/// them apart. Throws Error if the font is not installed.
[[nodiscard]] std::shared_ptr<const CoverageMask> draw_number(int number);

}  // namespace carom::render
