#include "pipeline/plan/plan_svg.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "pipeline/camera/exposure.h"
#include "pipeline/camera/path_fit.h"
#include "pipeline/camera/rig_state.h"
#include "pipeline/camera/time_map.h"
#include "pipeline/plan/footprint.h"
#include "pipeline/plan/plan_drawing.h"
#include "pipeline/plan/quantity_text.h"

namespace carom::pipeline {

namespace {

constexpr double kTop = 19;               // of the drawing, mm
constexpr double kHighest = 155;          // of the drawing, mm
constexpr double kFarthestCamera = 0.45;  // beyond the table's edge, m
constexpr double kEdge = 0.06;            // around the drawn scene, m
constexpr int kCameraSteps = 48;

constexpr double kStandardRadius = 0.028575;  // m, for shots without balls

double ball_radius(const Shot& shot) {
    for (const sim::Body& body : shot.world.bodies) {
        if (const auto* sphere = std::get_if<sim::Sphere>(&body.shape)) {
            return sphere->radius;
        }
    }
    return kStandardRadius;
}

/// `states` is empty if the rig is invalid at some instant; 'carom check' reports the reason.
PlanRig rig_of(const CameraRig& rig, std::size_t index, const sim::Timeline& timeline) {
    PlanRig result;
    result.rig = &rig;
    result.colour = rig_colour(index);
    result.slowest = 1e300;
    result.fastest = -1e300;
    const double start = rig.video_start.to_double();
    const double length = rig.video_end.to_double() - start;
    try {
        for (int i = 0; i <= kCameraSteps; ++i) {
            const WideRational time(Rational::nearest(start + length * i / kCameraSteps));
            const double speed = speed_at(rig, time).to_double();
            result.slowest = std::min(result.slowest, speed);
            result.fastest = std::max(result.fastest, speed);
            result.states.push_back(camera_state(
                rig, {progress_at(rig, time), scene_time_at(rig, time).to_double()}, timeline));
        }
    } catch (const Error&) {
        result.states.clear();
    }
    return result;
}

struct Extent {
    Vec2 low{1e300, 1e300}, high{-1e300, -1e300};

    void include(const Vec2& point) {
        low = {std::min(low.x, point.x), std::min(low.y, point.y)};
        high = {std::max(high.x, point.x), std::max(high.y, point.y)};
    }
    [[nodiscard]] bool is_empty() const { return low.x > high.x; }
};

/// The extent of the table or, without a table, of all moving objects, and of the cameras near it.
Extent extent_of(const PlanDrawing& plan) {
    Extent extent;
    if (plan.table) {
        extent.include(plan.table->outer);
        extent.include(-plan.table->outer);
    } else {
        for (const PlanObject& object : plan.objects) {
            const Vec3 start = object.track->sample(plan.timeline.start_time).position;
            const double reach = 3 * object.radius.value_or(0.05);
            extent.include(Vec2(start.x, start.y) - Vec2(reach));
            extent.include(Vec2(start.x, start.y) + Vec2(reach));
            for (const MotionPhase& phase : object.motion) {
                for (const Vec2& point : phase.points) {
                    extent.include(point - Vec2(reach));
                    extent.include(point + Vec2(reach));
                }
            }
        }
    }
    if (extent.is_empty()) {
        extent = {{-0.5, -0.5}, {0.5, 0.5}};
    }
    const Extent inner = extent;
    for (const PlanRig& rig : plan.rigs) {
        for (const render::CameraState& state : rig.states) {
            extent.include({std::clamp(state.position.x, inner.low.x - kFarthestCamera,
                                       inner.high.x + kFarthestCamera),
                            std::clamp(state.position.y, inner.low.y - kFarthestCamera,
                                       inner.high.y + kFarthestCamera)});
        }
    }
    extent.low -= Vec2(kEdge);
    extent.high += Vec2(kEdge);
    return extent;
}

void draw_title(PlanDrawing& plan, const std::string& name) {
    plan.svg.text("text", name, {{"class", "title"}, {"x", svg_number(kMargin)}, {"y", "13"}});
    const std::string facts =
        time_text(plan.timeline.end_time - plan.timeline.start_time) +
        " simulated · seen from above · 1:" + svg_number(plan.sheet.denominator) + " on A4";
    plan.svg.text("text", facts,
                  {{"class", "end faint"}, {"x", svg_number(kPageWidth - kMargin)}, {"y", "13"}});
}

/// Draws a scale bar for a round length of about 30 mm on paper.
void draw_scale_bar(PlanDrawing& plan, double y) {
    const double wanted = 0.03 * plan.sheet.denominator;  // m
    const double decade = std::pow(10, std::floor(std::log10(wanted)));
    const double fraction = wanted / decade;
    const double metres = decade * (fraction >= 5 ? 5 : fraction >= 2 ? 2 : 1);
    const double right = kPageWidth - kMargin;
    const double left = right - plan.sheet.length(metres);
    plan.svg.leaf("path",
                  {{"class", "line"},
                   {"stroke-width", "0.3"},
                   {"fill", "none"},
                   {"d", svg_path({{left, y - 1}, {left, y}, {right, y}, {right, y - 1}}, false)}});
    plan.svg.text("text", metres < 1 ? svg_number(100 * metres) + " cm" : svg_number(metres) + " m",
                  {{"class", "small middle"},
                   {"x", svg_number((left + right) / 2)},
                   {"y", svg_number(y - 1)}});
}

/// Draws everything that is to scale, clipped at the drawing's edge.
void draw_scene(PlanDrawing& plan) {
    const Vec2 size = plan.sheet.size();
    plan.svg.open("clipPath", {{"id", "sheet"}});
    plan.svg.leaf("rect", {{"x", svg_number(kMargin)},
                           {"y", svg_number(plan.sheet.corner.y)},
                           {"width", svg_number(kPageWidth - 2 * kMargin)},
                           {"height", svg_number(size.y)}});
    plan.svg.close();
    plan.svg.open("g", {{"clip-path", "url(#sheet)"}});
    draw_table(plan);
    draw_scenery(plan);
    // Number positions are reserved first; labels are placed when all other elements are known.
    draw_sticks(plan);
    draw_paths(plan);
    draw_objects(plan);
    draw_cameras(plan);
    draw_event_numbers(plan);
    plan.svg.close();
}

PlanDrawing begin_plan(const Shot& shot, const sim::Timeline& timeline) {
    PlanDrawing plan{shot,
                     timeline,
                     {},
                     plan_objects(shot, timeline),
                     {},
                     {},
                     {},
                     LabelPlacer({}),
                     SvgText(SvgText::Kind::fragment)};
    if (shot.world.table && shot.world.table->has_cushions) {
        plan.table = sim::billiards::make_layout(*shot.world.table, ball_radius(shot));
    }
    return plan;
}

}  // namespace

std::string plan_svg(const Shot& shot, const sim::Timeline& timeline, const PlanOptions& options) {
    PlanDrawing plan = begin_plan(shot, timeline);
    const std::vector<CameraRig> rigs = with_fitted_paths(shot.cameras, timeline);
    for (const CameraRig& rig : rigs) {
        PlanRig seen = rig_of(rig, plan.rigs.size(), timeline);
        if (!seen.states.empty()) {
            plan.rigs.push_back(std::move(seen));
        }
    }
    plan.events = number_events(shot, timeline, kMostNumbers);
    plan.sound = options.sound;
    const Extent extent = extent_of(plan);
    plan.sheet = make_sheet(extent.low, extent.high, {kPageWidth - 2 * kMargin, kHighest});
    const Vec2 size = plan.sheet.size();
    plan.sheet.corner = {(kPageWidth - size.x) / 2, kTop};
    plan.labels = LabelPlacer({{kMargin, kTop}, {kPageWidth - kMargin, kTop + size.y}});

    draw_title(plan, shot.name);
    draw_scene(plan);
    double y = kTop + size.y + 2;
    draw_scale_bar(plan, y + 2);
    y = draw_legend(plan, y + 2) + 4;
    y = draw_time_axes(plan, y) + 4;
    y = draw_event_list(plan, y) + 6;
    if (!shot.moments.empty()) {
        y = draw_moment_list(plan, y - 2) + 4;
    }
    return svg_page(plan.svg.finish(), shot.name + " from above", options.page, y);
}

PlanSketch plan_sketch(const Shot& shot, const sim::Timeline& timeline, const Vec2& corner,
                       const Vec2& room) {
    PlanDrawing plan = begin_plan(shot, timeline);
    const Extent extent = extent_of(plan);
    plan.sheet = make_sheet(extent.low, extent.high, room);
    plan.sheet.corner = corner;
    plan.labels = LabelPlacer({corner, corner + plan.sheet.size()});
    draw_table(plan);
    draw_scenery(plan);
    draw_paths(plan);
    draw_objects(plan);
    return {plan.svg.finish(), plan.sheet};
}

std::string sketch_svg(const Shot& shot, const sim::Timeline& timeline) {
    const PlanSketch plan = plan_sketch(shot, timeline, {0, 0}, {kPageWidth, kPageWidth});
    const Vec2 size = plan.sheet.size();
    SvgText svg;
    svg.open("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                     {"viewBox", "0 0 " + svg_number(size.x) + " " + svg_number(size.y)}});
    svg.text("style", plan_style(PlanPage::dark));
    svg.raw(plan.svg);
    svg.close();
    return svg.finish();
}

}  // namespace carom::pipeline
