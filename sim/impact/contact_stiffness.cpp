#include "sim/impact/contact_stiffness.h"

#include <cmath>

#include "core/elementary.h"

namespace carom::sim {

double greatest_depth(const ContactStiffness& stiffness, double reduced_mass, double speed) {
    return stiffness.is_flat
               ? speed * std::sqrt(reduced_mass / stiffness.factor)
               : power(5 * reduced_mass * speed * speed / (4 * stiffness.factor), 0.4);
}

ContactStiffness hertz_stiffness(double reduced_modulus, double reduced_radius) {
    return {4.0 / 3 * reduced_modulus * std::sqrt(reduced_radius), false};
}

double contact_time(const ContactStiffness& stiffness, double reduced_mass, double speed) {
    constexpr double kPi = 3.14159265358979323846;
    return (stiffness.is_flat ? kPi : 2.943275) * greatest_depth(stiffness, reduced_mass, speed) /
           speed;
}

}  // namespace carom::sim
