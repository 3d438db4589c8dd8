// The report of a shot's motion.
#pragma once

#include "pipeline/report/shot_report.h"
#include "pipeline/shot/shot.h"
#include "sim/timeline/timeline.h"

namespace carom::pipeline {

/// report_of with the shot's moments, and without the cue stick, whose motion is drawn, not
/// simulated. `timeline` is that of a bake with the shot's keyed motions.
[[nodiscard]] ShotReport report_of_shot(const Shot& shot, const sim::Timeline& timeline);

}  // namespace carom::pipeline
