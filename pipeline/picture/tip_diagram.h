// A diagram of where the stick hits a ball.
#pragma once

#include <optional>

#include "pipeline/picture/annotation.h"
#include "pipeline/picture/canvas.h"
#include "sim/force_event.h"

namespace carom::pipeline {

/// Draws the ball as the shooter sees it, in a square of `size` pixels: a cross through its centre,
/// a dashed circle beyond which a tip slips off (sim/stick/strike.h), and the place of the tip in
/// `colour` (chalk blue if empty). A stick that is raised by at least a degree is a line at its
/// angle, seen from the side.
void draw_tip_diagram(cairo_t* context, const sim::Strike& strike,
                      const std::optional<Vec3>& colour, const Vec2& corner, double size);

}  // namespace carom::pipeline
