// How loud rolling and scraping are.
#pragma once

namespace carom::sound {

/// The root mean square of the pressure at 1 m (Pa) of a ball that rolls on cloth at `speed` (m/s):
/// 40 dB + 9 dB log2(speed) (tuned: no measured level was found). Silent up to 20 mm/s; it reaches
/// the law at 40 mm/s.
[[nodiscard]] double rolling_pressure(double speed);

/// The same for a ball that slides at a slip speed: 3 dB more (tuned).
[[nodiscard]] double sliding_pressure(double slip);

/// The same for bodies that scrape at a slip speed (m/s) with a normal force (N):
/// 45 dB (tuned) times (slip / 0.1 m/s)^(3/4) sqrt(force / 1 N).
///
/// The exponent of the speed is that of "Influence of sliding speed on roughness noise" (2019), an
/// experiment and a simulation. The acoustic power is taken to be proportional to the force, as it
/// is to the area of contact in one of the two regimes of Le Bot, Bou Chakra and Michon (2011),
/// "Dissipation of vibration in rough contact", Tribology Letters 41. Silent up to 2 mm/s; it
/// reaches the law at 4 mm/s.
[[nodiscard]] double scraping_pressure(double slip, double force);

}  // namespace carom::sound
