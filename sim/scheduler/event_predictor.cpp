#include "sim/scheduler/event_predictor.h"

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

void push(PredictedEventQueue& queue, const Ball& ball, std::uint32_t index,
          PredictedEventKind kind, std::size_t other, std::optional<double> time,
          std::uint32_t second_version = 0) {
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
    const Vec3 v = ball.segment.velocity_at(now);
    const double speed = std::sqrt(v.dot(v));
    return std::clamp(ball.radius / std::max(speed, 1e-3), kShortest, kLongest);
}

/// The nearest time at which the centre comes within `reach` of the nose between the ends of a
/// face, on its inner side.
std::optional<double> level_face_impact_time(const MotionSegment& segment,
                                             const billiards::CushionFace& face, double reach,
                                             double now, double until) {
    const auto time = plane_impact_time(segment, in_space(face.from, 0), in_space(face.normal, 0),
                                        reach, now, until);
    if (!time) {
        return time;
    }
    const Vec3 p = segment.position_at(*time);
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

EventPredictor::EventPredictor(const StaticEnvironment& environment, const std::vector<Ball>& balls,
                               const std::vector<StepBody>& bodies)
    : environment_(environment),
      balls_(balls),
      bodies_(bodies),
      grid_(cell_width(balls), balls.size()),
      next_look_(balls.size(), kNever),
      last_found_(balls.size(), 0) {}

void EventPredictor::find(const std::vector<std::uint32_t>& changed, const SearchHorizon& horizon,
                          PredictedEventQueue& queue) {
    ++find_count_;
    for (const std::uint32_t index : changed) {
        grid_.place(index, balls_[index].segment.position_at(horizon.now));
    }
    for (const std::uint32_t index : changed) {
        find_one(index, horizon, queue);
    }
}

void EventPredictor::find_one(std::uint32_t index, const SearchHorizon& horizon,
                              PredictedEventQueue& queue) {
    const Ball& ball = balls_[index];
    const double now = horizon.now;
    const double end = ball.is_stepped() ? horizon.step_end : horizon.end;
    const double until = std::min(end, ball.segment.end);
    if (ball.segment.end <= end) {
        push(queue, ball, index, PredictedEventKind::segment_end, 0,
             std::max(now, ball.segment.end));
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
    find_unmoving(index, horizon, queue);
    const bool moves_freely = !ball.is_still() && !ball.is_stepped();
    if (!moves_freely || ball.segment.kind == MotionKind::spinning) {
        return;
    }
    find_fixed_spheres(index, now, until, queue);
    if (ball.ground == Ground::cloth && environment_.has_cushions) {
        find_on_cloth(index, now, until, queue);
    }
}

void EventPredictor::find_crossing(std::uint32_t index, double now, double until,
                                   PredictedEventQueue& queue) const {
    const Ball& ball = balls_[index];
    if (ball.is_still() || ball.segment.kind == MotionKind::spinning) {
        return;
    }
    if (const auto crossing = grid_.next_crossing(index, ball.segment, now, until)) {
        push(queue, ball, index, PredictedEventKind::cell_crossing,
             static_cast<std::size_t>(crossing->to), crossing->time);
    }
}

void EventPredictor::cross(const PredictedEvent& crossing, const SearchHorizon& horizon,
                           PredictedEventQueue& queue) {
    const std::uint32_t index = crossing.first;
    const Ball& ball = balls_[index];
    const auto side = static_cast<CellGrid::Side>(crossing.second);
    const double end = ball.is_stepped() ? horizon.step_end : horizon.end;
    const double until = std::min(end, ball.segment.end);
    grid_.cross(index, side);
    grid_.find_ahead(index, side, near_);
    for (const std::uint32_t other : near_) {
        find_pair(index, other, horizon.now, until, queue);
    }
    find_crossing(index, horizon.now, until, queue);
}

void EventPredictor::find_pair(std::uint32_t index, std::uint32_t other, double now, double until,
                               PredictedEventQueue& queue) const {
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
    const double end = std::min(until, partner.segment.end);
    const auto time =
        ball_impact_time(ball.segment, partner.segment, ball.radius + partner.radius, now, end);
    if (!time) {
        return;
    }
    const auto [low, high] = std::minmax(index, other);
    queue.push(
        {*time, PredictedEventKind::ball, low, high, balls_[low].version, balls_[high].version});
}

/// What takes a walk through a tree or a search in steps is looked for only some way ahead.
void EventPredictor::find_unmoving(std::uint32_t index, const SearchHorizon& horizon,
                                   PredictedEventQueue& queue) {
    const Ball& ball = balls_[index];
    next_look_[index] = kNever;
    if (ball.is_stepped() || ball.is_lying) {
        return;
    }
    const bool is_flying = ball.ground == Ground::none && !ball.is_still();
    const bool has_boxes = bodies_.size() > balls_.size();
    if (!is_flying && !has_boxes && environment_.scenery_mesh.empty() &&
        environment_.solids.empty()) {
        return;
    }
    const double whole = std::min(horizon.end, ball.segment.end);
    const double until = std::min(whole, horizon.now + look_duration(ball, horizon.now));
    find_boxes(index, horizon.now, std::min(until, horizon.step_end), queue);
    if (ball.is_still()) {
        return;
    }
    find_scenery(index, horizon.now, until, queue);
    if (is_flying) {
        find_in_air(index, horizon.now, until, queue);
    }
    if (until < whole) {
        next_look_[index] = until;
        push(queue, ball, index, PredictedEventKind::search_again, 0, until);
    }
}

void EventPredictor::search_again(const PredictedEvent& look, const SearchHorizon& horizon,
                                  PredictedEventQueue& queue) {
    if (next_look_[look.first] == look.time) {
        find_unmoving(look.first, horizon, queue);
    }
}

void EventPredictor::find_boxes_for_all(const SearchHorizon& horizon, PredictedEventQueue& queue) {
    ++box_round_;
    for (std::uint32_t i = 0; i < balls_.size(); ++i) {
        const Ball& ball = balls_[i];
        if (ball.is_stepped() || ball.is_lying) {
            continue;
        }
        // A ball without a next look looks as far as its segment goes.
        const double until = std::min({horizon.step_end, ball.segment.end, next_look_[i]});
        find_boxes(i, horizon.now, until, queue);
    }
}

void EventPredictor::find_boxes(std::uint32_t index, double now, double until,
                                PredictedEventQueue& queue) const {
    const Ball& ball = balls_[index];
    for (std::size_t i = balls_.size(); i < bodies_.size(); ++i) {
        const StepBody& box = bodies_[i];
        if (!ball.is_still() || box.is_awake) {
            push(queue, ball, index, PredictedEventKind::box, i,
                 convex_impact_time(ball.segment, ball.radius, box.motion, now, until), box_round_);
        }
    }
}

void EventPredictor::find_scenery(std::uint32_t index, double now, double until,
                                  PredictedEventQueue& queue) const {
    const Ball& ball = balls_[index];
    if (ball.segment.kind == MotionKind::spinning) {
        return;
    }
    for (std::size_t i = 0; i < environment_.solids.size(); ++i) {
        const FixedSolid& solid = environment_.solids[i];
        const ConvexMotion still{
            solid.shape.get(),
            now,
            {solid.pose.position, solid.pose.orientation, Vec3(0, 0, 0), Vec3(0, 0, 0)}};
        if (!solid.has_mesh) {
            push(queue, ball, index, PredictedEventKind::fixed_solid, i,
                 convex_impact_time(ball.segment, ball.radius, still, now, until));
        }
    }
    if (environment_.scenery_mesh.empty()) {
        return;
    }
    const auto impact =
        environment_.scenery_mesh.first_impact(ball.segment, ball.radius, now, until);
    if (impact) {
        push(queue, ball, index, PredictedEventKind::scenery_feature, impact->feature,
             impact->time);
    }
}

void EventPredictor::find_fixed_spheres(std::uint32_t index, double now, double until,
                                        PredictedEventQueue& queue) const {
    const Ball& ball = balls_[index];
    for (std::size_t i = 0; i < environment_.spheres.size(); ++i) {
        const FixedSphere& sphere = environment_.spheres[i];
        push(queue, ball, index, PredictedEventKind::fixed_sphere, i,
             point_impact_time(ball.segment, sphere.centre, ball.radius + sphere.radius, now,
                               until));
    }
}

void EventPredictor::find_on_cloth(std::uint32_t index, double now, double until,
                                   PredictedEventQueue& queue) const {
    const Ball& ball = balls_[index];
    const double z = ball.segment.state.position.z;
    const double reach = nose_reach(ball.radius, z, environment_.nose_height);
    const billiards::TableGeometry& table = environment_.table;
    for (std::size_t i = 0; i < table.faces.size(); ++i) {
        push(queue, ball, index, PredictedEventKind::cushion_face, i,
             level_face_impact_time(ball.segment, table.faces[i], reach, now, until));
    }
    for (std::size_t i = 0; i < table.corners.size(); ++i) {
        const billiards::CushionCorner& corner = table.corners[i];
        push(queue, ball, index, PredictedEventKind::cushion_corner, i,
             point_impact_time(ball.segment, in_space(corner.centre, z), reach + corner.radius, now,
                               until));
    }
    for (std::size_t i = 0; i < table.pockets.size(); ++i) {
        const billiards::Pocket& pocket = table.pockets[i];
        push(
            queue, ball, index, PredictedEventKind::pocket_edge, i,
            point_impact_time(ball.segment, in_space(pocket.centre, z), pocket.radius, now, until));
    }
}

void EventPredictor::find_in_air(std::uint32_t index, double now, double until,
                                 PredictedEventQueue& queue) const {
    const Ball& ball = balls_[index];
    // From below, under the table, nothing lands on the cloth.
    constexpr double kDeepest = 1e-4;  // m
    const double height = ball.segment.position_at(now).z;
    if (environment_.has_cloth && height > ball.radius - kDeepest) {
        const auto time =
            plane_impact_time(ball.segment, Vec3(0, 0, 0), kUp, ball.radius, now, until);
        // A ball that is just passing over a hole's edge counts as where it will be.
        constexpr double kAhead = 1e-7;  // s
        if (time && environment_.is_over_cloth(ball.segment.position_at(*time + kAhead))) {
            push(queue, ball, index, PredictedEventKind::ground,
                 static_cast<std::size_t>(Ground::cloth), time);
        }
    }
    if (environment_.floor_height) {
        push(queue, ball, index, PredictedEventKind::ground,
             static_cast<std::size_t>(Ground::floor),
             plane_impact_time(ball.segment, Vec3(0, 0, *environment_.floor_height), kUp,
                               ball.radius, now, until));
    }
    if (!environment_.has_cushions) {
        return;
    }
    if (height < kSlateUnderside - ball.radius + kDeepest) {
        const auto time = plane_impact_time(ball.segment, Vec3(0, 0, kSlateUnderside), -kUp,
                                            ball.radius, now, until);
        if (time && environment_.is_over_cloth(ball.segment.position_at(*time))) {
            push(queue, ball, index, PredictedEventKind::slate_underside, 0, time);
        }
    }
    if (const auto impact =
            environment_.table_mesh.first_impact(ball.segment, ball.radius, now, until)) {
        push(queue, ball, index, PredictedEventKind::table_feature, impact->feature, impact->time);
    }
    for (std::size_t i = 0; i < environment_.rims.size(); ++i) {
        const auto time = environment_.rims[i].touch(ball.segment, ball.radius, now, until);
        // Where the ball is over the cloth it touches the plane.
        if (time &&
            environment_.pocket_below(ball.segment.position_at(*time)) == static_cast<int>(i)) {
            push(queue, ball, index, PredictedEventKind::rim, i, time);
        }
    }
    if (!ball.is_potted && !ball.is_off_table) {
        push(queue, ball, index, PredictedEventKind::below_cloth, 0,
             plane_impact_time(ball.segment, Vec3(0, 0, 0), kUp, 0, now, until));
    }
}

}  // namespace carom::sim
