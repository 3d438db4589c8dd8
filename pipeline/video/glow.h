// Light that lens and eye scatter around bright points.
#pragma once

#include "pipeline/video/output_settings.h"
#include "render/film/film.h"

namespace carom::pipeline {

/// The film's colours with a share of them spread out: (1 - strength) I + strength (I * K). The
/// kernel K adds up to 1 and falls off about as the inverse square of the distance, as measured for
/// glare in the eye and in lenses (Spencer, Shirley, Zimmerman and Greenberg 1995,
/// "Physically-based glare effects for digital images"): the mean of Gaussians of standard
/// deviations radius/16, radius/4 and radius (gaussian_blur.h), so it is the same in all
/// directions. What would fall beyond the border is mirrored at it: the picture's sum is kept, and
/// an even picture stays even. Alpha is left alone. Values that are not finite count as 0.
[[nodiscard]] render::Film with_glow(const render::Film& film, const GlowSettings& settings);

}  // namespace carom::pipeline
