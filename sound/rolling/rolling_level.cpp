#include "sound/rolling/rolling_level.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"

namespace carom::sound {
namespace {

constexpr double kAtOneMetrePerSecond = 2e-3;     // Pa, 40 dB
constexpr double kRollingExponent = 1.494867641;  // 9 dB / (20 dB log10(2))
constexpr double kSlidingFactor = 1.4125375446;   // 3 dB
constexpr double kScraping = 3.5565588201e-3;     // Pa, 45 dB

/// 0 up to `least`, 1 from twice of it.
double fade_in(double speed, double least) {
    return std::clamp(speed / least - 1, 0.0, 1.0);
}

}  // namespace

double rolling_pressure(double speed) {
    const double fade = fade_in(speed, 0.020);
    return fade > 0 ? fade * kAtOneMetrePerSecond * power(speed, kRollingExponent) : 0;
}

double sliding_pressure(double slip) {
    return kSlidingFactor * rolling_pressure(slip);
}

double scraping_pressure(double slip, double force) {
    const double fade = fade_in(slip, 0.002);
    if (!(fade > 0 && force > 0)) {
        return 0;
    }
    return fade * kScraping * power(slip / 0.1, 0.75) * std::sqrt(force);
}

}  // namespace carom::sound
