#include "sound/rolling/texture_oscillator.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

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

/// The least strength of a texture by which a pressure is divided: slower motion is below 20 Hz
/// with all its octaves.
constexpr double kMinStrength = 1e-3;

}  // namespace

TextureOscillator::TextureOscillator(std::uint64_t seed, const Texture& texture) {
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

void TextureOscillator::enter_cell(std::size_t octave, double cell) {
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

TextureOscillator::Weights TextureOscillator::weights(double speed) const {
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

double TextureOscillator::strength(double speed) const {
    double sum = 0;
    for (const double weight : weights(speed)) {
        sum += weight * weight;
    }
    return std::sqrt(sum);
}

// Written for vectors: no branches in the loops, and a sum in pairs.
CAROM_VECTOR_CLONES double TextureOscillator::value(double place, const Weights& first,
                                                    const Weights& last, double part) {
    Weights in_cell{};
    int outside = 0;
    for (std::size_t i = 0; i < in_cell.size(); ++i) {
        in_cell[i] = place * per_length_[i] - cells_[i];
        outside |= static_cast<int>(in_cell[i] < 0) | static_cast<int>(in_cell[i] >= 1);
    }
    if (outside != 0) {
        for (std::size_t i = 0; i < kOctaves; ++i) {
            if (!(in_cell[i] >= 0 && in_cell[i] < 1)) {
                enter_cell(i, std::floor(place * per_length_[i]));
                in_cell[i] = place * per_length_[i] - cells_[i];
            }
        }
    }
    Weights values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double weight = first[i] + part * (last[i] - first[i]);
        values[i] = weight * (c0_[i] + in_cell[i] * (c1_[i] + in_cell[i] * c2_[i]));
    }
    return ((values[0] + values[4]) + (values[1] + values[5])) +
           ((values[2] + values[6]) + (values[3] + values[7]));
}

void TextureOscillator::set_curve(DistanceCurve curve, double offset) {
    curve_ = std::move(curve);
    offset_ = offset;
    piece_ = kNoPiece;
    begin();
}

double TextureOscillator::at(double scene_time, double playing_speed, double ratio) {
    const CurvePoint point = curve_.at(scene_time);
    if (has_last_) {
        shift_ += (point.distance + last_distance_) / 2 * (ratio - last_ratio_);
    } else {
        shift_ = 0;
        has_last_ = true;
    }
    last_distance_ = point.distance;
    last_ratio_ = ratio;
    if (point.is_at_rest) {
        return 0;
    }
    if (point.piece != piece_ || playing_speed != playing_speed_) {
        enter_piece(point.piece, playing_speed);
    }
    if (scales_[0] == 0 && scales_[1] == 0) {
        return 0;
    }
    return value(offset_ + ratio * point.distance - shift_, first_weights_, last_weights_,
                 point.part);
}

// Between the ends of a piece the weights are linear, so they are a function of scene time and
// playing speed alone.
void TextureOscillator::enter_piece(std::size_t piece, double playing_speed) {
    const PieceEnds& ends = curve_.ends(piece);
    if (piece != piece_) {
        piece_ = piece;
        for (std::size_t end = 0; end < 2; ++end) {
            const double pressure = ends.pressures[end];
            scales_[end] =
                pressure > 0 ? pressure / std::max(strength(ends.speeds[end]), kMinStrength) : 0;
        }
    }
    playing_speed_ = playing_speed;
    if (scales_[0] == 0 && scales_[1] == 0) {
        return;
    }
    first_weights_ = weights(ends.speeds[0] * playing_speed);
    last_weights_ = weights(ends.speeds[1] * playing_speed);
    for (std::size_t i = 0; i < first_weights_.size(); ++i) {
        first_weights_[i] *= scales_[0];
        last_weights_[i] *= scales_[1];
    }
}

}  // namespace carom::sound
