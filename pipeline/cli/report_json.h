// A report as one JSON object.
#pragma once

#include <string>

#include "pipeline/report/shot_report.h"

namespace carom::cli {

/// Members start_time, end_time, largest_energy_rise, events, objects, energy and energy_over_time
/// (as often as it was measured), in SI units with
/// all digits; what an event does not have is left out.
[[nodiscard]] std::string report_json(const pipeline::ShotReport& report);

}  // namespace carom::cli
