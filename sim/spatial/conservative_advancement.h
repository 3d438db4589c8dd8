// Time of impact for gaps without a polynomial.
#pragma once

#include <functional>
#include <optional>

namespace carom::sim {

/// Gaps up to this (m) count as touching here.
inline constexpr double kAdvanceDistance = 1e-10;

/// When a gap that never closes faster than `speed` (m/s) first closes in [now, until], by the
/// rules of time_of_impact.h. Stretches of time that are too short for the gap to close and open
/// again are passed over at once (the bound of conservative advancement: Mirtich, Impulse-based
/// Dynamic Simulation of Rigid Body Systems, 1996, section 2.3), the others halved; a touch that
/// lasts less than a microsecond may be missed.
[[nodiscard]] std::optional<double> first_closing(const std::function<double(double)>& gap_at,
                                                  double speed, double now, double until);

}  // namespace carom::sim
