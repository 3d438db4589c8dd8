#include "pipeline/plan/quantity_text.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"

namespace carom::pipeline {

namespace {

constexpr double kDegrees = 57.295779513082321;

}  // namespace

std::string speed_text(double speed) {
    return decimal_text(speed, speed >= 0.995 ? 1 : 2) + " m/s";
}

std::string time_text(double seconds) {
    return decimal_text(seconds, 3) + " s";
}

std::string milliseconds_text(double seconds) {
    return decimal_text(std::max(0.1, 1e3 * seconds), 1) + " ms";
}

std::string angle_text(double angle) {
    return decimal_text(std::round(angle * kDegrees), 0) + "°";
}

std::string radius_fraction_text(double fraction) {
    return decimal_text(fraction, 2) + " R";
}

}  // namespace carom::pipeline
