#include <algorithm>
#include <set>

#include <fmt/core.h>

#include "pipeline/plan/camera_ruler.h"
#include "pipeline/plan/colour_ramp.h"
#include "pipeline/plan/plan_drawing.h"
#include "pipeline/plan/quantity_text.h"

namespace carom::pipeline {

namespace {

constexpr double kText = 2.4;
constexpr double kLine = 5;
constexpr double kBall = 1.8;  // radius, mm
constexpr std::size_t kMostObjects = 6;

/// Places entries from left to right, line by line.
class Flow {
  public:
    explicit Flow(double y) : y_(y) {}

    /// Places an entry of the given width. Returns its left end, at the middle of the line.
    Vec2 next(double width) {
        if (x_ > kMargin && x_ + width > kPageWidth - kMargin) {
            x_ = kMargin;
            y_ += kLine;
        }
        const Vec2 at(x_, y_ + kLine / 2);
        x_ += width + 4;
        return at;
    }
    void new_line() {
        if (x_ > kMargin) {
            x_ = kMargin;
            y_ += kLine;
        }
    }
    [[nodiscard]] double bottom() const { return x_ > kMargin ? y_ + kLine : y_; }

  private:
    double x_ = kMargin;
    double y_ = 0;
};

void draw_text(SvgText& svg, const std::string& text, const Vec2& at) {
    svg.text(
        "text", text,
        {{"x", svg_number(at.x)}, {"y", svg_number(at.y + 0.85)}, {"style", "font-size:2.4px"}});
}

/// `left_out`: indices of objects.
void draw_balls(PlanDrawing& plan, const std::set<std::size_t>& left_out, Flow& flow) {
    std::size_t solids = 0;
    for (std::size_t i = 0; i < plan.objects.size(); ++i) {
        if (left_out.contains(i)) {
            continue;
        }
        const PlanObject& object = plan.objects[i];
        const std::string& name = object.track->name();
        if (!object.radius && ++solids > kMostObjects) {
            continue;
        }
        const Vec2 at = flow.next(2 * kBall + 1 + text_width(name, kText));
        if (object.radius) {
            draw_ball(plan.svg, object.paint, at + Vec2(kBall, 0), kBall);
        } else {
            plan.svg.leaf("rect", {{"class", "ball"},
                                   {"fill", object.paint.colour},
                                   {"x", svg_number(at.x + 0.6)},
                                   {"y", svg_number(at.y - 1.2)},
                                   {"width", "2.4"},
                                   {"height", "2.4"}});
        }
        draw_text(plan.svg, name, at + Vec2(2 * kBall + 1, 0));
    }
    if (solids > kMostObjects) {
        const std::string more = fmt::format("and {} more objects", solids - kMostObjects);
        draw_text(plan.svg, more, flow.next(text_width(more, kText)));
    }
}

void draw_line_style(PlanDrawing& plan, Flow& flow, const std::string& kind,
                     const std::string& text) {
    constexpr double kSample = 9;
    const Vec2 at = flow.next(kSample + 1.5 + text_width(text, kText));
    const std::string path = svg_path({at, at + Vec2(kSample, 0)}, false);
    if (kind != "moving") {
        plan.svg.leaf("path", {{"class", "casing " + kind}, {"d", path}});
    }
    plan.svg.leaf("path", {{"class", "path " + kind}, {"stroke", "#c8a24a"}, {"d", path}});
    draw_text(plan.svg, text, at + Vec2(kSample + 1.5, 0));
}

void draw_states(PlanDrawing& plan, Flow& flow) {
    ObjectPaint paint;
    paint.colour = "#c8a24a";
    const auto entry = [&](const std::string& text) {
        const Vec2 at = flow.next(2 * kBall + 1 + text_width(text, kText));
        draw_text(plan.svg, text, at + Vec2(2 * kBall + 1, 0));
        return at + Vec2(kBall, 0);
    };
    draw_ball(plan.svg, paint, entry("at the start"), kBall);
    const auto circle = [&](const char* name, const Vec2& centre, double radius) {
        return SvgText::Attributes{{"class", name},
                                   {"cx", svg_number(centre.x)},
                                   {"cy", svg_number(centre.y)},
                                   {"r", svg_number(radius)}};
    };
    auto ghost = circle("ghost", entry("at an impact"), kBall);
    ghost.emplace_back("fill", paint.colour);
    plan.svg.leaf("circle", ghost);
    const Vec2 end = entry("at the end, or potted");
    auto edge = circle("ring-edge", end, kBall - 0.3);
    edge.insert(edge.end(), {{"stroke-width", "1"}, {"fill", "none"}});
    plan.svg.leaf("circle", edge);
    auto ring = circle("ring cloth", end, kBall - 0.3);
    ring.emplace_back("stroke", paint.colour);
    plan.svg.leaf("circle", ring);
}

void draw_camera_entries(PlanDrawing& plan, Flow& flow) {
    const std::string camera = "a camera's path, and what it sees at both ends";
    const Vec2 at = flow.next(10 + text_width(camera, kText));
    plan.svg.leaf("path", {{"class", "cone"},
                           {"fill", rig_colour(0)},
                           {"stroke", rig_colour(0)},
                           {"d", svg_path({at, at + Vec2(8, -1.7), at + Vec2(8, 1.7)}, true)}});
    plan.svg.leaf("circle", {{"cx", svg_number(at.x)},
                             {"cy", svg_number(at.y)},
                             {"r", "0.9"},
                             {"fill", rig_colour(0)}});
    draw_text(plan.svg, camera, at + Vec2(9.5, 0));
    const std::optional<CameraRuler> ruler = camera_ruler(plan);
    if (!ruler) {
        return;
    }
    const std::string text = "where it is: a tick for " + frame_step_text(ruler->frame_step) +
                             ", an arrow the way it looks each " + time_text(ruler->time_step) +
                             " of the film";
    const Vec2 path = flow.next(10 + text_width(text, kText));
    std::string ticks = svg_path({path, path + Vec2(8, 0)}, false);
    for (int i = 0; i <= 8; ++i) {
        ticks += " " + svg_path({path + Vec2(i, -0.55), path + Vec2(i, 0.55)}, false);
    }
    plan.svg.leaf("path", {{"class", "tick"}, {"stroke", rig_colour(0)}, {"d", ticks}});
    plan.svg.leaf("path", {{"class", "view"},
                           {"stroke", rig_colour(0)},
                           {"d", svg_path({path + Vec2(4, 0), path + Vec2(6, -2)}, false)}});
    draw_text(plan.svg, text, path + Vec2(9.5, 0));
}

/// Draws a bar in the ramp's colours between the names of the first and the last object.
void draw_ramp(PlanDrawing& plan, const ColourRamp& ramp, Flow& flow) {
    constexpr double kBar = 24;
    constexpr int kSteps = 24;
    const std::string first = plan.objects[ramp.members.front()].track->name();
    const std::string last = plan.objects[ramp.members.back()].track->name();
    const double before = text_width(first, kText) + 1.6;
    const Vec2 at = flow.next(before + kBar + 1 + text_width(last, kText));
    draw_text(plan.svg, first, at);
    for (int i = 0; i < kSteps; ++i) {
        plan.svg.leaf("rect", {{"fill", ramp.colour_at(i / (kSteps - 1.0))},
                               {"x", svg_number(at.x + before + kBar * i / kSteps)},
                               {"y", svg_number(at.y - 0.9)},
                               {"width", svg_number(kBar / kSteps + 0.05)},
                               {"height", "1.8"}});
    }
    draw_text(plan.svg, last, at + Vec2(before + kBar + 1, 0));
}

bool has_motion(const PlanDrawing& plan, Motion motion) {
    return std::any_of(plan.objects.begin(), plan.objects.end(), [&](const PlanObject& object) {
        return std::any_of(object.motion.begin(), object.motion.end(),
                           [&](const MotionPhase& s) { return s.motion == motion; });
    });
}

}  // namespace

double draw_names(PlanDrawing& plan, std::span<const ColourRamp> ramps, double y) {
    Flow flow(y);
    std::set<std::size_t> in_ramps;
    for (const ColourRamp& ramp : ramps) {
        in_ramps.insert(ramp.members.begin(), ramp.members.end());
    }
    draw_balls(plan, in_ramps, flow);
    for (const ColourRamp& ramp : ramps) {
        draw_ramp(plan, ramp, flow);
    }
    return flow.bottom();
}

double draw_legend(PlanDrawing& plan, double y) {
    Flow flow(y);
    plan.svg.open("g", {{"id", "legend"}});
    draw_balls(plan, {}, flow);
    flow.new_line();
    draw_states(plan, flow);
    draw_line_style(plan, flow, "sliding", "sliding");
    draw_line_style(plan, flow, "rolling", "rolling");
    draw_line_style(plan, flow, "airborne", "airborne");
    if (has_motion(plan, Motion::moving)) {
        draw_line_style(plan, flow, "moving", "an object's centre");
    }
    if (!plan.rigs.empty()) {
        draw_camera_entries(plan, flow);
    }
    plan.svg.close();
    return flow.bottom();
}

}  // namespace carom::pipeline
