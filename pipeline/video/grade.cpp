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

/// Chromaticity of a black body, as X, Y and Z with Y = 1.
Vec3 black_body(double t) {
    const double x = t <= 4000
                         ? ((-0.2661239e9 / t - 0.2343589e6) / t + 0.8776956e3) / t + 0.179910
                         : ((-3.0258469e9 / t + 2.1070379e6) / t + 0.2226347e3) / t + 0.240390;
    double y = ((3.0817580 * x - 5.87338670) * x + 3.75112997) * x - 0.37001483;
    if (t <= 2222) {
        y = ((-1.1063814 * x - 1.34811020) * x + 2.18555832) * x - 0.20219683;
    } else if (t <= 4000) {
        y = ((-0.9549476 * x - 1.37418593) * x + 2.09137015) * x - 0.16748867;
    }
    return {x / y, 1, (1 - x - y) / y};
}

using Rows = std::array<Vec3, 3>;

Vec3 product(const Rows& m, const Vec3& v) {
    return {m[0].dot(v), m[1].dot(v), m[2].dot(v)};
}
Rows inverse(const Rows& m) {
    // The columns are the cross products of the rows.
    const Vec3 a = m[1].cross(m[2]), b = m[2].cross(m[0]), c = m[0].cross(m[1]);
    const double scale = 1 / m[0].dot(a);
    return {Vec3(a.x, b.x, c.x) * scale, Vec3(a.y, b.y, c.y) * scale, Vec3(a.z, b.z, c.z) * scale};
}

/// XYZ of Rec.709's red, green and blue (ITU-R BT.709-6, with the white D65).
const Rows kToXyz{Vec3(0.4123908, 0.3575843, 0.1804808), Vec3(0.2126390, 0.7151687, 0.0721923),
                  Vec3(0.0193308, 0.1191948, 0.9505322)};
const Rows kBradford{Vec3(0.8951, 0.2664, -0.1614), Vec3(-0.7502, 1.7135, 0.0367),
                     Vec3(0.0389, -0.0685, 1.0296)};

}  // namespace

bool is_neutral(const GradeSettings& settings) {
    return settings.slope == Vec3(1, 1, 1) && settings.offset == Vec3(0, 0, 0) &&
           settings.power == Vec3(1, 1, 1) && settings.saturation == 1 && !settings.white_balance;
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

Grade::Matrix Grade::balance_for(double temperature) {
    const Vec3 seen = product(kBradford, black_body(temperature));
    const Vec3 white = product(kBradford, product(kToXyz, Vec3(1, 1, 1)));
    const Rows from_xyz = inverse(kToXyz);
    const Rows from_cones = inverse(kBradford);
    Matrix balance{};
    for (int column = 0; column < 3; ++column) {
        Vec3 unit(0, 0, 0);
        unit[column] = 1;
        const Vec3 adapted = product(kBradford, product(kToXyz, unit)) * white / seen;
        const Vec3 light = product(from_xyz, product(from_cones, adapted));
        for (int row = 0; row < 3; ++row) {
            balance.at(static_cast<std::size_t>(row)).at(static_cast<std::size_t>(column)) =
                static_cast<float>(light[row]);
        }
    }
    return balance;
}

Grade::Grade(const GradeSettings& settings) : saturation_(static_cast<float>(settings.saturation)) {
    if (settings.white_balance) {
        balance_ = balance_for(*settings.white_balance);
    }
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
    Colour balanced = light;
    for (std::size_t i = 0; balance_ && i < 3; ++i) {
        const Colour& row = (*balance_)[i];
        balanced[i] = row[0] * light[0] + row[1] * light[1] + row[2] * light[2];
    }
    Colour code{};
    for (std::size_t i = 0; i < 3; ++i) {
        const float value = balanced[i] > 0 ? balanced[i] : 0.0F;  // NaN is not > 0
        code[i] = graded_[i](std::min(value, kMost));
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
