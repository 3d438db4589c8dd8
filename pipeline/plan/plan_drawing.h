// The parts of a plan; each is drawn by its own function.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pipeline/plan/colour_ramp.h"
#include "pipeline/plan/label_placer.h"
#include "pipeline/plan/motion_phases.h"
#include "pipeline/plan/numbered_events.h"
#include "pipeline/plan/plan_colours.h"
#include "pipeline/plan/sheet.h"
#include "pipeline/plan/svg_text.h"
#include "pipeline/shot/shot.h"
#include "pipeline/sound/film_levels.h"
#include "render/camera/camera_state.h"
#include "sim/billiards/layout.h"
#include "sim/timeline/timeline.h"

namespace carom::pipeline {

inline constexpr double kPageWidth = 297;  // mm, A4 landscape
inline constexpr double kMargin = 10;
inline constexpr std::size_t kMostNumbers = 30;  // of events

/// An object that has a track.
struct PlanObject {
    const sim::Body* body = nullptr;  // nullptr if the bake belongs to another world
    const sim::Track* track = nullptr;
    std::optional<double> radius;  // of a ball
    ObjectPaint paint;
    std::vector<MotionPhase> motion;
    static constexpr double kNotGone = 1e300;
    double gone = kNotGone;   // time at which it was potted or taken off for good, s
    bool is_removed = false;  // taken off: after that it is out of sight
    [[nodiscard]] bool moves() const { return !motion.empty(); }
};

/// A rig's camera, sampled at evenly spaced instants of its part of the film.
struct PlanRig {
    const CameraRig* rig = nullptr;
    std::string colour;
    std::vector<render::CameraState> states;
    double slowest = 1, fastest = 1;  // seconds of the scene per second of film
};

/// Shared data of all parts. Only `svg` and `labels` change while drawing.
struct PlanDrawing {
    const Shot& shot;
    const sim::Timeline& timeline;
    std::optional<sim::billiards::TableLayout> table;
    std::vector<PlanObject> objects;
    std::vector<PlanRig> rigs;
    NumberedEvents events;
    Sheet sheet;
    LabelPlacer labels;
    SvgText svg;
    FilmLevels sound{};  // of the film; empty: not drawn
};

/// The objects of all tracks, in order.
[[nodiscard]] std::vector<PlanObject> plan_objects(const Shot& shot, const sim::Timeline& timeline);

/// A complete SVG document around the drawn elements, `height` mm high.
[[nodiscard]] std::string svg_page(const std::string& body, const std::string& title, PlanPage page,
                                   double height);

void draw_table(PlanDrawing& plan);
void draw_scenery(PlanDrawing& plan);
void draw_cameras(PlanDrawing& plan);
void draw_paths(PlanDrawing& plan);
/// Draws objects at the start, at impacts and at the end.
void draw_objects(PlanDrawing& plan);
void draw_sticks(PlanDrawing& plan);
void draw_event_numbers(PlanDrawing& plan);

/// These parts begin at `y` (mm) and return the y at which the next part may begin.
[[nodiscard]] double draw_time_axes(PlanDrawing& plan, double y);
[[nodiscard]] double draw_legend(PlanDrawing& plan, double y);
/// Draws the names of all objects with their colours; `ramps` hold indices of objects.
[[nodiscard]] double draw_names(PlanDrawing& plan, std::span<const ColourRamp> ramps, double y);
[[nodiscard]] double draw_event_list(PlanDrawing& plan, double y);
/// Lists the values that are moments with their times; nothing if there are none.
[[nodiscard]] double draw_moment_list(PlanDrawing& plan, double y);

/// Draws a ball on the paper with its colour, stripe and number.
void draw_ball(SvgText& svg, const ObjectPaint& paint, const Vec2& centre, double radius);

/// The approximate width of a text in the plan's font, mm.
[[nodiscard]] double text_width(const std::string& text, double font_size);

/// The text, shortened with an ellipsis if it is wider than `width`.
[[nodiscard]] std::string fitted_text(const std::string& text, double font_size, double width);

}  // namespace carom::pipeline
