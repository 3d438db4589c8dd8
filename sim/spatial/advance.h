// Time of impact for gaps without a polynomial: conservative advancement.
#pragma once

#include <functional>
#include <optional>

namespace carom::sim {

/// Mirtich, Impulse-based Dynamic Simulation of Rigid Body Systems, 1996, section 2.3: no touch can
/// come before gap / speed, where `speed` bounds how fast the gap may close anywhere in the
/// window. Answers by the rules of time_of_impact.h, but within `kAdvanceDistance`.
inline constexpr double kAdvanceDistance = 1e-10;  // m

[[nodiscard]] std::optional<double> first_closing(const std::function<double(double)>& gap_at,
                                                  double speed, double now, double until);

}  // namespace carom::sim
