// Prints a report as tables.
#pragma once

#include <string>

#include "pipeline/report/report_parts.h"
#include "pipeline/report/shot_report.h"

namespace carom::pipeline {

inline constexpr int kLeastReportColumns = 80;

struct ReportLook {
    ReportParts parts{};
    int columns = kLeastReportColumns;  // of the screen; more leave more room for names
    bool every_impact = false;          // else a series of impacts of the same two is one line
};

/// Tables of events, objects and energy, each with column headings. Spins are magnitudes after the
/// event. A name that is longer than its column has a line of its own.
[[nodiscard]] std::string report_text(const ShotReport& report, const ReportLook& look = {});

}  // namespace carom::pipeline
