// A report as one JSON object.
#pragma once

#include <string>
#include <vector>

#include "pipeline/report/shot_report.h"

namespace carom::cli {

/// The members are start_time, end_time, largest_energy_rise, events, objects, energy and
/// energy_over_time (every sample), in SI units with all digits. Members that an event does not
/// have are omitted.
///
/// `heard_at`: for each event of the report the film times (s) at which its impact or strike is
/// heard (heard_times). These events have a member of this name, which may be an empty list. An
/// empty vector: no event has it.
[[nodiscard]] std::string report_json(const pipeline::ShotReport& report,
                                      const std::vector<std::vector<double>>& heard_at = {});

}  // namespace carom::cli
