#include "sim/scheduler/touch_finder.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "sim/motion/time_of_impact.h"

namespace carom::sim {
namespace {

const Vec3 kUp(0, 0, 1);

Vec3 in_space(const Vec2& v, double z) {
    return {v.x, v.y, z};
}

void push(TouchQueue& queue, const Ball& ball, std::uint32_t index, TouchKind kind,
          std::size_t other, std::optional<double> time) {
    if (time)
        queue.push({*time, kind, index, static_cast<std::uint32_t>(other), ball.version, 0});
}

/// The nearest time at which the centre comes within `reach` of the nose between the ends of a
/// face, on its inner side.
std::optional<double> level_face_touch(const Stretch& stretch, const billiards::CushionFace& face,
                                       double reach, double now, double until) {
    const auto time =
        plane_touch(stretch, in_space(face.from, 0), in_space(face.normal, 0), reach, now, until);
    if (!time)
        return time;
    const Vec3 p = stretch.position_at(*time);
    const Vec2 along = face.to - face.from;
    const double place = (Vec2(p.x, p.y) - face.from).dot(along) / along.dot(along);
    const bool behind =
        (Vec2(p.x, p.y) - face.from).dot(face.normal) < -0.5 * reach;  // far outside
    return place >= 0 && place <= 1 && !behind ? time : std::nullopt;
}

}  // namespace

double nose_reach(double radius, double z, double nose_height) {
    const double d = nose_height - z;
    const double square = radius * radius - d * d;
    return square > 0 ? std::sqrt(square) : 0;
}

void TouchFinder::find(std::uint32_t index, double now, double until, bool only_later_balls,
                       TouchQueue& queue) const {
    const Ball& ball = balls_[index];
    if (!ball.is_stepped() && !ball.is_lying)
        find_boxes(index, now, std::min(until, ball.stretch.end), queue);
    if (ball.is_still())
        return;
    if (ball.stretch.end <= until)
        push(queue, ball, index, TouchKind::stretch_end, 0, std::max(now, ball.stretch.end));
    until = std::min(until, ball.stretch.end);
    find_balls(index, now, until, only_later_balls, queue);
    if (ball.is_stepped() || ball.stretch.kind == MotionKind::spinning)
        return;
    find_fixed(index, now, until, queue);
    if (ball.ground == Ground::none) {
        find_in_air(index, now, until, queue);
    } else if (ball.ground == Ground::cloth && around_.has_cushions) {
        find_on_cloth(index, now, until, queue);
    }
}

void TouchFinder::find_balls(std::uint32_t index, double now, double until, bool only_later_balls,
                             TouchQueue& queue) const {
    const Ball& ball = balls_[index];
    for (std::uint32_t other = 0; other < balls_.size(); ++other) {
        const Ball& partner = balls_[other];
        if (other == index || (only_later_balls && other < index && !partner.is_still()))
            continue;
        // ODE sees to those that it carries both.
        if (ball.is_stepped() && (partner.is_stepped() || partner.is_lying))
            continue;
        const double end = std::min(until, partner.stretch.end);
        const auto time =
            ball_touch(ball.stretch, partner.stretch, ball.radius + partner.radius, now, end);
        if (!time)
            continue;
        const auto [low, high] = std::minmax(index, other);
        queue.push({*time, TouchKind::ball, low, high, balls_[low].version, balls_[high].version});
    }
}

void TouchFinder::find_boxes(std::uint32_t index, double now, double until,
                             TouchQueue& queue) const {
    const Ball& ball = balls_[index];
    for (std::size_t i = balls_.size(); i < bodies_.size(); ++i) {
        const StepBody& box = bodies_[i];
        if (!ball.is_still() || box.is_awake)
            push(queue, ball, index, TouchKind::box, i,
                 box_touch(ball.stretch, ball.radius, box.motion, now, until));
    }
}

void TouchFinder::find_fixed(std::uint32_t index, double now, double until,
                             TouchQueue& queue) const {
    const Ball& ball = balls_[index];
    if (!around_.scenery_mesh.empty()) {
        const auto touch = around_.scenery_mesh.first_touch(ball.stretch, ball.radius, now, until);
        if (touch)
            push(queue, ball, index, TouchKind::scenery_feature, touch->feature, touch->time);
    }
    for (std::size_t i = 0; i < around_.spheres.size(); ++i) {
        const FixedSphere& sphere = around_.spheres[i];
        push(queue, ball, index, TouchKind::fixed_sphere, i,
             point_touch(ball.stretch, sphere.centre, ball.radius + sphere.radius, now, until));
    }
}

void TouchFinder::find_on_cloth(std::uint32_t index, double now, double until,
                                TouchQueue& queue) const {
    const Ball& ball = balls_[index];
    const double z = ball.stretch.state.position.z;
    const double reach = nose_reach(ball.radius, z, around_.nose_height);
    const billiards::TableGeometry& table = around_.table;
    for (std::size_t i = 0; i < table.faces.size(); ++i)
        push(queue, ball, index, TouchKind::cushion_face, i,
             level_face_touch(ball.stretch, table.faces[i], reach, now, until));
    for (std::size_t i = 0; i < table.corners.size(); ++i) {
        const billiards::CushionCorner& corner = table.corners[i];
        push(queue, ball, index, TouchKind::cushion_corner, i,
             point_touch(ball.stretch, in_space(corner.centre, z), reach + corner.radius, now,
                         until));
    }
    for (std::size_t i = 0; i < table.pockets.size(); ++i) {
        const billiards::Pocket& pocket = table.pockets[i];
        push(queue, ball, index, TouchKind::pocket_edge, i,
             point_touch(ball.stretch, in_space(pocket.centre, z), pocket.radius, now, until));
    }
}

void TouchFinder::find_in_air(std::uint32_t index, double now, double until,
                              TouchQueue& queue) const {
    const Ball& ball = balls_[index];
    // From below, under the table, nothing lands on the cloth.
    constexpr double kDeepest = 1e-4;  // m
    const double height = ball.stretch.position_at(now).z;
    if (around_.has_cloth && height > ball.radius - kDeepest) {
        const auto time = plane_touch(ball.stretch, Vec3(0, 0, 0), kUp, ball.radius, now, until);
        // A ball that is just passing over a hole's edge counts as where it will be.
        constexpr double kAhead = 1e-7;  // s
        if (time && around_.is_over_cloth(ball.stretch.position_at(*time + kAhead)))
            push(queue, ball, index, TouchKind::ground, static_cast<std::size_t>(Ground::cloth),
                 time);
    }
    if (around_.floor_height)
        push(queue, ball, index, TouchKind::ground, static_cast<std::size_t>(Ground::floor),
             plane_touch(ball.stretch, Vec3(0, 0, *around_.floor_height), kUp, ball.radius, now,
                         until));
    if (!around_.has_cushions)
        return;
    if (const auto touch = around_.table_mesh.first_touch(ball.stretch, ball.radius, now, until))
        push(queue, ball, index, TouchKind::table_feature, touch->feature, touch->time);
    for (std::size_t i = 0; i < around_.rims.size(); ++i) {
        const auto time = around_.rims[i].touch(ball.stretch, ball.radius, now, until);
        // Where the ball is over the cloth it touches the plane.
        if (time && around_.pocket_below(ball.stretch.position_at(*time)) == static_cast<int>(i))
            push(queue, ball, index, TouchKind::rim, i, time);
    }
    if (!ball.is_potted && !ball.is_off_table)
        push(queue, ball, index, TouchKind::below_cloth, 0,
             plane_touch(ball.stretch, Vec3(0, 0, 0), kUp, 0, now, until));
}

}  // namespace carom::sim
