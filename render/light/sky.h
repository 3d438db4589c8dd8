// Radiance of a clear sky from the sun's direction and the turbidity.
#pragma once

#include "render/scene/scene_description.h"
#include "render/texture/image.h"

namespace carom::render {

/// Radiance of the sky in a direction (unit, z >= 0): A. J. Preetham, P. Shirley and B. Smits 1999,
/// "A practical analytic model for daylight", appendix A.2: luminance and chromaticity by Perez'
/// formula, fitted to simulated skies. Linear Rec.709 in W/(m^2 sr), from cd/m^2 by 179 lm/W (the
/// efficacy of white light by the convention of Ward 1994, "The RADIANCE lighting simulation and
/// rendering system"). The sun's disk is not included.
[[nodiscard]] V3f environment_radiance(const Sky& sky, const V3f& direction);

/// The sky as an equirectangular picture. Below the horizon it shows the ground, a diffuse surface
/// of the given albedo under the whole sky. Throws Error for a sun at or below the horizon or a
/// turbidity outside [2, 10].
[[nodiscard]] LinearImage sky_picture(const Sky& sky);

}  // namespace carom::render
