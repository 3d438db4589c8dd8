#include "pipeline/picture/small_plan.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "pipeline/picture/colours.h"
#include "pipeline/picture/track_line.h"
#include "pipeline/plan/plan_colours.h"
#include "sim/billiards/parts.h"

namespace carom::pipeline {
namespace {

constexpr double kStandardRadius = 0.028575;  // m, for tables without balls
constexpr double kPathWidth = 0.016;          // m
constexpr double kShownRadius = 1.35;         // of a ball, in radii: balls are small on a plan
constexpr double kEdge = 0.12;                // around a cloth without cushions, m

constexpr std::uint32_t kCloth = 0x1c543d;
constexpr std::uint32_t kCushion = 0x143d2e;
constexpr std::uint32_t kRail = 0x473324;

/// Of "#rrggbb".
Vec3 colour_of(const std::string& text) {
    const auto channel = [&](std::size_t at) {
        return std::stoi(text.substr(at, 2), nullptr, 16) / 255.0;
    };
    return decoded_srgb({channel(1), channel(3), channel(5)});
}

double radius_of_balls(const Shot& shot) {
    for (const sim::Body& body : shot.world.bodies) {
        if (const auto* sphere = std::get_if<sim::Sphere>(&body.shape)) {
            return sphere->radius;
        }
    }
    return kStandardRadius;
}

/// +y is downwards in Cairo.
void add_point(cairo_t* context, const Vec2& point) {
    cairo_line_to(context, point.x, -point.y);
}

}  // namespace

SmallPlan::SmallPlan(const Shot& shot, const sim::Timeline& timeline) : timeline_(timeline) {
    if (shot.world.table && shot.world.table->has_cushions) {
        table_ = sim::billiards::make_layout(*shot.world.table, radius_of_balls(shot));
        half_ = table_->outer;
    }
    for (const sim::Body& body : shot.world.bodies) {
        const auto* sphere = std::get_if<sim::Sphere>(&body.shape);
        const sim::Track* track = timeline.find(body.name);
        if (sphere == nullptr || track == nullptr) {
            continue;
        }
        const ObjectPaint paint = paint_of(shot, body.name);
        Ball ball{track, sphere->radius, colour_of(paint.colour), paint.is_striped};
        for (const sim::Event& event : timeline.events) {
            if (event.kind == sim::EventKind::potted && event.a == body.name) {
                ball.gone = std::min(ball.gone, event.time);
            }
        }
        if (!table_) {
            const sim::Bounds bounds =
                track->position_bounds(timeline.start_time, timeline.end_time);
            half_.x = std::max(
                {half_.x, std::abs(bounds.low.x) + kEdge, std::abs(bounds.high.x) + kEdge});
            half_.y = std::max(
                {half_.y, std::abs(bounds.low.y) + kEdge, std::abs(bounds.high.y) + kEdge});
        }
        balls_.push_back(ball);
    }
}

void SmallPlan::draw(cairo_t* context, const Vec2& corner, double height, double scene_time,
                     bool has_paths) const {
    const SavedState state(context);
    const double scale = height / (2 * half_.y);
    cairo_translate(context, corner.x, corner.y);
    cairo_scale(context, scale, scale);
    cairo_translate(context, half_.x, half_.y);
    cairo_new_path(context);
    draw_table(context);
    if (has_paths) {
        for (const Ball& ball : balls_) {
            draw_path(context, ball, scene_time);
        }
    }
    for (const Ball& ball : balls_) {
        if (scene_time < ball.gone) {
            draw_ball(context, ball, ball.track->sample(scene_time).position);
        }
    }
}

void SmallPlan::draw_table(cairo_t* context) const {
    add_round_box(context, -half_, 2.0 * half_, table_ ? 0.06 : 0);
    set_colour(context, table_ ? srgb_colour(kRail) : srgb_colour(kCloth), 0.95);
    cairo_fill(context);
    if (!table_) {
        return;
    }
    cairo_rectangle(context, -table_->rail.x, -table_->rail.y, 2 * table_->rail.x,
                    2 * table_->rail.y);
    set_colour(context, srgb_colour(kCloth), 1);
    cairo_fill(context);
    draw_cushions(context);
    for (const sim::billiards::PocketLayout& pocket : table_->pockets) {
        add_circle(context, {pocket.pocket.centre.x, -pocket.pocket.centre.y},
                   pocket.pocket.radius);
        set_colour(context, Vec3(0), 1);
        cairo_fill(context);
    }
}

void SmallPlan::draw_cushions(cairo_t* context) const {
    set_colour(context, srgb_colour(kCushion), 1);
    for (const sim::billiards::CushionLayout& cushion : table_->cushions) {
        for (const sim::billiards::PathPoint& point :
             sim::billiards::nose_path(cushion, table_->measures.cushion_width)) {
            add_point(context, point.position);
        }
        // The outline returns along the edge of the rail.
        const auto& side = cushion.side;
        const double depth = (table_->rail - table_->nose)
                                 .dot(Vec2(std::abs(side.outward.x), std::abs(side.outward.y)));
        const double to = cushion.to + (cushion.jaw_to ? cushion.jaw_to->end.x : depth);
        const double from = cushion.from - (cushion.jaw_from ? cushion.jaw_from->end.x : depth);
        add_point(context, side.at(to, depth));
        add_point(context, side.at(from, depth));
        cairo_close_path(context);
        cairo_fill(context);
    }
}

void SmallPlan::draw_path(cairo_t* context, const Ball& ball, double until) const {
    const double end = std::min(until, ball.gone);
    if (end <= timeline_.start_time) {
        return;
    }
    for (const LinePoint& point : track_line(*ball.track, timeline_.start_time, end)) {
        add_point(context, {point.position.x, point.position.y});
    }
    cairo_set_line_width(context, kPathWidth);
    set_colour(context, ball.colour, 0.85);
    cairo_stroke(context);
}

void SmallPlan::draw_ball(cairo_t* context, const Ball& ball, const Vec3& position) const {
    const double radius = kShownRadius * ball.radius;
    add_circle(context, {position.x, -position.y}, radius);
    set_colour(context, ball.is_striped ? Vec3(0.85) : ball.colour, 1);
    cairo_fill_preserve(context);
    set_colour(context, casing_colour(), 1);
    cairo_set_line_width(context, 0.25 * radius);
    cairo_stroke(context);
    if (ball.is_striped) {
        add_circle(context, {position.x, -position.y}, 0.55 * radius);
        set_colour(context, ball.colour, 1);
        cairo_fill(context);
    }
}

}  // namespace carom::pipeline
