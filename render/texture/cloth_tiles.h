// What cloth is laid out with: pictures of noise that repeat without a seam, made once.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>

#include "render/texture/image.h"
#include "render/texture/mip_pyramid.h"

namespace carom::render {

/// Values in [-1, 1], 16 bits a texel.
struct SignedCodec {
    using Texel = std::int16_t;
    using Value = float;
    static float decode(Texel texel) { return static_cast<float>(texel) * (1.0f / 32767.0f); }
    static Texel encode(float value) {
        return static_cast<Texel>(std::lrint(std::clamp(value, -1.0f, 1.0f) * 32767.0f));
    }
};
using SignedPyramid = MipPyramid<SignedCodec>;

struct ClothTiles {
    /// Threads along a side of `weave`; cells of noise along a side of `nap`, coarsest ones of
    /// `wear`.
    static constexpr int kThreads = 64;
    static constexpr int kNapCells = 64;
    static constexpr int kWearCells = 16;

    /// A plain weave under fuzz. Per texel (height, slope in x, slope in y): heights in [-1, 1] or
    /// so around a mean of 0, slopes in heights per thread. From far away the weave is gone.
    ImagePyramid weave;
    /// Gradient noise, and three octaves of it.
    SignedPyramid nap;
    SignedPyramid wear;
};

[[nodiscard]] std::shared_ptr<const ClothTiles> make_cloth_tiles();

}  // namespace carom::render
