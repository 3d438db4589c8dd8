#include "pipeline/video/hdr_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "core/assert.h"
#include "core/elementary.h"
#include "pipeline/video/code_value.h"
#include "pipeline/video/glow.h"
#include "pipeline/video/grade.h"
#include "pipeline/video/grain.h"

namespace carom::pipeline {

namespace {

constexpr double kPqPeak = 10000;  // cd/m^2
// SMPTE ST 2084:2014, section 5.2.
constexpr double kM1 = 2610.0 / 16384, kM2 = 2523.0 / 4096 * 128;
constexpr double kC1 = 3424.0 / 4096, kC2 = 2413.0 / 4096 * 32, kC3 = 2392.0 / 4096 * 32;

/// A table of 65535 pq_encode, with entries spaced evenly in the fourth root of luminance, where
/// the curve is smooth. Linear interpolation is accurate to 1/20 of a 10-bit step everywhere.
class PqTable {
  public:
    PqTable() {
        for (std::size_t i = 0; i < table_.size(); ++i) {
            const double root = static_cast<double>(i) / kSteps;
            table_[i] = static_cast<float>(65535 * pq_encode(kPqPeak * root * root * root * root));
        }
    }

    /// `light` in [0, 10000].
    [[nodiscard]] std::uint16_t operator()(float light) const {
        const float at = std::sqrt(std::sqrt(light / static_cast<float>(kPqPeak))) * kSteps;
        const auto index = std::min(static_cast<std::size_t>(at), table_.size() - 2);
        const float fraction = at - static_cast<float>(index);
        return nearest_code(table_[index] + fraction * (table_[index + 1] - table_[index]));
    }

  private:
    static constexpr int kSteps = 16384;
    std::array<float, kSteps + 1> table_{};
};

using Colour = std::array<float, 3>;

/// ITU-R BT.2087-0, section 2, M2.
Colour to_bt2020(const Colour& c) {
    return {0.6274F * c[0] + 0.3293F * c[1] + 0.0433F * c[2],
            0.0691F * c[0] + 0.9195F * c[1] + 0.0114F * c[2],
            0.0164F * c[0] + 0.0880F * c[1] + 0.8956F * c[2]};
}

/// The luminances at which a display shows the channels of a pixel, cd/m^2.
Colour shown(const Colour& rgb, float gain, double peak) {
    constexpr float kBrightest = 1e8F;  // keeps the arithmetic finite
    Colour light{};
    for (std::size_t i = 0; i < 3; ++i) {
        const float value = rgb[i] * gain;
        light[i] = value > 0 ? std::min(value, kBrightest) : 0.0F;  // NaN is not > 0
    }
    const float largest = std::max({light[0], light[1], light[2]});
    if (largest > 0.5 * peak) {
        const auto scale = static_cast<float>(compress_highlights(largest, peak) / largest);
        for (float& channel : light) {
            channel *= scale;
        }
    }
    return to_bt2020(light);
}

}  // namespace

double pq_encode(double light) {
    const double raised = power(std::clamp(light / kPqPeak, 0.0, 1.0), kM1);
    return power((kC1 + kC2 * raised) / (1 + kC3 * raised), kM2);
}

double pq_decode(double signal) {
    const double raised = power(std::clamp(signal, 0.0, 1.0), 1 / kM2);
    return kPqPeak * power(std::max(raised - kC1, 0.0) / (kC2 - kC3 * raised), 1 / kM1);
}

Vec3 graphics_to_hdr10(const Vec3& colour, double white) {
    const Colour wide = to_bt2020(
        {static_cast<float>(colour.x), static_cast<float>(colour.y), static_cast<float>(colour.z)});
    const auto signal = [white](float light) {
        return pq_encode(white * static_cast<double>(light));
    };
    return {signal(wide[0]), signal(wide[1]), signal(wide[2])};
}

double compress_highlights(double light, double peak) {
    const double knee = 0.5 * peak;
    return light <= knee ? light : peak - knee * exponential(-(light - knee) / knee);
}

std::vector<std::uint16_t> to_hdr10(const render::Film& film, const OutputSettings& output,
                                    const ViewedFrame& frame) {
    if (frame.lens.is_seen()) {
        return to_hdr10(with_lens(film, frame.lens), output, frame.number);
    }
    static const PqTable pq;
    CAROM_ASSERT(output.hdr10.has_value());
    const Hdr10Settings& settings = *output.hdr10;
    const bool glows = output.glow.is_seen();
    const render::Film glowing =
        glows ? with_glow(film, output.glow, output.exposure) : render::Film{};
    const std::vector<float>& rgba = glows ? glowing.rgba : film.rgba;
    const double exposure = exponential2(output.exposure);
    std::optional<Grade> grade;
    if (!is_neutral(output.grade)) {
        grade.emplace(output.grade);
    }
    const auto gain = static_cast<float>((grade ? 1 : exposure) * settings.white);
    const auto exposed = static_cast<float>(exposure);
    std::vector<std::uint16_t> signal;
    signal.reserve(rgba.size() / 4 * 3);
    for (std::size_t i = 0; i < rgba.size(); i += 4) {
        Colour light{rgba[i], rgba[i + 1], rgba[i + 2]};
        if (grade) {
            light = (*grade)({light[0] * exposed, light[1] * exposed, light[2] * exposed});
        }
        for (const float channel : shown(light, gain, settings.peak)) {
            signal.push_back(pq(std::min(channel, static_cast<float>(settings.peak))));
        }
    }
    if (output.grain > 0) {
        add_grain(signal, {frame.number, film.width, film.height, 0}, output.grain);
    }
    return signal;
}

}  // namespace carom::pipeline
