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
    if (ball.is_still())
        return;
    if (ball.stretch.end <= until)
        push(queue, ball, index, TouchKind::stretch_end, 0, std::max(now, ball.stretch.end));
    until = std::min(until, ball.stretch.end);
    find_balls(index, now, until, only_later_balls, queue);
    if (ball.stretch.kind == MotionKind::spinning)
        return;
    if (ball.pocket >= 0) {
        find_in_pocket(index, now, until, queue);
    } else if (ball.ground == Ground::none) {
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
        const double end = std::min(until, partner.stretch.end);
        const auto time =
            ball_touch(ball.stretch, partner.stretch, ball.radius + partner.radius, now, end);
        if (!time)
            continue;
        const auto [low, high] = std::minmax(index, other);
        queue.push({*time, TouchKind::ball, low, high, balls_[low].version, balls_[high].version});
    }
}

void TouchFinder::find_on_cloth(std::uint32_t index, double now, double until,
                                TouchQueue& queue) const {
    find_cushions(index, now, until, queue);
    const Ball& ball = balls_[index];
    const double z = ball.stretch.state.position.z;
    for (std::size_t i = 0; i < around_.table.pockets.size(); ++i) {
        const billiards::Pocket& pocket = around_.table.pockets[i];
        push(queue, ball, index, TouchKind::pocket_edge, i,
             point_touch(ball.stretch, in_space(pocket.centre, z), pocket.radius, now, until));
    }
}

void TouchFinder::find_cushions(std::uint32_t index, double now, double until,
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
}

void TouchFinder::find_in_air(std::uint32_t index, double now, double until,
                              TouchQueue& queue) const {
    const Ball& ball = balls_[index];
    if (around_.has_cushions) {
        const billiards::TableGeometry& table = around_.table;
        for (std::size_t i = 0; i < table.faces.size(); ++i) {
            const billiards::CushionFace& face = table.faces[i];
            const Vec2 along = face.to - face.from;
            const Vec2 direction = along / std::sqrt(along.dot(along));
            const auto time = line_touch(ball.stretch, in_space(face.from, around_.nose_height),
                                         in_space(direction, 0), ball.radius, now, until);
            if (!time)
                continue;
            const Vec3 p = ball.stretch.position_at(*time);
            const double place = (Vec2(p.x, p.y) - face.from).dot(along) / along.dot(along);
            if (place >= 0 && place <= 1)
                push(queue, ball, index, TouchKind::cushion_face, i, time);
        }
    }
    if (around_.has_cloth && !ball.is_off_table)
        push(queue, ball, index, TouchKind::ground, static_cast<std::size_t>(Ground::cloth),
             plane_touch(ball.stretch, Vec3(0, 0, 0), kUp, ball.radius, now, until));
    if (around_.floor_height)
        push(queue, ball, index, TouchKind::ground, static_cast<std::size_t>(Ground::floor),
             plane_touch(ball.stretch, Vec3(0, 0, *around_.floor_height), kUp, ball.radius, now,
                         until));
}

void TouchFinder::find_in_pocket(std::uint32_t index, double now, double until,
                                 TouchQueue& queue) const {
    const Ball& ball = balls_[index];
    const auto at = static_cast<std::size_t>(ball.pocket);
    const billiards::Pocket& pocket = around_.table.pockets[at];
    const Vec3 centre = in_space(pocket.centre, 0);
    push(queue, ball, index, TouchKind::pocket_wall, at,
         line_departure(ball.stretch, centre, kUp, pocket.radius - ball.radius, now, until));
    if (ball.ground != Ground::none)
        return;
    if (!ball.is_potted)
        push(queue, ball, index, TouchKind::below_cloth, at,
             plane_touch(ball.stretch, centre, kUp, 0, now, until));
    push(queue, ball, index, TouchKind::ground, static_cast<std::size_t>(Ground::pocket_floor),
         plane_touch(ball.stretch, in_space(pocket.centre, -pocket.drop), kUp, ball.radius, now,
                     until));
}

}  // namespace carom::sim
