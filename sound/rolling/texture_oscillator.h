// The texture of a surface, and the sound of what moves over it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "sound/rolling/distance_curve.h"

namespace carom::sound {

/// The octaves of a surface.
struct Texture {
    double longest = 0.0384;         // m, the cells of the longest of the seven octaves
    double contact_radius = 0.0015;  // m, of the area of contact, which evens out shorter waves
};

/// Cloth under a ball: 0.6 to 38 mm (tuned).
inline constexpr Texture kCloth{};
/// Solids on each other: 0.075 to 4.8 mm (tuned).
inline constexpr Texture kSolid{0.0048, 0.0002};

/// The pressure at 1 m of a contact that moves over a texture, read out along a curve of distance.
/// Its root mean square is the curve's pressure at normal speed; at another playing speed the same
/// texture is read out slower or faster, and only the limits of audible frequencies change the
/// level.
///
/// Each octave of the texture is smooth noise (a cubic B-spline whose control values are a hash of
/// seed, octave and cell), of which the slope is taken. It is a function of the distance alone, so
/// it can be read at any speed, backwards and from anywhere.
///
/// All octaves are equally high, and so an octave's slope goes with 1 / its length lambda. Its
/// weight also contains the filter of the area of contact, after Remington (1976), "Wheel/rail
/// noise, part IV: rolling noise", Journal of Sound and Vibration 46:
///     |H|^2 = 1 / (1 + (pi/4) (k a)^3),   k = 2 pi / lambda, a the radius of the contact.
class TextureOscillator {
  public:
    static constexpr std::size_t kOctaves = 7;
    /// The weights of the octaves, and a zero.
    using Weights = std::array<double, kOctaves + 1>;

    TextureOscillator(std::uint64_t seed, const Texture& texture);

    /// `offset`: the place in the texture (m) where the curve begins.
    void set_curve(DistanceCurve curve, double offset);

    /// Forgets the previous call of at().
    void begin() { has_last_ = false; }

    /// The pressure, Pa. `ratio`: playing speed / film's speed. The place that is read is the
    /// integral of the ratio over the distance since begin(), plus a constant. In parts,
    ///     int r dx = r x - int x dr,
    /// it depends on the time alone where the ratio is constant.
    [[nodiscard]] double at(double scene_time, double playing_speed, double ratio);

    /// The weights at a speed >= 0 (m of the texture per s of the film). The sum of their squares
    /// is 1, less what these two factors take:
    /// - Cells that pass faster than 0.4 of the sample rate are left out, and fade out from 0.3.
    /// - 20 Hz high-pass: an octave has the factor f^2 / (f^2 + (20 Hz)^2), where f = speed /
    ///   (3 lambda) is the frequency at which its slope is strongest. Without motion the value is
    ///   0. As a function of the speed, unlike a filter, it is the same in both directions.
    [[nodiscard]] Weights weights(double speed) const;

    /// The root mean square of the values at this speed, in [0, 1].
    [[nodiscard]] double strength(double speed) const;

    /// The texture's value at a place (m) with the weights first + part (last - first).
    [[nodiscard]] double value(double place, const Weights& first, const Weights& last,
                               double part);

  private:
    void enter_cell(std::size_t octave, double cell);
    void enter_piece(std::size_t piece, double playing_speed);

    static constexpr auto kNoPiece = static_cast<std::size_t>(-1);

    std::array<std::uint64_t, kOctaves> seeds_{};
    Weights per_length_{};        // 1 / lambda
    Weights unfiltered_{};        // the weights without the two factors
    Weights cells_{};             // the cell of which the polynomials below are
    Weights c0_{}, c1_{}, c2_{};  // the slope in this cell

    DistanceCurve curve_;
    double offset_ = 0;
    bool has_last_ = false;
    double last_distance_ = 0;
    double last_ratio_ = 1;
    double shift_ = 0;  // int x dr since begin()
    // Of the present piece of the curve, and of the playing speed there.
    std::size_t piece_ = kNoPiece;
    std::array<double, 2> scales_{};  // pressure per strength of the texture at normal speed
    double playing_speed_ = 0;
    Weights first_weights_{}, last_weights_{};
};

}  // namespace carom::sound
