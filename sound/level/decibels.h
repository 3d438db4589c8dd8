// Decibels of pressures and of factors.
#pragma once

namespace carom::sound {

inline constexpr double kReferencePressure = 20e-6;  // Pa, of 0 dB (ISO 1683)

/// The factor of a gain in dB.
[[nodiscard]] double factor_of(double decibels);

/// The gain in dB of a factor >= 0; minus infinity for 0.
[[nodiscard]] double decibels_of(double factor);

/// The level of a pressure >= 0 (Pa) in dB re 20 uPa; minus infinity for 0.
[[nodiscard]] double level_of(double pressure);

/// The pressure (Pa) of a level in dB re 20 uPa.
[[nodiscard]] double pressure_of(double level);

/// Below these levels (dB, at 1 m) dynamics lift a sound less and less: of the peak of an impact,
/// and of the root mean square of a lasting sound. The ear sums over about 0.2 s (Zwislocki 1960,
/// "Theory of temporal auditory summation", J. Acoust. Soc. Am. 32), so an impact of half a
/// millisecond is as loud as a lasting sound 26 dB below its peak.
inline constexpr double kQuietImpact = 60;
inline constexpr double kQuietNoise = 34;

/// Brings the levels of single sounds closer together: the factor for a sound of `pressure` (Pa) at
/// 1 m, so that its distance from 80 dB is divided by `ratio` >= 1. Below the level `quiet` (dB, at
/// most 80) the gain falls linearly, and from 20 dB below it there is none: what nobody would hear
/// stays so.
[[nodiscard]] double compressor_gain(double pressure, double ratio, double quiet);

}  // namespace carom::sound
