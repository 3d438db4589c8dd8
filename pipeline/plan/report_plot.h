// A plot of speed, energy and loudness over time.
#pragma once

#include <string>

#include "pipeline/plan/plan_colours.h"
#include "pipeline/shot/shot.h"
#include "pipeline/sound/film_levels.h"
#include "sim/timeline/timeline.h"

namespace carom::pipeline {

/// An SVG document, 297 mm wide: the speed of every object that moves, in the colours and with the
/// event numbers of the plan, on a square-root scale (a break begins at 10 m/s and ends at 1 cm/s);
/// below it the energy; then, over the film's own time, how loud it is, unless `sound` is empty;
/// then the list of events.
[[nodiscard]] std::string report_plot_svg(const Shot& shot, const sim::Timeline& timeline,
                                          PlanPage page = PlanPage::automatic,
                                          const FilmLevels& sound = {});

}  // namespace carom::pipeline
