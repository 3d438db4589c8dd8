// Pixel filters by importance sampling: a camera ray is offset from the pixel's centre with a
// density proportional to the filter and has weight one, so that pixels stay independent (Ernst,
// Stamminger and Greiner 2006, "Filter importance sampling").
#pragma once

#include <cstdint>
#include <vector>

#include "render/sampling/pixel_filter_tables.h"
#include "render/scene/render_settings.h"

namespace carom::render {

/// One filter of one width, separable with the same profile in x and y. Immutable.
class PixelFilterSampler {
  public:
    /// `width`: the full width of the profile in pixels, > 0, also for the box.
    PixelFilterSampler(PixelFilter filter, double width);

    [[nodiscard]] double width() const { return width_; }  // pixels

    /// For kernels/pixel_filter.h; valid as long as this object is.
    [[nodiscard]] PixelFilterTables tables() const;

    /// Density of the samples along one axis, per pixel; 0 beyond half the width.
    [[nodiscard]] double pdf_1d(double offset_pixels) const;

  private:
    /// One cell of the tabulated distribution: offset = start + slope (u - cdf).
    struct Cell {
        float cdf, start, slope;
    };

    PixelFilter filter_;
    double width_;
    double norm_ = 1;
    std::vector<Cell> cells_;  // equally wide, with one more at the end; empty for the box
    std::vector<std::int32_t> guide_;
};

/// The unnormalised profile at x in [-1/2, 1/2] of the width: 1 for the box; a Gaussian whose
/// standard deviation is a sixth of the width; the four-term window of Harris 1978, "On the use of
/// windows for harmonic analysis with the discrete Fourier transform", table 1 (-92 dB).
[[nodiscard]] double filter_profile(PixelFilter filter, double x);

}  // namespace carom::render
