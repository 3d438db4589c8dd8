// The parts of a plan, each drawn by a function of its own.
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
#include "render/camera/camera_state.h"
#include "sim/billiards/layout.h"
#include "sim/timeline/timeline.h"

namespace carom::pipeline {

inline constexpr double kPageWidth = 297;  // mm, A4 on its side
inline constexpr double kMargin = 10;
inline constexpr std::size_t kMostNumbers = 30;  // of events

/// An object that has a track.
struct PlanObject {
    const sim::Body* body = nullptr;  // of a bake whose world is another: none
    const sim::Track* track = nullptr;
    std::optional<double> radius;  // of a ball
    ObjectPaint paint;
    std::vector<MotionPhase> motion;
    double gone = 1e300;  // when it was potted, s
    [[nodiscard]] bool moves() const { return !motion.empty(); }
};

/// A rig's camera at some instants of its stretch, evenly.
struct PlanRig {
    const CameraRig* rig = nullptr;
    std::string colour;
    std::vector<render::CameraState> states;
    double slowest = 1, fastest = 1;  // seconds of the scene per second of film
};

/// What all parts know. Only `svg` and `labels` change while drawing.
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
};

/// Of every track, in order.
[[nodiscard]] std::vector<PlanObject> plan_objects(const Shot& shot, const sim::Timeline& timeline);

/// A whole document round what was drawn, `height` mm high.
[[nodiscard]] std::string svg_page(const std::string& body, const std::string& title, PlanPage page,
                                   double height);

void draw_table(PlanDrawing& plan);
void draw_scenery(PlanDrawing& plan);
void draw_cameras(PlanDrawing& plan);
void draw_paths(PlanDrawing& plan);
/// At the start, at impacts, at the end.
void draw_objects(PlanDrawing& plan);
void draw_sticks(PlanDrawing& plan);
void draw_event_numbers(PlanDrawing& plan);

/// These begin at `y` (mm) and return where the next part may.
[[nodiscard]] double draw_time_axes(PlanDrawing& plan, double y);
[[nodiscard]] double draw_legend(PlanDrawing& plan, double y);
/// The names of all objects with their colours; `ramps` refer to places among them.
[[nodiscard]] double draw_names(PlanDrawing& plan, std::span<const ColourRamp> ramps, double y);
[[nodiscard]] double draw_event_list(PlanDrawing& plan, double y);

/// A ball's face at a place on the paper: its colour, stripe and number.
void draw_ball(SvgText& svg, const ObjectPaint& paint, const Vec2& centre, double radius);

/// About how wide a text of our font is, mm.
[[nodiscard]] double text_width(const std::string& text, double font_size);

/// The text, shortened with an ellipsis where it would be wider.
[[nodiscard]] std::string fitted_text(const std::string& text, double font_size, double width);

}  // namespace carom::pipeline
