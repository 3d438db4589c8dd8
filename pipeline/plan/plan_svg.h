// The plan view of a shot, seen from above, as a coach would draw it.
#pragma once

#include <string>

#include "pipeline/plan/plan_colours.h"
#include "pipeline/plan/sheet.h"
#include "pipeline/shot/shot.h"
#include "pipeline/sound/film_levels.h"
#include "sim/timeline/timeline.h"

namespace carom::pipeline {

struct PlanOptions {
    PlanPage page = PlanPage::automatic;
    FilmLevels sound{};  // is drawn over the film's time unless it is empty
};

/// An SVG document, 297 mm wide and as high as necessary: the table to scale with balls, paths,
/// numbered events, sticks and cameras; time axes with the film's loudness; a legend; the list of
/// events. Invalid cameras are left out.
[[nodiscard]] std::string plan_svg(const Shot& shot, const sim::Timeline& timeline,
                                   const PlanOptions& options = {});

/// A part of a page: the table with its balls and their paths, without any text.
struct PlanSketch {
    std::string svg;
    Sheet sheet;
};

/// At most as large as `room` (mm), from `corner` on.
[[nodiscard]] PlanSketch plan_sketch(const Shot& shot, const sim::Timeline& timeline,
                                     const Vec2& corner, const Vec2& room);

/// A small SVG picture of the table with its balls and their paths, without any text, for lists of
/// shots.
[[nodiscard]] std::string sketch_svg(const Shot& shot, const sim::Timeline& timeline);

}  // namespace carom::pipeline
