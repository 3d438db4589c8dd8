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
          std::size_t other, std::optional<double> time, std::uint32_t second_version = 0) {
    if (time) {
        queue.push(
            {*time, kind, index, static_cast<std::uint32_t>(other), ball.version, second_version});
    }
}

/// Twice the largest ball's diameter: wider, and more pairs are looked at; narrower, and balls
/// cross more often.
double cell_width(const std::vector<Ball>& balls) {
    double largest = 0;
    for (const Ball& ball : balls) {
        largest = std::max(largest, ball.radius);
    }
    return std::max(4 * largest, 16 * kCellMargin);
}

/// A look goes as far as a ball moves by about its own radius.
double look_duration(const Ball& ball, double now) {
    constexpr double kShortest = 1.0 / 2000;  // s
    constexpr double kLongest = 1.0 / 60;
    const Vec3 v = ball.stretch.velocity_at(now);
    const double speed = std::sqrt(v.dot(v));
    return std::clamp(ball.radius / std::max(speed, 1e-3), kShortest, kLongest);
}

/// The nearest time at which the centre comes within `reach` of the nose between the ends of a
/// face, on its inner side.
std::optional<double> level_face_touch(const Stretch& stretch, const billiards::CushionFace& face,
                                       double reach, double now, double until) {
    const auto time =
        plane_touch(stretch, in_space(face.from, 0), in_space(face.normal, 0), reach, now, until);
    if (!time) {
        return time;
    }
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

TouchFinder::TouchFinder(const Surroundings& around, const std::vector<Ball>& balls,
                         const std::vector<StepBody>& bodies)
    : around_(around),
      balls_(balls),
      bodies_(bodies),
      grid_(cell_width(balls), balls.size()),
      next_look_(balls.size(), kNever),
      last_found_(balls.size(), 0) {}

void TouchFinder::find(const std::vector<std::uint32_t>& changed, const Outlook& outlook,
                       TouchQueue& queue) {
    ++find_count_;
    for (const std::uint32_t index : changed) {
        grid_.place(index, balls_[index].stretch.position_at(outlook.now));
    }
    for (const std::uint32_t index : changed) {
        find_one(index, outlook, queue);
    }
}

void TouchFinder::find_one(std::uint32_t index, const Outlook& outlook, TouchQueue& queue) {
    const Ball& ball = balls_[index];
    const double now = outlook.now;
    const double end = ball.is_stepped() ? outlook.step_end : outlook.end;
    const double until = std::min(end, ball.stretch.end);
    if (ball.stretch.end <= end) {
        push(queue, ball, index, TouchKind::stretch_end, 0, std::max(now, ball.stretch.end));
    }
    grid_.find_near(index, near_);
    for (const std::uint32_t other : near_) {
        // Of two that have both changed the second one to be asked leaves the pair out.
        if (last_found_[other] != find_count_) {
            find_pair(index, other, now, until, queue);
        }
    }
    last_found_[index] = find_count_;
    find_crossing(index, now, until, queue);
    find_unmoving(index, outlook, queue);
    const bool moves_freely = !ball.is_still() && !ball.is_stepped();
    if (!moves_freely || ball.stretch.kind == MotionKind::spinning) {
        return;
    }
    find_fixed_spheres(index, now, until, queue);
    if (ball.ground == Ground::cloth && around_.has_cushions) {
        find_on_cloth(index, now, until, queue);
    }
}

void TouchFinder::find_crossing(std::uint32_t index, double now, double until,
                                TouchQueue& queue) const {
    const Ball& ball = balls_[index];
    if (ball.is_still() || ball.stretch.kind == MotionKind::spinning) {
        return;
    }
    if (const auto crossing = grid_.next_crossing(index, ball.stretch, now, until)) {
        push(queue, ball, index, TouchKind::cell_crossing, static_cast<std::size_t>(crossing->to),
             crossing->time);
    }
}

void TouchFinder::cross(const Touch& crossing, const Outlook& outlook, TouchQueue& queue) {
    const std::uint32_t index = crossing.first;
    const Ball& ball = balls_[index];
    const auto side = static_cast<CellGrid::Side>(crossing.second);
    const double end = ball.is_stepped() ? outlook.step_end : outlook.end;
    const double until = std::min(end, ball.stretch.end);
    grid_.cross(index, side);
    grid_.find_ahead(index, side, near_);
    for (const std::uint32_t other : near_) {
        find_pair(index, other, outlook.now, until, queue);
    }
    find_crossing(index, outlook.now, until, queue);
}

void TouchFinder::find_pair(std::uint32_t index, std::uint32_t other, double now, double until,
                            TouchQueue& queue) const {
    const Ball& ball = balls_[index];
    const Ball& partner = balls_[other];
    if (ball.is_still() && partner.is_still()) {
        return;
    }
    // ODE sees to those that it carries both.
    if ((ball.is_stepped() && (partner.is_stepped() || partner.is_lying)) ||
        (ball.is_lying && partner.is_stepped())) {
        return;
    }
    const double end = std::min(until, partner.stretch.end);
    const auto time =
        ball_touch(ball.stretch, partner.stretch, ball.radius + partner.radius, now, end);
    if (!time) {
        return;
    }
    const auto [low, high] = std::minmax(index, other);
    queue.push({*time, TouchKind::ball, low, high, balls_[low].version, balls_[high].version});
}

/// What takes a walk through a tree or a search in steps is looked for only some way ahead.
void TouchFinder::find_unmoving(std::uint32_t index, const Outlook& outlook, TouchQueue& queue) {
    const Ball& ball = balls_[index];
    next_look_[index] = kNever;
    if (ball.is_stepped() || ball.is_lying) {
        return;
    }
    const bool is_flying = ball.ground == Ground::none && !ball.is_still();
    const bool has_boxes = bodies_.size() > balls_.size();
    if (!is_flying && !has_boxes && around_.scenery_mesh.empty() && around_.solids.empty()) {
        return;
    }
    const double whole = std::min(outlook.end, ball.stretch.end);
    const double until = std::min(whole, outlook.now + look_duration(ball, outlook.now));
    find_boxes(index, outlook.now, std::min(until, outlook.step_end), queue);
    if (ball.is_still()) {
        return;
    }
    find_scenery(index, outlook.now, until, queue);
    if (is_flying) {
        find_in_air(index, outlook.now, until, queue);
    }
    if (until < whole) {
        next_look_[index] = until;
        push(queue, ball, index, TouchKind::look_again, 0, until);
    }
}

void TouchFinder::look_again(const Touch& look, const Outlook& outlook, TouchQueue& queue) {
    if (next_look_[look.first] == look.time) {
        find_unmoving(look.first, outlook, queue);
    }
}

void TouchFinder::find_boxes_for_all(const Outlook& outlook, TouchQueue& queue) {
    ++box_round_;
    for (std::uint32_t i = 0; i < balls_.size(); ++i) {
        const Ball& ball = balls_[i];
        if (ball.is_stepped() || ball.is_lying) {
            continue;
        }
        // A ball without a next look looks as far as its stretch goes.
        const double until = std::min({outlook.step_end, ball.stretch.end, next_look_[i]});
        find_boxes(i, outlook.now, until, queue);
    }
}

void TouchFinder::find_boxes(std::uint32_t index, double now, double until,
                             TouchQueue& queue) const {
    const Ball& ball = balls_[index];
    for (std::size_t i = balls_.size(); i < bodies_.size(); ++i) {
        const StepBody& box = bodies_[i];
        if (!ball.is_still() || box.is_awake) {
            push(queue, ball, index, TouchKind::box, i,
                 convex_touch(ball.stretch, ball.radius, box.motion, now, until), box_round_);
        }
    }
}

void TouchFinder::find_scenery(std::uint32_t index, double now, double until,
                               TouchQueue& queue) const {
    const Ball& ball = balls_[index];
    if (ball.stretch.kind == MotionKind::spinning) {
        return;
    }
    for (std::size_t i = 0; i < around_.solids.size(); ++i) {
        const FixedSolid& solid = around_.solids[i];
        const ConvexMotion still{
            solid.shape.get(),
            now,
            {solid.pose.position, solid.pose.orientation, Vec3(0, 0, 0), Vec3(0, 0, 0)}};
        if (!solid.has_mesh) {
            push(queue, ball, index, TouchKind::fixed_solid, i,
                 convex_touch(ball.stretch, ball.radius, still, now, until));
        }
    }
    if (around_.scenery_mesh.empty()) {
        return;
    }
    const auto touch = around_.scenery_mesh.first_touch(ball.stretch, ball.radius, now, until);
    if (touch) {
        push(queue, ball, index, TouchKind::scenery_feature, touch->feature, touch->time);
    }
}

void TouchFinder::find_fixed_spheres(std::uint32_t index, double now, double until,
                                     TouchQueue& queue) const {
    const Ball& ball = balls_[index];
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
    for (std::size_t i = 0; i < table.faces.size(); ++i) {
        push(queue, ball, index, TouchKind::cushion_face, i,
             level_face_touch(ball.stretch, table.faces[i], reach, now, until));
    }
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
        if (time && around_.is_over_cloth(ball.stretch.position_at(*time + kAhead))) {
            push(queue, ball, index, TouchKind::ground, static_cast<std::size_t>(Ground::cloth),
                 time);
        }
    }
    if (around_.floor_height) {
        push(queue, ball, index, TouchKind::ground, static_cast<std::size_t>(Ground::floor),
             plane_touch(ball.stretch, Vec3(0, 0, *around_.floor_height), kUp, ball.radius, now,
                         until));
    }
    if (!around_.has_cushions) {
        return;
    }
    if (height < kSlateUnderside - ball.radius + kDeepest) {
        const auto time =
            plane_touch(ball.stretch, Vec3(0, 0, kSlateUnderside), -kUp, ball.radius, now, until);
        if (time && around_.is_over_cloth(ball.stretch.position_at(*time))) {
            push(queue, ball, index, TouchKind::slate_underside, 0, time);
        }
    }
    if (const auto touch = around_.table_mesh.first_touch(ball.stretch, ball.radius, now, until)) {
        push(queue, ball, index, TouchKind::table_feature, touch->feature, touch->time);
    }
    for (std::size_t i = 0; i < around_.rims.size(); ++i) {
        const auto time = around_.rims[i].touch(ball.stretch, ball.radius, now, until);
        // Where the ball is over the cloth it touches the plane.
        if (time && around_.pocket_below(ball.stretch.position_at(*time)) == static_cast<int>(i)) {
            push(queue, ball, index, TouchKind::rim, i, time);
        }
    }
    if (!ball.is_potted && !ball.is_off_table) {
        push(queue, ball, index, TouchKind::below_cloth, 0,
             plane_touch(ball.stretch, Vec3(0, 0, 0), kUp, 0, now, until));
    }
}

}  // namespace carom::sim
