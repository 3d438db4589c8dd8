// Time of impact for gaps that are not polynomials of time.
#pragma once

#include <functional>
#include <optional>

namespace carom::sim {

/// The time at which a gap that never closes faster than `speed` (m/s) first closes
/// (kClosedBySearch) in [now, until], by the rules of time_of_impact.h. Intervals that are too
/// short for the gap to close and open again are skipped (the bound of conservative advancement:
/// Mirtich, Impulse-based Dynamic Simulation of Rigid Body Systems, 1996, section 2.3), the others
/// are halved. A contact that lasts less than a microsecond may be missed.
[[nodiscard]] std::optional<double> first_closing(const std::function<double(double)>& gap_at,
                                                  double speed, double now, double until);

}  // namespace carom::sim
