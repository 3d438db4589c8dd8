// Prints a report as tables of at most 120 columns.
#pragma once

#include <string>

#include "pipeline/report/shot_report.h"

namespace carom::pipeline {

/// Tables of events, objects and energy, each with column headings. Spins are magnitudes after the
/// event. Names that are longer than their column are shortened.
[[nodiscard]] std::string report_text(const ShotReport& report);

}  // namespace carom::pipeline
