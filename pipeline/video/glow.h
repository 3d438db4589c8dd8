// Glow: the light that the lens and the eye scatter around bright points.
#pragma once

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
[[nodiscard]] render::Film with_glow(const render::Film& film, const GlowSettings& settings);

}  // namespace carom::pipeline
