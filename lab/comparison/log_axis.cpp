#include "lab/comparison/log_axis.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

namespace carom::pipeline {

void LogAxis::add(double value) {
    if (value > 0) {
        least_ = least_ > 0 ? std::min(least_, value) : value;
        most_ = std::max(most_, value);
    }
}

int LogAxis::lowest() const {
    return least_ > 0 ? static_cast<int>(std::floor(std::log10(least_) + 1e-9)) : 0;
}

int LogAxis::highest() const {
    const int top = most_ > 0 ? static_cast<int>(std::ceil(std::log10(most_) - 1e-9)) : 1;
    return std::max(top, lowest() + 1);
}

double LogAxis::at(double value) const {
    const double fraction = (std::log10(value) - lowest()) / (highest() - lowest());
    return from_ + (to_ - from_) * std::clamp(fraction, 0.0, 1.0);
}

std::string power_text(int exponent) {
    if (exponent < 0) {
        return "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + "1";
    }
    const std::string zeros(static_cast<std::size_t>(exponent % 3), '0');
    const char* prefix = exponent < 3 ? "" : exponent < 6 ? "k" : exponent < 9 ? "M" : "G";
    return exponent < 12 ? "1" + zeros + prefix : fmt::format("1e{}", exponent);
}

}  // namespace carom::pipeline
