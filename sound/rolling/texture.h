// A surface as it is felt by what moves over it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

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

/// Reads a texture out along a way. Each octave is smooth noise (a cubic B-spline whose control
/// values are a hash of seed, octave and cell), of which the slope is taken. It is a function of
/// the way alone, so it can be read at any speed, backwards and from anywhere.
///
/// All octaves are equally high, and so an octave's slope goes with 1 / its length lambda. Its
/// weight also contains the filter of the area of contact, after Remington (1976), "Wheel/rail
/// noise, part IV: rolling noise", Journal of Sound and Vibration 46:
///     |H|^2 = 1 / (1 + (pi/4) (k a)^3),   k = 2 pi / lambda, a the radius of the contact.
class TextureReader {
  public:
    static constexpr std::size_t kOctaves = 7;
    /// The weights of the octaves, and a zero.
    using Weights = std::array<double, kOctaves + 1>;

    TextureReader(std::uint64_t seed, const Texture& texture);

    /// The weights at a speed >= 0 (m of the way per s of the film). The sum of their squares is 1,
    /// less what these two factors take:
    /// - Cells that pass faster than 0.4 of the sample rate are left out, and fade out from 0.3.
    /// - 20 Hz high-pass: an octave has the factor f^2 / (f^2 + (20 Hz)^2), where f = speed /
    ///   (3 lambda) is the frequency at which its slope is strongest. A way that stands still has
    ///   the value 0. As a function of the speed, unlike a filter, it is the same in both
    ///   directions.
    [[nodiscard]] Weights weights(double speed) const;

    /// The root mean square of the values at this speed, in [0, 1].
    [[nodiscard]] double strength(double speed) const;

    /// The value at a place (m) with the weights first + part (last - first).
    double at(double way, const Weights& first, const Weights& last, double part);

    /// The value at a place (m), read at this speed.
    double at(double way, double speed) {
        const Weights now = weights(speed);
        return at(way, now, now, 0);
    }

  private:
    void enter_cell(std::size_t octave, double cell);

    std::array<std::uint64_t, kOctaves> seeds_{};
    Weights per_length_{};        // 1 / lambda
    Weights unfiltered_{};        // the weights without the two factors
    Weights cells_{};             // the cell of which the polynomials below are
    Weights c0_{}, c1_{}, c2_{};  // the slope in this cell
};

}  // namespace carom::sound
