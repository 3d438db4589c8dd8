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

Contact hertz_contact(const ContactPair& pair, double impulse) {
    CAROM_ASSERT(impulse > 0);
    const double speed = impulse / (pair.reduced_mass * (1 + pair.restitution));
    const double stiffness = pair.reduced_modulus * std::sqrt(pair.reduced_radius);
    const double overlap =
        power(15 * pair.reduced_mass * speed * speed / (16 * stiffness), 2.0 / 5);
    return {speed, 2.943 * overlap / speed, 4.0 / 3 * stiffness * overlap * std::sqrt(overlap),
            overlap};
}

double structure_contact_time(const Structure& structure, double mass, double impulse) {
    constexpr double kLeastSpeed = 1e-3;
    const double speed = std::max(impulse / (mass * (1 + structure.restitution)), kLeastSpeed);
    return structure.contact * power(speed / structure.reference_speed, structure.contact_exponent);
}

}  // namespace carom::sound
