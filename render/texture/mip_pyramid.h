// A mip map: a picture at all halved resolutions, looked up bilinearly at the size that a pixel
// covers.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/assert.h"
#include "render/texture/scalar_kernels.h"

namespace carom::render {

/// Beyond [0, 1], a picture continues its edge or repeats.
enum class Wrap { clamp, repeat };

template <class T>
[[nodiscard]] List<std::uint8_t> bytes_of(const std::vector<T>& list) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes of plain data
    return {reinterpret_cast<const std::uint8_t*>(list.data()),
            static_cast<std::int64_t>(list.size() * sizeof(T))};
}

/// What a texel of the next level shows.
template <class Value>
[[nodiscard]] Value mean_of_four(const Value& a, const Value& b, const Value& c, const Value& d) {
    return (a + b + c + d) * 0.25f;
}

/// `Codec` names a stored `Texel`, the `Value` that it represents, and the functions decode and
/// encode between them. kernels/mip_pyramid.h looks values up. A value
/// of one level takes four texels: 35 ns for colours where OpenImageIO's TextureSystem, which can
/// page pictures larger than the memory, takes 290 (bench/frame_bench.cpp).
template <class Codec>
class MipPyramid {
  public:
    using Texel = typename Codec::Texel;
    using Value = typename Codec::Value;

    MipPyramid() = default;

    /// Whether kernels, which count bytes in 31 bits, reach all levels of a picture of this size.
    [[nodiscard]] static bool fits(int width, int height) {
        MipPyramid empty;
        return (empty.plan(width, height) + kPadding) * sizeof(Texel) <=
               std::numeric_limits<std::int32_t>::max();
    }

    /// `texels`: width * height, row by row from the top left.
    MipPyramid(int width, int height, const std::vector<Texel>& texels, Wrap wrap)
        : MipPyramid(width, height, wrap, [&](int x, int y) {
              return texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                            static_cast<std::size_t>(x)];
          }) {
        CAROM_ASSERT(texels.size() ==
                     static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    }

    /// `texel_at(x, y)`: of a picture that fits.
    template <class TexelAt>
    MipPyramid(int width, int height, Wrap wrap, const TexelAt& texel_at) : wrap_(wrap) {
        CAROM_ASSERT(width > 0 && height > 0 && fits(width, height));
        texels_.resize(plan(width, height) + kPadding);
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                texel(0, x, y) = texel_at(x, y);
            }
        }
        set_border(0);
        for (std::size_t level = 1; level < level_count(); ++level) {
            halve_into(level);
            set_border(level);
        }
    }

    [[nodiscard]] int width() const { return widths_.front(); }
    [[nodiscard]] int height() const { return heights_.front(); }
    [[nodiscard]] std::size_t level_count() const { return widths_.size(); }

    /// For kernels; valid as long as this object is.
    [[nodiscard]] PyramidTables tables() const {
        return {bytes_of(texels_),
                List<std::int32_t>(firsts_),
                List<std::int32_t>(widths_),
                List<std::int32_t>(heights_),
                static_cast<float>(std::max(width(), height())),
                wrap_ == Wrap::repeat};
    }

  private:
    /// Kernels read 32 bits at a time, which may begin at the last texel.
    static constexpr std::size_t kPadding = 4;

    /// Sets the sizes and places of all levels. Returns the number of their texels.
    std::size_t plan(int width, int height) {
        std::size_t total = 0;
        for (;;) {
            const std::size_t stride = static_cast<std::size_t>(width) + 2;
            firsts_.push_back(static_cast<std::int32_t>(total + stride + 1));
            widths_.push_back(width);
            heights_.push_back(height);
            total += stride * (static_cast<std::size_t>(height) + 2);
            if (width == 1 && height == 1) {
                return total;
            }
            width = (width + 1) / 2;
            height = (height + 1) / 2;
        }
    }

    /// x and y may be those of the border, -1 and the size.
    [[nodiscard]] Texel& texel(std::size_t level, int x, int y) {
        return texels_[static_cast<std::size_t>(firsts_[level] +
                                                std::ptrdiff_t{y} * (widths_[level] + 2) + x)];
    }

    /// The border holds the texels that follow if the picture is wrapped.
    void set_border(std::size_t level) {
        const int width = widths_[level];
        const int height = heights_[level];
        const bool repeats = wrap_ == Wrap::repeat;
        for (int y = 0; y < height; ++y) {
            texel(level, -1, y) = texel(level, repeats ? width - 1 : 0, y);
            texel(level, width, y) = texel(level, repeats ? 0 : width - 1, y);
        }
        for (int x = -1; x <= width; ++x) {
            texel(level, x, -1) = texel(level, x, repeats ? height - 1 : 0);
            texel(level, x, height) = texel(level, x, repeats ? 0 : height - 1);
        }
    }

    /// Each texel is the mean of the (up to) 2 x 2 of the previous level that it covers; an odd
    /// last row or column is repeated.
    void halve_into(std::size_t level) {
        const auto from = [&](int x, int y) { return Codec::decode(texel(level - 1, x, y)); };
        for (int y = 0; y < heights_[level]; ++y) {
            const int y1 = std::min(2 * y + 1, heights_[level - 1] - 1);
            for (int x = 0; x < widths_[level]; ++x) {
                const int x1 = std::min(2 * x + 1, widths_[level - 1] - 1);
                texel(level, x, y) = Codec::encode(mean_of_four(from(2 * x, 2 * y), from(x1, 2 * y),
                                                                from(2 * x, y1), from(x1, y1)));
            }
        }
    }

    Wrap wrap_ = Wrap::clamp;
    std::vector<Texel> texels_;  // of all levels
    // By level: see PyramidTables.
    std::vector<std::int32_t> firsts_, widths_, heights_;
};

}  // namespace carom::render
