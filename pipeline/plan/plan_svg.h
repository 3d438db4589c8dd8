// A shot from above, as a coach would draw it.
#pragma once

#include <string>

#include "pipeline/plan/plan_colours.h"
#include "pipeline/shot/shot.h"
#include "sim/timeline/timeline.h"

namespace carom::pipeline {

struct PlanOptions {
    PlanPage page = PlanPage::automatic;
};

/// An SVG document, 297 mm wide and as high as it needs: the table to scale with balls, paths,
/// numbered events, sticks and cameras; time axes; a legend; the list of events. A camera whose
/// values make no picture is left out.
[[nodiscard]] std::string plan_svg(const Shot& shot, const sim::Timeline& timeline,
                                   const PlanOptions& options = {});

}  // namespace carom::pipeline
