// Series of impacts that are worth one line, as of a brick that falls flat or a tile on its
// neighbour.
#pragma once

#include <cstddef>
#include <vector>

#include "pipeline/report/shot_report.h"

namespace carom::pipeline {

struct ImpactSeries {
    std::vector<std::size_t> events;  // their indices, increasing
    int count = 0;
    double last_time = 0;  // s
    double strongest = 0;  // N s
};

/// Four or more impacts of the same two, each within 0.1 s of the one before.
[[nodiscard]] std::vector<ImpactSeries> find_impact_series(
    const std::vector<ReportedEvent>& events);

}  // namespace carom::pipeline
