// A report as tables of at most 120 columns.
#pragma once

#include <string>

#include "pipeline/report/shot_report.h"

namespace carom::pipeline {

/// Events, objects and energy, one table each, with what the columns mean above them. A spin is
/// that after the event, about whatever axis. Names longer
/// than their column are shortened.
[[nodiscard]] std::string report_text(const ShotReport& report);

}  // namespace carom::pipeline
