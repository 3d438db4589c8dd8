// Draws the axis of video time with the camera of each interval, and the axis of scene time with
// the events and the interval that each camera shows.
#include <algorithm>
#include <array>
#include <cmath>

#include "pipeline/camera/time_map.h"
#include "pipeline/plan/loudness_curve.h"
#include "pipeline/plan/plan_drawing.h"
#include "pipeline/plan/quantity_text.h"
#include "pipeline/plan/time_axis.h"

namespace carom::pipeline {

namespace {

constexpr double kBar = 4.4;
constexpr double kText = 2.4;
constexpr double kLoudness = 7;  // height of full scale

std::string fraction_text(double speed) {
    const double size = std::abs(speed);
    const double whole = std::round(1 / std::max(size, 1e-9));
    if (size < 0.999 && size > 0.005 && std::abs(whole * size - 1) < 5e-3) {
        return "1/" + svg_number(whole) + "×";
    }
    return svg_number(size) + "×";
}

/// "1/8×", "backwards 1×", "frozen", "1/8× to 1×"
std::string speed_range_text(const PlanRig& rig) {
    if (std::abs(rig.slowest) < 1e-9 && std::abs(rig.fastest) < 1e-9) {
        return "frozen";
    }
    const std::string back = rig.fastest <= 0 ? "backwards " : "";
    if (std::abs(rig.fastest - rig.slowest) < 1e-6) {
        return back + fraction_text(rig.fastest);
    }
    if (rig.slowest < 0 && rig.fastest > 0) {
        return fraction_text(rig.fastest) + " to backwards " + fraction_text(rig.slowest);
    }
    return back + fraction_text(rig.slowest) + " to " + fraction_text(rig.fastest);
}

void draw_bar(SvgText& svg, double from, double to, double y, const std::string& colour) {
    svg.leaf("rect", {{"class", "bar"},
                      {"x", svg_number(from)},
                      {"y", svg_number(y)},
                      {"width", svg_number(std::max(to - from, 0.3))},
                      {"height", svg_number(kBar)},
                      {"fill", colour},
                      {"stroke", colour}});
}

/// Writes the text inside the bar if it fits, otherwise after it, or before it at the right end of
/// the page.
void draw_bar_text(SvgText& svg, const std::string& text, double from, double to, double y) {
    const double width = text_width(text, kText);
    double x = from + 1;
    if (width + 2 > to - from) {
        x = to + 1.5 + width < kPageWidth - kMargin ? to + 1.5 : from - 1.5 - width;
    }
    svg.text("text", text,
             {{"x", svg_number(std::max(x, kMargin))},
              {"y", svg_number(y + 3.05)},
              {"style", "font-size:2.4px"}});
}

TimeAxis film_axis(const PlanDrawing& plan) {
    TimeAxis axis;
    for (const PlanRig& rig : plan.rigs) {
        axis.to = &rig == &plan.rigs.front() ? rig.rig->video_end.to_double()
                                             : std::max(axis.to, rig.rig->video_end.to_double());
    }
    return axis;
}

/// How loud the film is, above the bars of its cameras.
void draw_loudness(PlanDrawing& plan, double y) {
    const double bottom = y + kLoudness;
    const std::vector<Vec2> curve = loudness_curve(plan.sound, film_axis(plan), y, bottom);
    plan.svg.open("g", {{"id", "loudness"}});
    plan.svg.text("text", "sound",
                  {{"class", "small"}, {"x", svg_number(kMargin)}, {"y", svg_number(bottom)}});
    plan.svg.leaf("path", {{"class", "area"}, {"d", svg_path(area_below(curve, bottom), true)}});
    plan.svg.leaf("path", {{"class", "line"},
                           {"fill", "none"},
                           {"stroke-width", "0.15"},
                           {"d", svg_path(curve, false)}});
    plan.svg.close();
}

void draw_film(PlanDrawing& plan, double y) {
    const TimeAxis axis = film_axis(plan);
    for (std::size_t i = 0; i < plan.rigs.size(); ++i) {
        const PlanRig& rig = plan.rigs[i];
        const double from = axis.at(rig.rig->video_start.to_double());
        const double to = axis.at(rig.rig->video_end.to_double());
        draw_bar(plan.svg, from, to, y, rig.colour);
        plan.svg.text("text", fitted_text(rig.rig->name, kText, to - from - 1.5),
                      {{"x", svg_number(from + 1)},
                       {"y", svg_number(y + 3.05)},
                       {"style", "font-size:2.4px;font-weight:bold"}});
    }
    draw_time_axis(plan.svg, axis, y + kBar + 0.6, "film");
}

void draw_shown(PlanDrawing& plan, const TimeAxis& axis, const PlanRig& rig, double y) {
    const SceneTimeRange shown = shown_scene_times(*rig.rig);
    const double from = std::clamp(axis.at(shown.first.to_double()), kAxisLeft, kAxisRight);
    const double to = std::clamp(axis.at(shown.last.to_double()), kAxisLeft, kAxisRight);
    draw_bar(plan.svg, from, to, y, rig.colour);
    const bool is_backwards = rig.fastest <= 0 && rig.slowest < 0;
    const double tip = is_backwards ? from : to;
    const double side = is_backwards ? 1 : -1;
    plan.svg.leaf("path", {{"fill", rig.colour},
                           {"d", svg_path({{tip, y + kBar / 2},
                                           {tip + side * 1.6, y + 0.6},
                                           {tip + side * 1.6, y + kBar - 0.6}},
                                          true)}});
    const std::string first = time_text(shown.first.to_double());
    const std::string last = time_text(shown.last.to_double());
    const std::string interval = shown.is_frozen() ? "at " + first
                                 : is_backwards    ? last + " to " + first
                                                   : first + " to " + last;
    draw_bar_text(plan.svg, rig.rig->name + ": " + interval + ", " + speed_range_text(rig),
                  from + (is_backwards ? 2 : 0), to, y);
}

}  // namespace

double draw_time_axes(PlanDrawing& plan, double y) {
    plan.svg.open("g", {{"id", "times"}});
    if (!plan.rigs.empty()) {
        if (!plan.sound.decibels.empty()) {
            draw_loudness(plan, y);
            y += kLoudness + 0.8;
        }
        draw_film(plan, y);
        y += 11.5;
    }
    const TimeAxis axis{plan.timeline.start_time, plan.timeline.end_time};
    const double line = draw_event_marks(plan.svg, axis, plan.events.events, y);
    draw_time_axis(plan.svg, axis, line, "scene");
    y = line + 5;
    for (const PlanRig& rig : plan.rigs) {
        draw_shown(plan, axis, rig, y);
        y += kBar + 0.8;
    }
    plan.svg.close();
    return y;
}

}  // namespace carom::pipeline
