// The sound of a rigid sphere whose velocity jumps: an accelerated dipole with its near field.
#pragma once

#include "sound/sound_scene.h"
#include "sound/source/complex.h"

namespace carom::sound {

inline constexpr double kAirDensity = 1.204;  // kg/m^3, of air of 20 degrees Celsius

/// The pressure per velocity as a filter of the acceleration,
///     H(s) = rho c (R/r) cos(angle) (s + kappa R/r) / ((s + kappa)^2 + kappa^2),   kappa = c/R
/// (Koss & Alfredson, J. Sound Vib. 27, 1973, after Kirchhoff): two conjugate poles, of which this
/// is the one with a positive imaginary part. The response is 2 Re(residue e^{pole t}).
struct SpherePole {
    Complex pole;     // 1/s
    Complex residue;  // Pa per m/s
};

/// Of a sphere of `radius` (m), at `distance` >= radius (m) from its centre in a direction whose
/// angle with the jump of the velocity has this cosine. Time begins (distance - radius) / c after
/// the jump.
[[nodiscard]] SpherePole sphere_pole(double radius, double distance, double cosine);

}  // namespace carom::sound
