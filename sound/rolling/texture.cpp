#include "sound/rolling/texture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/splitmix.h"
#include "core/vector_clones.h"
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
        unfiltered_[i] = std::sqrt(1 / (1 + std::numbers::pi / 4 * ka * ka * ka)) / length;
        sum += unfiltered_[i] * unfiltered_[i];
    }
    for (std::size_t i = 0; i < kOctaves; ++i) {
        unfiltered_[i] /= std::sqrt(sum);
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

TextureReader::Weights TextureReader::weights(double speed) const {
    Weights weights{};
    for (std::size_t i = 0; i < kOctaves; ++i) {
        const double rate = speed * per_length_[i];  // cells per s
        const double rate2 = rate * rate;
        const double fade = (kLeftOutFrom - rate) / (kLeftOutFrom - kFadesFrom);
        weights[i] =
            unfiltered_[i] * std::clamp(fade, 0.0, 1.0) * (rate2 / (rate2 + 9 * kLowest * kLowest));
    }
    return weights;
}

double TextureReader::strength(double speed) const {
    double sum = 0;
    for (const double weight : weights(speed)) {
        sum += weight * weight;
    }
    return std::sqrt(sum);
}

// Written for vectors: no branches in the loops, and a sum in pairs.
CAROM_VECTOR_CLONES double TextureReader::at(double way, const Weights& first, const Weights& last,
                                             double part) {
    Weights place{};
    int outside = 0;
    for (std::size_t i = 0; i < place.size(); ++i) {
        place[i] = way * per_length_[i] - cells_[i];
        outside |= static_cast<int>(place[i] < 0) | static_cast<int>(place[i] >= 1);
    }
    if (outside != 0) {
        for (std::size_t i = 0; i < kOctaves; ++i) {
            if (!(place[i] >= 0 && place[i] < 1)) {
                enter_cell(i, std::floor(way * per_length_[i]));
                place[i] = way * per_length_[i] - cells_[i];
            }
        }
    }
    Weights values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double weight = first[i] + part * (last[i] - first[i]);
        values[i] = weight * (c0_[i] + place[i] * (c1_[i] + place[i] * c2_[i]));
    }
    return ((values[0] + values[4]) + (values[1] + values[5])) +
           ((values[2] + values[6]) + (values[3] + values[7]));
}

}  // namespace carom::sound
