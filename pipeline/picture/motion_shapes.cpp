// Arrows of velocity and spin.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "pipeline/picture/build_shapes.h"
#include "pipeline/picture/colours.h"

namespace carom::pipeline {
namespace {

constexpr double kWidth = 0.0075;  // picture heights
constexpr double kSpinWidth = 0.006;
constexpr double kTextSize = 0.038;    // picture heights
constexpr double kLeastLength = 0.01;  // of an arrow, m
constexpr double kLeastTurn = std::numbers::pi / 9;
constexpr double kMostTurn = 5 * std::numbers::pi / 3;
constexpr double kAround = 1.3;   // of the round arrow, ball radii
constexpr double kBeyond = 0.35;  // of the value beyond the arrow's end, ball radii

SceneLine arrow(std::vector<Vec3> points, const Vec3& colour, double width,
                const Annotation& look) {
    SceneLine line;
    line.points = std::move(points);
    line.colour = look.colour.value_or(colour);
    line.width = look.width.value_or(width);
    line.dash = look.dash.value_or(Dash::solid);
    line.has_head = true;
    return line;
}

SceneText value_at_end(const SceneLine& arrow, std::string text, double beyond,
                       const Annotation& look) {
    const Vec3& tip = arrow.points.back();
    const Vec3 along = (tip - arrow.points[arrow.points.size() - 2]).normalized();
    SceneText value = scene_text(std::move(text), tip + beyond * along, look, kTextSize);
    value.colour = arrow.colour;
    value.nearer = beyond;
    value.offset = {0, 0.01};
    value.is_above = true;
    return value;
}

}  // namespace

SceneShapes shapes_of(const VelocityAnnotation& velocity, const Annotation& look,
                      const SceneMoment& moment) {
    const sim::Track* track = moment.timeline.find(velocity.of);
    if (track == nullptr) {
        return {};
    }
    const MotionState state = track->sample(moment.time);
    const double speed = state.velocity.length();
    if (speed * velocity.during < kLeastLength) {
        return {};
    }
    const double radius = moment.radius(velocity.of);
    const Vec3 direction = state.velocity / speed;
    const Vec3 start = state.position + radius * direction;
    SceneLine line =
        arrow({start, start + velocity.during * state.velocity}, velocity_colour(), kWidth, look);
    SceneShapes shapes{line};
    if (velocity.value) {
        shapes.push_back(
            value_at_end(line, number_text(speed, "", ".2f") + " m/s", kBeyond * radius, look));
    }
    return shapes;
}

SceneShapes shapes_of(const SpinAnnotation& spin, const Annotation& look,
                      const SceneMoment& moment) {
    const sim::Track* track = moment.timeline.find(spin.of);
    if (track == nullptr) {
        return {};
    }
    const MotionState state = track->sample(moment.time);
    const double speed = state.angular_velocity.length();
    const double turn = std::min(speed * spin.during, kMostTurn);
    if (turn < kLeastTurn) {
        return {};
    }
    // The middle of the arrow is on the camera's side of the ball.
    const Vec3 axis = state.angular_velocity / speed;
    const Vec3 to_camera = moment.view.position() - state.position;
    Vec3 middle = to_camera - axis.dot(to_camera) * axis;
    if (middle.length() < 1e-6 * to_camera.length()) {
        middle = axis.cross(Vec3(1, 0, 0)) + axis.cross(Vec3(0, 1, 0));
    }
    const double radius = moment.radius(spin.of);
    middle *= kAround * radius / middle.length();
    const Vec3 start = arc_points({0, 0, 0}, middle, axis, -turn / 2).back();
    SceneLine line =
        arrow(arc_points(state.position, start, axis, turn), spin_colour(), kSpinWidth, look);
    SceneShapes shapes{line};
    if (spin.value) {
        shapes.push_back(
            value_at_end(line, number_text(speed, "", ".0f") + " rad/s", kBeyond * radius, look));
    }
    return shapes;
}

}  // namespace carom::pipeline
