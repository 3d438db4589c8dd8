#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "pipeline/plan/footprint.h"
#include "pipeline/plan/plan_drawing.h"
#include "pipeline/plan/quantity_text.h"

namespace carom::pipeline {

namespace {

constexpr double kGhostApart = 0.5;  // distance between two ghost balls, in radii
constexpr std::size_t kMostGhosts = 12;

std::string_view class_of(Motion motion) {
    switch (motion) {
        case Motion::sliding:
            return "sliding";
        case Motion::airborne:
            return "airborne";
        case Motion::moving:
            return "moving";
        default:
            return "rolling";
    }
}

std::vector<Vec2> on_paper(const Sheet& sheet, const std::vector<Vec2>& points) {
    std::vector<Vec2> result;
    result.reserve(points.size());
    for (const Vec2& point : points) {
        result.push_back(sheet.at(point));
    }
    return result;
}

SvgText::Attributes circle(std::string name, const Vec2& centre, double radius) {
    return {{"class", std::move(name)},
            {"cx", svg_number(centre.x)},
            {"cy", svg_number(centre.y)},
            {"r", svg_number(radius)}};
}

SvgText::Attributes with(SvgText::Attributes attributes, std::string_view name, std::string value) {
    attributes.emplace_back(name, std::move(value));
    return attributes;
}

void draw_path(PlanDrawing& plan, const PlanObject& object, const MotionPhase& phase) {
    const std::string kind(class_of(phase.motion));
    const std::string path = svg_path(on_paper(plan.sheet, phase.points), false);
    plan.svg.open("g");
    plan.svg.text("title", object.track->name() + ", " + kind + ", " + time_text(phase.from) +
                               " to " + time_text(phase.to));
    if (phase.motion != Motion::moving) {
        plan.svg.leaf("path", {{"class", "casing " + kind}, {"d", path}});
    }
    plan.svg.leaf("path",
                  {{"class", "path " + kind}, {"stroke", object.paint.colour}, {"d", path}});
    if (object.paint.is_striped && phase.motion != Motion::airborne) {
        plan.svg.leaf("path", {{"class", "stripe " + kind}, {"d", path}});
    }
    plan.svg.close();
}

/// The ball's positions at impacts ("ghost balls"), without repetitions.
std::vector<std::pair<double, Vec2>> ghosts_of(const PlanDrawing& plan, const PlanObject& object) {
    std::vector<std::pair<double, Vec2>> ghosts;
    const auto place = [&](double time) {
        const Vec3 p = object.track->sample(time).position;
        return Vec2(p.x, p.y);
    };
    const Vec2 start = place(plan.timeline.start_time);
    for (const sim::Event& event : plan.timeline.events) {
        const bool concerns = event.a == object.track->name() || event.b == object.track->name();
        const bool is_ground =
            sim::is_level(event.surface()) || event.surface() == sim::Surface::pocket;
        if (event.kind != sim::EventKind::impact || !concerns || is_ground ||
            event.time >= object.gone || ghosts.size() >= kMostGhosts) {
            continue;
        }
        const Vec2 at = place(event.time);
        const double apart = kGhostApart * *object.radius;
        const bool is_seen = (at - start).length() < apart ||
                             std::any_of(ghosts.begin(), ghosts.end(), [&](const auto& ghost) {
                                 return (ghost.second - at).length() < apart;
                             });
        if (!is_seen) {
            ghosts.emplace_back(event.time, at);
        }
    }
    return ghosts;
}

void draw_ghosts(PlanDrawing& plan, const PlanObject& object) {
    for (const auto& [time, place] : ghosts_of(plan, object)) {
        plan.svg.open("g");
        plan.svg.text("title", object.track->name() + " at " + time_text(time));
        plan.svg.leaf("circle",
                      with(circle("ghost", plan.sheet.at(place), plan.sheet.length(*object.radius)),
                           "fill", object.paint.colour));
        plan.svg.close();
    }
}

void keep_free(PlanDrawing& plan, const Vec2& centre, double radius) {
    plan.labels.keep_free({centre - Vec2(radius), centre + Vec2(radius)});
}

/// Keeps labels away from a path.
void keep_free(PlanDrawing& plan, const std::vector<Vec2>& points) {
    constexpr double kApart = 1.5;  // mm
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const Vec2 from = plan.sheet.at(points[i]);
        const Vec2 along = plan.sheet.at(points[i + 1]) - from;
        const int steps = 1 + static_cast<int>(along.length() / kApart);
        for (int step = 0; step < steps; ++step) {
            const Vec2 on = from + along * (static_cast<double>(step) / steps);
            plan.labels.keep_free({on - Vec2(0.6), on + Vec2(0.6)});
        }
    }
}

void draw_ball_at_end(PlanDrawing& plan, const PlanObject& object) {
    if (object.is_removed) {
        return;
    }
    const double time = std::min(object.gone, plan.timeline.end_time);
    const Vec2 centre = plan.sheet.at(object.track->sample(time).position);
    const double radius = plan.sheet.length(*object.radius);
    keep_free(plan, centre, radius);
    plan.svg.open("g");
    plan.svg.text("title", object.track->name() +
                               (object.gone < PlanObject::kNotGone ? ", potted at " : " at ") +
                               time_text(time));
    plan.svg.leaf("circle", with(circle("ring-edge", centre, radius - 0.3), "stroke-width", "1"));
    plan.svg.leaf("circle", with(with(circle("ring cloth", centre, radius - 0.3), "stroke",
                                      object.paint.colour),
                                 "fill-opacity", "0.85"));
    if (object.paint.number > 0) {
        plan.svg.text("text", fmt::format("{}", object.paint.number),
                      {{"class", "middle"},
                       {"x", svg_number(centre.x)},
                       {"y", svg_number(centre.y + 0.36 * radius)},
                       {"style", "font-size:" + svg_number(1.05 * radius) + "px"}});
    }
    plan.svg.close();
}

void draw_ball_at_start(PlanDrawing& plan, const PlanObject& object) {
    const Vec2 centre = plan.sheet.at(object.track->sample(plan.timeline.start_time).position);
    const double radius = plan.sheet.length(*object.radius);
    keep_free(plan, centre, radius);
    plan.svg.open("g");
    plan.svg.text("title", object.track->name() + " at the start");
    draw_ball(plan.svg, object.paint, centre, radius);
    plan.svg.close();
}

void draw_solid(PlanDrawing& plan, const PlanObject& object, bool is_end) {
    const double time = is_end ? plan.timeline.end_time : plan.timeline.start_time;
    const MotionState state = object.track->sample(time);
    const auto outline =
        on_paper(plan.sheet, footprint(object.body->shape, {state.position, state.orientation}));
    const std::string path = svg_path(outline, true);
    plan.svg.open("g");
    plan.svg.text("title", object.track->name() + (is_end ? " at the end" : " at the start"));
    if (is_end) {
        plan.svg.leaf("path", {{"class", "line"},
                               {"fill", object.paint.colour},
                               {"fill-opacity", "0.25"},
                               {"stroke-width", "0.12"},
                               {"stroke-opacity", "0.6"},
                               {"d", path}});
    } else {
        plan.svg.leaf("path", {{"class", "ball"}, {"fill", object.paint.colour}, {"d", path}});
    }
    plan.svg.close();
}

}  // namespace

void draw_ball(SvgText& svg, const ObjectPaint& paint, const Vec2& centre, double radius) {
    const std::string white = "#f4f1e8";
    svg.leaf("circle",
             with(circle("ball", centre, radius), "fill", paint.is_striped ? white : paint.colour));
    if (paint.is_striped) {  // a band across the middle, bounded by the ball's outline
        const double half = 0.6 * radius;
        const double x = std::sqrt(radius * radius - half * half);
        const std::string arc = "A" + svg_point({radius, radius}) + " 0 0 1 ";
        svg.leaf("path", {{"fill", paint.colour},
                          {"d", "M" + svg_point(centre + Vec2(-x, -half)) + " L" +
                                    svg_point(centre + Vec2(x, -half)) + " " + arc +
                                    svg_point(centre + Vec2(x, half)) + " L" +
                                    svg_point(centre + Vec2(-x, half)) + " " + arc +
                                    svg_point(centre + Vec2(-x, -half)) + " Z"}});
    }
    if (paint.number > 0) {
        svg.leaf("circle", with(circle("", centre, 0.56 * radius), "fill", white));
        svg.text("text", fmt::format("{}", paint.number),
                 {{"class", "middle"},
                  {"x", svg_number(centre.x)},
                  {"y", svg_number(centre.y + 0.3 * radius)},
                  {"style", "font-weight:bold;fill:#1c1f22;font-size:" +
                                svg_number((paint.number > 9 ? 0.72 : 0.86) * radius) + "px"}});
    }
}

void draw_paths(PlanDrawing& plan) {
    plan.svg.open("g", {{"class", "paths"}});
    for (const PlanObject& object : plan.objects) {
        for (const MotionPhase& phase : object.motion) {
            draw_path(plan, object, phase);
            keep_free(plan, phase.points);
        }
    }
    plan.svg.close();
}

void draw_objects(PlanDrawing& plan) {
    plan.svg.open("g", {{"class", "objects"}});
    for (const PlanObject& object : plan.objects) {
        if (object.radius && object.moves()) {
            draw_ghosts(plan, object);
        } else if (object.body != nullptr && object.moves()) {
            draw_solid(plan, object, true);
        }
    }
    for (const PlanObject& object : plan.objects) {
        if (object.radius && object.moves()) {
            draw_ball_at_end(plan, object);
        }
    }
    for (const PlanObject& object : plan.objects) {
        if (object.radius) {
            draw_ball_at_start(plan, object);
        } else if (object.body != nullptr) {
            draw_solid(plan, object, false);
        }
    }
    plan.svg.close();
}

}  // namespace carom::pipeline
