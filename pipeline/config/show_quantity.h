// Formats numbers with units for people.
#pragma once

#include <string>

#include "pipeline/config/units.h"

namespace carom::pipeline::config {

/// "9.81 m/s^2", "30 deg": the shortest decimal that reads back as the same number of the shown
/// unit.
[[nodiscard]] std::string show(double value, Dimension dimension);

/// The shortest decimal that reads back as the same number.
[[nodiscard]] std::string show(double value);

}  // namespace carom::pipeline::config
