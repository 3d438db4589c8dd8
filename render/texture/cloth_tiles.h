// The tiles of cloth: seamless pictures of noise, made once.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>

#include "render/texture/image.h"
#include "render/texture/mip_pyramid.h"

namespace carom::render {

/// Values in [-1, 1], stored in 16 bits per texel.
struct SignedCodec {
    using Texel = std::int16_t;
    using Value = float;
    static Value decode(Texel texel) {
        return scalar::signed_value<scalar::One>(static_cast<std::uint16_t>(texel));
    }
    static Texel encode(float value) {
        return static_cast<Texel>(std::lrint(std::clamp(value, -1.0f, 1.0f) * 32767.0f));
    }
};
using SignedPyramid = MipPyramid<SignedCodec>;

/// Their sizes are in ClothCells.
struct ClothTiles {
    /// A plain weave with fuzz. Per texel (height, slope in x, slope in y): heights roughly in [-1,
    /// 1] with a mean of 0, slopes in heights per thread. From far away the weave fades.
    ColourPyramid weave;
    /// Gradient noise, and a sum of three octaves of it.
    SignedPyramid nap;
    SignedPyramid wear;
};

[[nodiscard]] std::shared_ptr<const ClothTiles> make_cloth_tiles();

}  // namespace carom::render
