#include "sound/source/sphere_sound.h"

namespace carom::sound {

SpherePole sphere_pole(double radius, double distance, double cosine) {
    const double kappa = kSpeedOfSound / radius;
    const double near = radius / distance;
    const Complex pole{-kappa, kappa};
    // The numerator at the pole over the distance of the two poles, 2 i kappa.
    const Complex residue = (pole + Complex{kappa * near, 0}) / Complex{0, 2 * kappa};
    return {pole, kAirDensity * kSpeedOfSound * near * cosine * residue};
}

}  // namespace carom::sound
