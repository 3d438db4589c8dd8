// The channels of a frame that the denoiser needs, and the denoised frame.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "core/progress.h"
#include "render/film/film.h"
#include "render/frame/splat_picture.h"
#include "render/frame/tile_sums.h"

namespace carom::render {

/// A pixel of a tile, and what camera rays saw of that tile.
struct DenoiserPixel {
    const TileSums* sums = nullptr;
    const TracedTile* traced = nullptr;
    std::size_t pixel = 0;
};

/// What the denoiser reads of some pixels. The halves of a pixel's samples are A and B:
///   half.R .G .B              (A - B) / 2 of the colour
///   half_variance.X           of the mean luminance, as if samples were independent
///   exact_albedo.R .G .B, exact_normal.X .Y .Z, exact_light.R .G .B
///                             features: means over more camera rays, and the samples
///   error_albedo.R ...        (A + B) / 2 of the feature, minus its exact mean
///   half_albedo.R ...         (A - B) / 2 of the feature
///   exact_share.X             weight of the samples in the exact features
/// Values have as few digits as suffice, so that they take little room in files.
class DenoiserValues {
  public:
    static constexpr std::size_t kMost = 256;  // pixels
    static constexpr std::size_t kFeatures = PixelFeatures::kCount;
    using Values = std::array<float, kMost>;

    /// Sets the first two channels.
    void set_colours(std::span<const DenoiserPixel> pixels);
    /// Sets the others.
    void set_features(std::span<const DenoiserPixel> pixels);

    [[nodiscard]] const Values& difference_of_colour(std::size_t c) const { return colours_[c]; }
    [[nodiscard]] const Values& variance() const { return variance_; }
    [[nodiscard]] const Values& exact(std::size_t feature) const { return exact_[feature]; }
    [[nodiscard]] const Values& error(std::size_t feature) const { return error_[feature]; }
    [[nodiscard]] const Values& difference(std::size_t feature) const {
        return difference_[feature];
    }
    [[nodiscard]] const Values& share() const { return share_; }

  private:
    std::array<Values, 3> colours_;
    std::array<Values, kFeatures> exact_, error_, difference_;
    Values variance_, share_;
};

/// A value of `half`, after the halves got colours of which half of the difference is `added`.
[[nodiscard]] float with_added_colour(float half, float added);

/// Collects these channels, some pixels at a time and from any thread.
class DenoiserPlanes {
  public:
    /// No planes.
    DenoiserPlanes() = default;
    DenoiserPlanes(int width, int height);

    [[nodiscard]] bool empty() const { return channels_.empty(); }
    /// Room for the first `pixels` of the picture; before there is none.
    void make_room(std::size_t pixels);

    /// Writes the pixels of a rectangle of this width, row by row; the first one is that number of
    /// the picture's.
    void write(std::span<const DenoiserPixel> pixels, std::size_t first, std::size_t width);

    /// Adds light to the halves. Once all pixels are written, from one thread.
    void add_to_colours(const SplatPicture& a, const SplatPicture& b);

    /// The channels, none without planes.
    [[nodiscard]] std::vector<HalfChannel> take() { return std::move(channels_); }

  private:
    int width_ = 0;
    std::vector<HalfChannel> channels_;
};

/// The film without noise (denoise.h) and without these channels, which it must have. It has the
/// film's alpha, other channels, notes and statistics. Throws Stopped, and Error if channels are
/// missing.
[[nodiscard]] Film denoised(const Film& film, const WorkContext& context = {});

/// By pixel, the error that such a film will have after denoising: DenoisedPicture::error. Throws
/// as denoised() does.
[[nodiscard]] std::vector<float> error_after_denoising(const Film& film,
                                                       const WorkContext& context = {});

}  // namespace carom::render
