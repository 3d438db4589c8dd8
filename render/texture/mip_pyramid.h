// A mip map: a picture at all halved resolutions, looked up bilinearly at the size that a pixel
// covers.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/assert.h"

namespace carom::render {

enum class Wrap { clamp, repeat };

/// `Codec` names a stored `Texel`, the `Value` that it represents, and the functions decode and
/// encode between them. A look-up reads four texels of one level: 28 ns where OpenImageIO's
/// TextureSystem, which can page pictures larger than the memory, takes 290
/// (bench/frame_bench.cpp).
template <class Codec>
class MipPyramid {
  public:
    using Texel = typename Codec::Texel;
    using Value = typename Codec::Value;

    MipPyramid() = default;

    /// `texels`: width * height, row by row from the top left.
    MipPyramid(int width, int height, std::vector<Texel> texels) {
        CAROM_ASSERT(width > 0 && height > 0);
        CAROM_ASSERT(texels.size() ==
                     static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        levels_.push_back({width, height, std::move(texels)});
        while (levels_.back().width > 1 || levels_.back().height > 1) {
            levels_.push_back(halved(levels_.back()));
        }
    }

    [[nodiscard]] int width() const { return levels_.front().width; }
    [[nodiscard]] int height() const { return levels_.front().height; }
    [[nodiscard]] std::size_t level_count() const { return levels_.size(); }

    /// The value at (u, v), v = 0 at the top, averaged over about `footprint` (in the same unit, of
    /// the larger side), from the finest level whose texels are at least half as large.
    [[nodiscard]] Value lookup(float u, float v, float footprint, Wrap wrap_u, Wrap wrap_v) const {
        const float texels =
            footprint * static_cast<float>(std::max(levels_[0].width, levels_[0].height));
        std::size_t level = 0;
        if (texels > 1.0f) {
            level = std::min(static_cast<std::size_t>(std::ilogb(std::min(texels, 1e9f))),
                             levels_.size() - 1);
        }
        return bilinear(levels_[level], u, v, wrap_u, wrap_v);
    }

  private:
    struct Level {
        int width = 0, height = 0;
        std::vector<Texel> texels;

        [[nodiscard]] Value at(int x, int y) const {
            return Codec::decode(
                texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                       static_cast<std::size_t>(x)]);
        }
    };

    static int wrapped(int i, int size, Wrap wrap) {
        if (wrap == Wrap::clamp) {
            return std::clamp(i, 0, size - 1);
        }
        const int rest = i % size;
        return rest < 0 ? rest + size : rest;
    }

    static Value bilinear(const Level& level, float u, float v, Wrap wrap_u, Wrap wrap_v) {
        // Removes repeats first, so that far coordinates keep their precision.
        const float tile_u = wrap_u == Wrap::repeat ? u - std::floor(u) : std::clamp(u, 0.0f, 1.0f);
        const float tile_v = wrap_v == Wrap::repeat ? v - std::floor(v) : std::clamp(v, 0.0f, 1.0f);
        const float x = tile_u * static_cast<float>(level.width) - 0.5f;
        const float y = tile_v * static_cast<float>(level.height) - 0.5f;
        const float floor_x = std::floor(x);
        const float floor_y = std::floor(y);
        const float fx = x - floor_x;
        const float fy = y - floor_y;
        const int x0 = wrapped(static_cast<int>(floor_x), level.width, wrap_u);
        const int x1 = wrapped(static_cast<int>(floor_x) + 1, level.width, wrap_u);
        const int y0 = wrapped(static_cast<int>(floor_y), level.height, wrap_v);
        const int y1 = wrapped(static_cast<int>(floor_y) + 1, level.height, wrap_v);
        const Value top = level.at(x0, y0) * (1.0f - fx) + level.at(x1, y0) * fx;
        const Value bottom = level.at(x0, y1) * (1.0f - fx) + level.at(x1, y1) * fx;
        return top * (1.0f - fy) + bottom * fy;
    }

    // Each texel is the mean of the (up to) 2 x 2 that it covers; an odd last row or column is
    // repeated.
    static Level halved(const Level& from) {
        Level to;
        to.width = std::max(1, (from.width + 1) / 2);
        to.height = std::max(1, (from.height + 1) / 2);
        to.texels.reserve(static_cast<std::size_t>(to.width) * static_cast<std::size_t>(to.height));
        for (int y = 0; y < to.height; ++y) {
            const int y1 = std::min(2 * y + 1, from.height - 1);
            for (int x = 0; x < to.width; ++x) {
                const int x1 = std::min(2 * x + 1, from.width - 1);
                to.texels.push_back(Codec::encode((from.at(2 * x, 2 * y) + from.at(x1, 2 * y) +
                                                   from.at(2 * x, y1) + from.at(x1, y1)) *
                                                  0.25f));
            }
        }
        return to;
    }

    std::vector<Level> levels_;
};

}  // namespace carom::render
