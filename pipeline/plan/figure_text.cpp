#include "pipeline/plan/figure_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace carom::pipeline {

namespace {

constexpr double kDegrees = 57.295779513082321;

std::string fixed(double value, int decimals) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
    return text.data();
}

std::string trimmed(double value, int decimals) {
    std::string text = fixed(value, decimals);
    if (text.find('.') != std::string::npos) {
        text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.') {
            text.pop_back();
        }
    }
    return text == "-0" ? "0" : text;
}

}  // namespace

std::string speed_text(double speed) {
    return trimmed(speed, speed >= 0.995 ? 1 : 2) + " m/s";
}

std::string time_text(double seconds) {
    return trimmed(seconds, 3) + " s";
}

std::string milliseconds_text(double seconds) {
    return trimmed(std::max(0.1, 1e3 * seconds), 1) + " ms";
}

std::string angle_text(double angle) {
    return trimmed(std::round(angle * kDegrees), 0) + "°";
}

std::string radius_share_text(double share) {
    return trimmed(share, 2) + " R";
}

}  // namespace carom::pipeline
