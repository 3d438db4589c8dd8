// How stiff two bodies are where they touch, and how long an impact of two lasts.
#pragma once

namespace carom::sim {

/// The force between two bodies that compress each other by d > 0: factor d^(3/2) (Hertz) for
/// curved surfaces, factor d for flat ones.
struct ContactStiffness {
    double factor = 0;  // N/m^(3/2) or N/m, > 0
    bool is_flat = false;
};

/// Hertz's factor, 4/3 E sqrt(R), with 1/E the sum of (1 - nu^2)/modulus and 1/R the sum of the
/// curvatures. `reduced_modulus`: E, Pa; `reduced_radius`: R, m.
[[nodiscard]] ContactStiffness hertz_stiffness(double reduced_modulus, double reduced_radius);

/// How long two bodies that meet at `speed` (> 0, m/s) touch each other without losses, s.
[[nodiscard]] double contact_time(const ContactStiffness& stiffness, double reduced_mass,
                                  double speed);

/// How far they compress each other without losses, m.
[[nodiscard]] double greatest_depth(const ContactStiffness& stiffness, double reduced_mass,
                                    double speed);

}  // namespace carom::sim
