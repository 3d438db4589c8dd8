// A piece of plain weave under fuzz, made once and laid out in all directions.
#pragma once

#include <memory>

#include "render/texture/image.h"

namespace carom::render {

/// Threads along a side of the tile, which repeats without a seam.
inline constexpr int kTileThreads = 64;

/// Per texel (height, slope in x, slope in y): heights in [-1, 1] or so around a mean of 0, slopes
/// in heights per thread. All levels average to 0: from far away the weave is gone.
[[nodiscard]] std::shared_ptr<const ImagePyramid> make_weave_tile();

}  // namespace carom::render
