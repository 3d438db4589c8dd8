#include "sound/level/decibels.h"

#include <algorithm>
#include <numbers>

#include "core/elementary.h"

namespace carom::sound {

double factor_of(double decibels) {
    return exponential(decibels * (std::numbers::ln10 / 20));
}

double decibels_of(double factor) {
    return (20 / std::numbers::ln10) * logarithm(factor);
}

double level_of(double pressure) {
    return decibels_of(pressure / kReferencePressure);
}

double pressure_of(double level) {
    return kReferencePressure * factor_of(level);
}

double dynamics_factor(double pressure, double ratio) {
    constexpr double kCentre = 1e4 * kReferencePressure;  // 80 dB
    if (ratio == 1) {
        return 1;
    }
    return power(std::max(pressure, kReferencePressure) / kCentre, 1 / ratio - 1);
}

}  // namespace carom::sound
