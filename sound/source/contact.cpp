#include "sound/source/contact.h"

#include <algorithm>
#include <cmath>

#include "core/assert.h"
#include "core/elementary.h"

namespace carom::sound {

double reduced(double first, double second) {
    if (std::isinf(first)) {
        return second;
    }
    if (std::isinf(second)) {
        return first;
    }
    return first * second / (first + second);
}

double reduced_modulus(const Material& first, const Material& second) {
    return 1 / ((1 - first.poisson * first.poisson) / first.modulus +
                (1 - second.poisson * second.poisson) / second.modulus);
}

double hertz_contact_time(const ContactPair& pair, double impulse) {
    CAROM_ASSERT(impulse > 0);
    const double speed = impulse / (pair.reduced_mass * (1 + pair.restitution));
    const double stiffness = pair.reduced_modulus * std::sqrt(pair.reduced_radius);
    const double indentation =
        power(15 * pair.reduced_mass * speed * speed / (16 * stiffness), 2.0 / 5);
    return 2.943 * indentation / speed;
}

double resonator_contact_time(const Resonator& resonator, double mass, double impulse) {
    constexpr double kMinSpeed = 1e-3;
    const double speed = std::max(impulse / (mass * (1 + resonator.restitution)), kMinSpeed);
    return resonator.contact * power(speed / resonator.reference_speed, resonator.contact_exponent);
}

}  // namespace carom::sound
