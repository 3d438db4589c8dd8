// Glow: the light that the lens and the eye scatter around bright points.
#pragma once

#include <cstddef>
#include <vector>

#include "pipeline/video/gaussian_blur.h"
#include "pipeline/video/output_settings.h"
#include "render/film/film.h"

namespace carom::pipeline {

/// The film with a fraction of its light spread out: (1 - strength) I + strength (I * K). The
/// kernel K is normalised to 1 and falls off roughly as the inverse square of the distance, as
/// measured for glare in the eye and in lenses (Spencer, Shirley, Zimmerman and Greenberg 1995,
/// "Physically-based glare effects for digital images"): the mean of Gaussians of standard
/// deviations radius/16, radius/4 and radius (gaussian_blur.h), so it is isotropic. The picture is
/// mirrored at its border, so that its sum is preserved and a constant picture stays constant.
/// Alpha does not change. Values that are not finite count as 0.
///
/// Halation is what film adds: light that the base reflects exposes the layers again from behind,
/// red first. Of light above 1.2 after `exposure` (stops) a part is added around it, red to green
/// to blue as 3.5 : 1 : 0.2, spread by the mean of Gaussians of 5 and 9 pixels of 1080 (a ring of
/// 0.19 to 0.25 mm on 35 mm film). At a halation of 1 the part of red is 0.02.
[[nodiscard]] render::Film with_glow(const render::Film& film, const GlowSettings& settings,
                                     double exposure = 0);

/// The filter of with_glow for films of one size. For any number of threads.
class GlowFilter {
  public:
    /// `settings.is_seen()`.
    GlowFilter(const GlowSettings& settings, double exposure, int width, int height);

    /// Sets one colour channel (0 to 2) of `result`, which has the size of `film`, and leaves the
    /// others.
    void apply(const render::Film& film, std::size_t channel, render::Film& result) const;

  private:
    GlowSettings settings_;
    std::size_t width_;
    std::size_t height_;
    float bright_;  // light above this has a halo
    std::vector<GaussianBlur> blurs_;
    std::vector<GaussianBlur> halos_;
};

}  // namespace carom::pipeline
