// The sound of an impact that arrives at one place directly: rigid spheres whose velocities change,
// which are accelerated dipoles with their near field, and modes.
#pragma once

#include <span>
#include <vector>

#include "sound/source/impact_sound.h"
#include "sound/source/mode_bank.h"

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
/// angle with the velocity step has this cosine. Time begins (distance - radius) / c after
/// the step.
[[nodiscard]] SpherePole sphere_pole(double radius, double distance, double cosine);

/// A sphere's part.
struct SphereWave {
    double onset = 0;  // s, scene time, after the instant at which a sound that leaves the place of
                       // contact with the impact arrives; may be negative
    Partial partial;
};

/// The pressure at a place, of one impact, in scene time.
struct DirectSound {
    double distance = 0;      // m, from the contact, at least kNearest
    double contact_time = 0;  // s
    PulseShape shape = PulseShape::elastic;
    std::vector<SphereWave> spheres;
    std::vector<Partial> modes;  // with the onset 0
};

/// Distances below this count as this, m.
inline constexpr double kNearest = 0.1;

/// What arrives at `place`, m. Spheres as in sphere_pole, each with its own distance, angle and
/// delay; modes fall with 1/r from the contact.
[[nodiscard]] DirectSound direct_sound_at(const Vec3& place, const ImpactSound& sound);

/// Only the spheres' part of that, with the onsets measured from the sound of a contact that is
/// `contact_distance` away.
[[nodiscard]] std::vector<SphereWave> spheres_at(const Vec3& place, const ImpactSound& sound,
                                                 double contact_distance);

/// A place 1 m from an impact where a dipole along its axis is as loud as on average over all
/// directions (in the mean of the squares): at 54.7 degrees from the axis, as far up as that
/// allows. It turns with the impact about the vertical, and depends on no listener.
[[nodiscard]] Vec3 average_place(const ImpactSound& sound);

/// The highest absolute pressure of a direct sound.
struct Peak {
    double pressure = 0;  // Pa, >= 0
    double time = 0;      // s, scene time, after the same instant as the onsets
};

/// Found on a grid fine enough for the force and for each pole, with a parabola through the highest
/// three points: within 0.1 %.
[[nodiscard]] Peak find_peak(const DirectSound& sound);

}  // namespace carom::sound
