// The channels of a frame that the denoiser needs, and the denoised frame.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "core/progress.h"
#include "render/film/film.h"
#include "render/frame/feature_tracer.h"
#include "render/frame/pixel_sums.h"

namespace carom::render {

/// The means over what one half of a pixel's samples saw; all 0 if it has none.
[[nodiscard]] PixelFeatures features_of_half(const PixelSums& pixel, int half);

/// Collects these channels, some pixels at a time and from any thread. The halves of a pixel's
/// samples are A and B:
///   half.R .G .B              (A - B) / 2 of the colour
///   half_variance.X           of the mean luminance, as if samples were independent
///   exact_albedo.R .G .B, exact_normal.X .Y .Z, exact_light.R .G .B
///                             features: means over more camera rays, and the samples
///   error_albedo.R ...        (A + B) / 2 of the feature, minus its exact mean
///   half_albedo.R ...         (A - B) / 2 of the feature
///   exact_share.X             weight of the samples in the exact features
/// Values have as few digits as suffice, so that they take little room in files.
class DenoiserPlanes {
  public:
    /// No planes.
    DenoiserPlanes() = default;
    DenoiserPlanes(int width, int height);

    [[nodiscard]] bool empty() const { return channels_.empty(); }

    /// The most pixels of one call of write().
    static constexpr std::size_t kMost = 256;

    /// Writes the pixels of a rectangle of this width, row by row from the top left. `sums`: of the
    /// first one; those of the pixel below it follow after `row` others.
    void write(std::span<const FeaturePixel> pixels, std::size_t width, const PixelSums* sums,
               std::size_t row);

    /// Adds colours to the halves. Once all pixels are written, from one thread.
    void add_to_colours(const Film& a, const Film& b);

    /// Moves the channels to the film's; does nothing without planes.
    void append_to(Film& film);

  private:
    int width_ = 0;
    std::vector<Channel> channels_;
};

/// Whether it is the name of one of these channels.
[[nodiscard]] bool is_denoiser_channel(std::string_view name);

/// The film without noise (denoise.h) and without these channels, which it must have. It has the
/// film's alpha, other channels, notes and statistics. Throws Stopped, and Error if channels are
/// missing.
[[nodiscard]] Film denoised(const Film& film, const WorkContext& context = {});

/// By pixel, the error that such a film will have after denoising: DenoisedPicture::error. Throws
/// as denoised() does.
[[nodiscard]] std::vector<float> error_after_denoising(const Film& film,
                                                       const WorkContext& context = {});

}  // namespace carom::render
