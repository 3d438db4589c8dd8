#include "pipeline/video/grade.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>

#include "core/colour.h"
#include "core/elementary.h"

namespace carom::pipeline {

namespace {

// AMPAS S-2016-001, section 4.4.1.
constexpr double kLinearBelow = 0.0078125;  // in light
constexpr double kSlope = 10.5402377416545;
constexpr double kOffset = 0.0729055341958355;
constexpr double kStops = 17.52;
constexpr double kShift = 9.72;
constexpr double kBrightest = 65504;

double encoded(double light) {
    return light <= kLinearBelow ? kSlope * light + kOffset : (logarithm2(light) + kShift) / kStops;
}

/// Negative for the codes below black.
double decoded(double code) {
    const double light = (code - kOffset) / kSlope;
    return light <= kLinearBelow ? light : exponential2(code * kStops - kShift);
}

// Places of LogarithmicTable: the first bits of the numbers from kDimmest to above kBrightest.
// Below, a grade is nearly straight.
constexpr float kDimmest = 0x1p-13F;
constexpr unsigned kDropped = 17;  // bits of a number that only interpolate: 6 of 23 remain
constexpr std::uint32_t kFirst = std::bit_cast<std::uint32_t>(kDimmest) >> kDropped;
constexpr std::uint32_t kPlaces = (std::bit_cast<std::uint32_t>(0x1p16F) >> kDropped) - kFirst;

constexpr std::size_t kCodes = 4096;
const double kLastCode = encoded(kBrightest);

}  // namespace

bool is_neutral(const GradeSettings& settings) {
    return settings.slope == Vec3(1, 1, 1) && settings.offset == Vec3(0, 0, 0) &&
           settings.power == Vec3(1, 1, 1) && settings.saturation == 1;
}

template <class Curve>
Grade::LogarithmicTable::LogarithmicTable(const Curve& curve) {
    // The first cell, from 0 to kDimmest, is one more.
    table_.push_back(static_cast<float>(curve(0)));
    for (std::uint32_t i = 0; i <= kPlaces; ++i) {
        const auto light = std::bit_cast<float>((kFirst + i) << kDropped);
        table_.push_back(static_cast<float>(curve(static_cast<double>(light))));
    }
}

float Grade::LogarithmicTable::operator()(float light) const {
    std::size_t cell = 0;
    float fraction = 0;
    if (light >= kDimmest) {
        const auto bits = std::bit_cast<std::uint32_t>(light);
        cell = (bits >> kDropped) - kFirst + 1;
        constexpr std::uint32_t kRest = (1U << kDropped) - 1;
        fraction = static_cast<float>(bits & kRest) / static_cast<float>(1U << kDropped);
    } else {
        fraction = light / kDimmest;
    }
    return table_[cell] + (table_[cell + 1] - table_[cell]) * fraction;
}

Grade::Grade(const GradeSettings& settings) : saturation_(static_cast<float>(settings.saturation)) {
    for (int i = 0; i < 3; ++i) {
        graded_.at(static_cast<std::size_t>(i)) = LogarithmicTable([&](double light) {
            const double moved = encoded(light) * settings.slope[i] + settings.offset[i];
            return power(std::clamp(moved, 0.0, 16.0), settings.power[i]);
        });
    }
    light_.reserve(kCodes + 2);
    for (std::size_t i = 0; i <= kCodes + 1; ++i) {
        light_.push_back(static_cast<float>(
            decoded(kLastCode * static_cast<double>(i) / static_cast<double>(kCodes))));
    }
}

Grade::Colour Grade::operator()(const Colour& light) const {
    constexpr auto kMost = static_cast<float>(kBrightest);
    Colour code{};
    for (std::size_t i = 0; i < 3; ++i) {
        code[i] = graded_[i](light[i] > 0 ? std::min(light[i], kMost) : 0.0F);  // NaN is not > 0
    }
    const float grey = luminance({code[0], code[1], code[2]});
    const auto scale = static_cast<float>(kCodes / kLastCode);
    Colour result{};
    for (std::size_t i = 0; i < 3; ++i) {
        const float saturated = (grey + saturation_ * (code[i] - grey)) * scale;
        const float place = std::clamp(saturated, 0.0F, static_cast<float>(kCodes));
        const auto cell = static_cast<std::size_t>(place);
        const float fraction = place - static_cast<float>(cell);
        result[i] = std::max(light_[cell] + (light_[cell + 1] - light_[cell]) * fraction, 0.0F);
    }
    return result;
}

}  // namespace carom::pipeline
