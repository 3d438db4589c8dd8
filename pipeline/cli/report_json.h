// A report as one JSON object.
#pragma once

#include <string>

#include "pipeline/report/report_parts.h"
#include "pipeline/report/shot_report.h"

namespace carom::cli {

/// The members are start_time, end_time, largest_energy_rise, and of the parts that are shown
/// events, objects, moments, energy and energy_over_time (every sample), in SI units with all
/// digits. Members that an event does not have are omitted.
[[nodiscard]] std::string report_json(const pipeline::ShotReport& report,
                                      const pipeline::ReportParts& parts = {});

}  // namespace carom::cli
