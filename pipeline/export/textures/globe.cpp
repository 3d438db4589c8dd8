#include "pipeline/export/textures/globe.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary.h"

namespace carom::pipeline {

namespace {

bool is_on_axis(const Vec3& p) {
    constexpr double kOn = 1e-7;  // of its distance from the origin
    return std::sqrt(p.x * p.x + p.y * p.y) <= kOn * p.length();
}

}  // namespace

double longitude(const Vec3& p) {
    if (is_on_axis(p)) {
        return 0;
    }
    const double turns = arctangent2(p.y, p.x) / (2 * std::numbers::pi);
    const double positive = turns < 0 ? turns + 1 : turns;
    return positive < 1 ? positive : 0;
}

double latitude(const Vec3& p) {
    const double length = p.length();
    return length > 0 ? 1 - arccosine(std::clamp(p.z / length, -1.0, 1.0)) / std::numbers::pi : 0.5;
}

std::array<double, 3> longitudes(const std::array<Vec3, 3>& corners) {
    std::array<double, 3> result{};
    double low = 1;
    double high = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        result[i] = longitude(corners[i]);
        if (!is_on_axis(corners[i])) {
            low = std::min(low, result[i]);
            high = std::max(high, result[i]);
        }
    }
    const bool crosses = high - low > 0.5;
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        if (!is_on_axis(corners[i])) {
            result[i] += crosses && result[i] < 0.5 ? 1 : 0;
            sum += result[i];
            ++count;
        }
    }
    for (std::size_t i = 0; i < 3; ++i) {
        if (is_on_axis(corners[i])) {
            result[i] = count > 0 ? sum / count : 0;
        }
    }
    return result;
}

}  // namespace carom::pipeline
