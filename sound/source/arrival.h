// An impact as it arrives at one place.
#pragma once

#include <span>
#include <vector>

#include "sound/source/impact_sound.h"
#include "sound/source/pulse_train.h"

namespace carom::sound {

/// A sphere's part.
struct SphereWave {
    double onset = 0;  // s, scene time, after the instant at which a sound that leaves the place of
                       // contact with the impact arrives; may be negative
    Partial partial;
};

/// The pressure at a place, of one impact, in scene time.
struct Arrival {
    double distance = 0;      // m, from the contact, at least kNearest
    double contact_time = 0;  // s
    PulseShape shape = PulseShape::elastic;
    std::vector<SphereWave> spheres;
    std::vector<Partial> modes;  // with the onset 0
};

/// Nothing is heard from nearer than this, m.
inline constexpr double kNearest = 0.1;

/// What arrives at `place`, m. Spheres as in sphere_sound.h, each with its own distance, angle and
/// delay; modes fall with 1/r from the contact.
[[nodiscard]] Arrival arrival_at(const Vec3& place, const ImpactSound& sound);

/// Only the spheres' part of that, with the onsets measured from the sound of a contact that is
/// `contact_distance` away.
[[nodiscard]] std::vector<SphereWave> spheres_at(const Vec3& place, const ImpactSound& sound,
                                                 double contact_distance);

/// A place 1 m from an impact where a dipole along its axis is as loud as on average over all
/// directions (in the mean of the squares): at 54.7 degrees from the axis, as far up as that
/// allows. It turns with the impact about the vertical, and depends on no listener.
[[nodiscard]] Vec3 average_place(const ImpactSound& sound);

/// The pressure of an arrival at a time (s, scene time, after the same instant as the onsets), Pa.
[[nodiscard]] double pressure_at(const Arrival& arrival, double time);

/// The highest absolute pressure of an arrival.
struct Peak {
    double pressure = 0;  // Pa, >= 0
    double time = 0;      // s, scene time, after the same instant as the onsets
};

/// Found on a grid fine enough for the force and for each pole, with a parabola through the highest
/// three points: within 0.1 %.
[[nodiscard]] Peak find_peak(const Arrival& arrival);

}  // namespace carom::sound
