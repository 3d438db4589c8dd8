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

double compressor_gain(double pressure, double ratio, double quiet) {
    constexpr double kCentre = 80;  // dB
    constexpr double kFades = 20;   // dB, from `quiet` down
    if (ratio == 1) {
        return 1;
    }
    const double level = level_of(std::max(pressure, kReferencePressure));
    const double gain = (kCentre - std::max(level, quiet)) * (1 - 1 / ratio);
    return factor_of(gain * std::clamp(1 - (quiet - level) / kFades, 0.0, 1.0));
}

}  // namespace carom::sound
