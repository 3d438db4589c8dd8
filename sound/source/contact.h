// How long two bodies touch when they collide: the elastic contact of Hertz (J. reine angew. Math.
// 92, 1882; Johnson, Contact Mechanics, 1985, sections 4.2 and 11.4).
#pragma once

#include "sound/sound_scene.h"

namespace carom::sound {

/// Two solids that meet at a point.
struct ContactPair {
    double reduced_mass = 0.085;     // kg, m1 m2 / (m1 + m2)
    double reduced_radius = 0.0143;  // m, R1 R2 / (R1 + R2)
    double reduced_modulus = 3.3e9;  // Pa, 1 / sum of (1 - poisson^2) / modulus
    double restitution = 0.95;       // [0, 1]
};

/// m1 m2 / (m1 + m2); either may be infinite, both are above 0. The same formula serves radii.
[[nodiscard]] double reduced(double first, double second);

/// 1 / sum of (1 - poisson^2) / modulus, Pa.
[[nodiscard]] double reduced_modulus(const Material& first, const Material& second);

/// The duration (s) of the contact with a normal impulse of `impulse` > 0 (N s): 2.943 d / v, with
/// the speed of approach v = J / (m (1 + e)) and the indentation
/// d = (15 m v^2 / (16 E sqrt R))^(2/5).
[[nodiscard]] double hertz_contact_time(const ContactPair& pair, double impulse);

/// The duration of a contact with a resonator, whose contact time is measured, by a body of `mass`
/// kg: contact (v / reference_speed)^contact_exponent, s. The speed is taken as 1 mm/s at least.
[[nodiscard]] double resonator_contact_time(const Resonator& resonator, double mass,
                                            double impulse);

}  // namespace carom::sound
