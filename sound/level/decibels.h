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

/// Brings the levels of single sounds closer together: the factor for a sound of `pressure` (Pa, at
/// the listener), so that its distance from 80 dB is divided by `ratio` >= 1. Levels below 0 dB are
/// treated as 0 dB.
[[nodiscard]] double dynamics_factor(double pressure, double ratio);

}  // namespace carom::sound
