#include "sound/rolling/texture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/splitmix.h"
#include "sound/sound_scene.h"

namespace carom::sound {
namespace {

constexpr double kLowest = 20;                    // Hz
constexpr double kFadesFrom = 0.3 * kSampleRate;  // cells per s
constexpr double kLeftOutFrom = 0.4 * kSampleRate;

/// The slope of a cubic B-spline with independent control values, even in [-1, 1], has the variance
/// 2/9: 1/3 of the values times 2/3, the integral of the basis function's squared slope.
constexpr double kUnit = 2.1213203435596424;  // sqrt(9/2)

}  // namespace

TextureReader::TextureReader(std::uint64_t seed, const Texture& texture) {
    double sum = 0;
    double length = texture.longest;
    for (std::size_t i = 0; i < kOctaves; ++i, length /= 2) {
        seeds_[i] = split_mix(seed + (i + 1) * kSplitMixStep);
        per_length_[i] = 1 / length;
        const double ka = 2 * std::numbers::pi / length * texture.contact_radius;
        weights_[i] = std::sqrt(1 / (1 + std::numbers::pi / 4 * ka * ka * ka)) / length;
        sum += weights_[i] * weights_[i];
    }
    for (std::size_t i = 0; i < kOctaves; ++i) {
        weights_[i] /= std::sqrt(sum);
        enter_cell(i, 0);
    }
}

void TextureReader::enter_cell(std::size_t octave, double cell) {
    const auto first = static_cast<std::uint64_t>(static_cast<std::int64_t>(cell));
    std::array<double, 4> g{};
    for (std::uint64_t i = 0; i < g.size(); ++i) {
        const std::uint64_t bits = split_mix(seeds_[octave] + (first + i) * kSplitMixStep);
        g[i] = kUnit * (2 * unit_number(bits) - 1);
    }
    cells_[octave] = cell;
    c0_[octave] = (g[2] - g[0]) / 2;
    c1_[octave] = g[0] - 2 * g[1] + g[2];
    c2_[octave] = (g[3] - g[0] + 3 * (g[1] - g[2])) / 2;
}

TextureReader::Lanes TextureReader::gains(double speed) const {
    Lanes gains{};
    for (std::size_t i = 0; i < kLanes; ++i) {
        const double rate = speed * per_length_[i];
        const double frequency2 = rate * rate / 9;
        const double fade = (kLeftOutFrom - rate) * (1 / (kLeftOutFrom - kFadesFrom));
        gains[i] = weights_[i] * std::min(std::max(fade, 0.0), 1.0) * frequency2 /
                   (frequency2 + kLowest * kLowest);
    }
    return gains;
}

double TextureReader::at(double way, double speed) {
    Lanes place{};
    bool is_inside = true;
    for (std::size_t i = 0; i < kLanes; ++i) {
        place[i] = way * per_length_[i] - cells_[i];
        is_inside = is_inside && place[i] >= 0 && place[i] < 1;
    }
    if (!is_inside) {
        for (std::size_t i = 0; i < kOctaves; ++i) {
            if (!(place[i] >= 0 && place[i] < 1)) {
                enter_cell(i, std::floor(way * per_length_[i]));
                place[i] = way * per_length_[i] - cells_[i];
            }
        }
    }
    const Lanes gain = gains(speed);
    Lanes values{};
    for (std::size_t i = 0; i < kLanes; ++i) {
        values[i] = gain[i] * (c0_[i] + place[i] * (c1_[i] + place[i] * c2_[i]));
    }
    return ((values[0] + values[4]) + (values[1] + values[5])) +
           ((values[2] + values[6]) + (values[3] + values[7]));
}

double TextureReader::strength(double speed) const {
    double sum = 0;
    for (const double gain : gains(speed)) {
        sum += gain * gain;
    }
    return std::sqrt(sum);
}

}  // namespace carom::sound
