// The film's time with who films it, the scene's time with what happens, and which part of it each
// rig shows.
#include <algorithm>
#include <array>
#include <cmath>

#include "pipeline/camera/time_map.h"
#include "pipeline/plan/plan_drawing.h"

namespace carom::pipeline {

namespace {

constexpr double kLeft = kMargin + 16;  // where time 0 is, mm; its axis' name is before it
constexpr double kRight = kPageWidth - kMargin - 4;
constexpr double kBar = 4.4;
constexpr double kText = 2.4;
constexpr double kBadge = 1.5;  // radius of an event's number
constexpr int kMostRows = 3;    // of numbers above each other

struct Axis {
    double from = 0, to = 1;  // s

    [[nodiscard]] double at(double time) const {
        return kLeft + (kRight - kLeft) * (time - from) / std::max(to - from, 1e-9);
    }
};

/// 1, 2 or 5 times a power of ten, at most twelve to the axis.
double tick_step(double duration) {
    const double least = duration / 12;
    const double decade = std::pow(10, std::floor(std::log10(std::max(least, 1e-6))));
    for (const double step : {1.0, 2.0, 5.0}) {
        if (step * decade >= least) {
            return step * decade;
        }
    }
    return 10 * decade;
}

void draw_axis(SvgText& svg, const Axis& axis, double y, const std::string& name) {
    svg.text("text", name,
             {{"class", "head"}, {"x", svg_number(kMargin)}, {"y", svg_number(y + 0.9)}});
    svg.leaf("path", {{"class", "fine"}, {"d", svg_path({{kLeft, y}, {kRight, y}}, false)}});
    const double step = tick_step(axis.to - axis.from);
    for (int i = 0; i * step <= (axis.to - axis.from) * (1 + 1e-9); ++i) {
        const double x = axis.at(axis.from + i * step);
        svg.leaf("path", {{"class", "fine"}, {"d", svg_path({{x, y}, {x, y + 1}}, false)}});
        svg.text(
            "text", time_text(axis.from + i * step),
            {{"class", "small faint middle"}, {"x", svg_number(x)}, {"y", svg_number(y + 3.3)}});
    }
}

std::string share_text(double speed) {
    const double size = std::abs(speed);
    const double whole = std::round(1 / std::max(size, 1e-9));
    if (size < 0.999 && size > 0.005 && std::abs(whole * size - 1) < 5e-3) {
        return "1/" + svg_number(whole) + "×";
    }
    return svg_number(size) + "×";
}

/// "1/8×", "backwards 1×", "frozen", "1/8× to 1×"
std::string pace_text(const PlanRig& rig) {
    if (std::abs(rig.slowest) < 1e-9 && std::abs(rig.fastest) < 1e-9) {
        return "frozen";
    }
    const std::string back = rig.fastest <= 0 ? "backwards " : "";
    if (std::abs(rig.fastest - rig.slowest) < 1e-6) {
        return back + share_text(rig.fastest);
    }
    if (rig.slowest < 0 && rig.fastest > 0) {
        return share_text(rig.fastest) + " to backwards " + share_text(rig.slowest);
    }
    return back + share_text(rig.slowest) + " to " + share_text(rig.fastest);
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

/// Inside the bar if it fits, else behind it, or before it at the page's end.
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

void draw_film(PlanDrawing& plan, double y) {
    Axis axis;
    for (const PlanRig& rig : plan.rigs) {
        axis.to = &rig == &plan.rigs.front() ? rig.rig->video_end.to_double()
                                             : std::max(axis.to, rig.rig->video_end.to_double());
    }
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
    draw_axis(plan.svg, axis, y + kBar + 0.6, "film");
}

/// Numbers that would lie on each other go into rows; those beyond the last row stay a tick.
std::vector<int> rows_of(const std::vector<NumberedEvent>& events, const Axis& axis) {
    std::array<double, kMostRows> taken{};
    std::vector<int> rows;
    for (const NumberedEvent& event : events) {
        const double x = axis.at(event.time);
        std::size_t row = 0;
        while (row < taken.size() && taken.at(row) > x - 2 * kBadge) {
            ++row;
        }
        if (row < taken.size()) {
            taken.at(row) = x;
        }
        rows.push_back(static_cast<int>(row));
    }
    return rows;
}

void draw_mark(SvgText& svg, const NumberedEvent& event, double x, double y, int row) {
    const bool has_room = row < kMostRows;
    const double top = has_room ? y - 1.2 - 2 * kBadge * (row + 0.5) : y - 1.2;
    svg.leaf("path", {{"class", "fine"}, {"d", svg_path({{x, y}, {x, top}}, false)}});
    if (!has_room) {
        return;
    }
    svg.leaf("circle", {{"class", "badge"},
                        {"cx", svg_number(x)},
                        {"cy", svg_number(top)},
                        {"r", svg_number(kBadge)}});
    svg.text("text", std::to_string(event.number),
             {{"class", "number"},
              {"x", svg_number(x)},
              {"y", svg_number(top + 0.66)},
              {"style", "font-size:1.8px"}});
}

void draw_shown(PlanDrawing& plan, const Axis& axis, const PlanRig& rig, double y) {
    const SceneStretch shown = shown_scene_times(*rig.rig);
    const double from = std::clamp(axis.at(shown.first.to_double()), kLeft, kRight);
    const double to = std::clamp(axis.at(shown.last.to_double()), kLeft, kRight);
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
    const std::string stretch = shown.is_frozen() ? "at " + first
                                : is_backwards    ? last + " to " + first
                                                  : first + " to " + last;
    draw_bar_text(plan.svg, rig.rig->name + ": " + stretch + ", " + pace_text(rig),
                  from + (is_backwards ? 2 : 0), to, y);
}

}  // namespace

double draw_time_axes(PlanDrawing& plan, double y) {
    plan.svg.open("g", {{"id", "times"}});
    if (!plan.rigs.empty()) {
        draw_film(plan, y);
        y += 11.5;
    }
    const Axis axis{plan.timeline.start_time, plan.timeline.end_time};
    const std::vector<int> rows = rows_of(plan.events.events, axis);
    const int highest = rows.empty() ? 0 : *std::max_element(rows.begin(), rows.end());
    const double line = y + 1.4 + 2 * kBadge * std::min(highest + 1, kMostRows);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        draw_mark(plan.svg, plan.events.events[i], axis.at(plan.events.events[i].time), line,
                  rows[i]);
    }
    draw_axis(plan.svg, axis, line, "scene");
    y = line + 5;
    for (const PlanRig& rig : plan.rigs) {
        draw_shown(plan, axis, rig, y);
        y += kBar + 0.8;
    }
    plan.svg.close();
    return y;
}

}  // namespace carom::pipeline
