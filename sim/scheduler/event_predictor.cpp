#include "sim/scheduler/event_predictor.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "sim/motion/time_of_impact.h"
#include "sim/numeric/tolerances.h"
#include "sim/spatial/aabb_tree.h"

namespace carom::sim {
namespace {

void push(PredictedEventQueue& queue, const MovingBody& ball, std::uint32_t index,
          PredictedEventKind kind, std::size_t other, std::optional<double> time,
          std::uint32_t second_version = 0) {
    if (time) {
        queue.push(
            {*time, kind, index, static_cast<std::uint32_t>(other), ball.version, second_version});
    }
}

/// Twice the largest ball's diameter. Wider cells mean more pairs to test, narrower ones more
/// crossings.
double cell_width(std::span<const MovingBody> balls) {
    double largest = 0;
    for (const MovingBody& ball : balls) {
        largest = std::max(largest, ball.radius);
    }
    return std::max(4 * largest, 16 * kCellMargin);
}

/// The time in which the ball moves by about its own radius.
double search_duration(const MovingBody& ball, double now) {
    constexpr double kShortest = 1.0 / 2000;  // s
    constexpr double kLongest = 1.0 / 60;
    const Vec3 v = ball.segment.velocity_at(now);
    const double speed = std::sqrt(v.dot(v));
    return std::clamp(ball.radius / std::max(speed, 1e-3), kShortest, kLongest);
}

/// The first time at which the centre comes within `distance` of the nose between the ends of a
/// face, from the inner side.
std::optional<double> level_face_impact_time(const MotionSegment& segment,
                                             const billiards::CushionFace& face, double distance,
                                             double now, double until) {
    const auto time = plane_impact_time(segment, in_space(face.from, 0), in_space(face.normal, 0),
                                        distance, now, until);
    if (!time) {
        return time;
    }
    const Vec3 p = segment.position_at(*time);
    const Vec2 along = face.to - face.from;
    const double fraction = (Vec2(p.x, p.y) - face.from).dot(along) / along.dot(along);
    const bool is_behind =
        (Vec2(p.x, p.y) - face.from).dot(face.normal) < -0.5 * distance;  // far outside
    return fraction >= 0 && fraction <= 1 && !is_behind ? time : std::nullopt;
}

/// A box around all places of a body that rests, or moves along a straight path, in [now, until].
Aabb reach_of(const MovingBody& body, double now, double until) {
    const Vec3 start = body.segment.position_at(now);
    Aabb box{start, start};
    box.extend(body.segment.position_at(until));
    box.grow(body.bounding_radius() + kBallMargin);
    return box;
}

}  // namespace

double nose_contact_distance(double radius, double z, double nose_height) {
    const double d = nose_height - z;
    const double square = radius * radius - d * d;
    return square > 0 ? std::sqrt(square) : 0;
}

EventPredictor::EventPredictor(const StaticEnvironment& environment, const Bodies& bodies)
    : environment_(environment),
      balls_(bodies.balls()),
      bodies_(bodies.all()),
      grid_(cell_width(balls_), balls_.size()),
      next_search_(balls_.size(), kNever),
      last_predicted_(balls_.size(), 0) {}

void EventPredictor::predict(const std::vector<std::uint32_t>& changed,
                             const SearchHorizon& horizon, PredictedEventQueue& queue) {
    ++predict_count_;
    for (const std::uint32_t index : changed) {
        grid_.place(index, balls_[index].segment.position_at(horizon.now));
    }
    for (const std::uint32_t index : changed) {
        predict_ball(index, horizon, queue);
    }
}

void EventPredictor::predict_ball(std::uint32_t index, const SearchHorizon& horizon,
                                  PredictedEventQueue& queue) {
    const MovingBody& ball = balls_[index];
    const double now = horizon.now;
    const double end = ball.is_in_solver() ? horizon.step_end : horizon.end;
    const double until = std::min(end, ball.segment.end);
    if (ball.segment.end <= end) {
        push(queue, ball, index, PredictedEventKind::segment_end, 0,
             std::max(now, ball.segment.end));
    }
    if (ball.is_gone()) {
        next_search_[index] = kNever;
        return;
    }
    grid_.find_near(index, neighbours_);
    for (const std::uint32_t other : neighbours_) {
        // A pair of changed balls is predicted once, with the first of them.
        if (last_predicted_[other] != predict_count_) {
            predict_ball_impact(index, other, now, until, queue);
        }
    }
    last_predicted_[index] = predict_count_;
    predict_cell_crossing(index, now, until, queue);
    search_obstacles(index, horizon, queue);
    const bool moves_freely = !ball.is_still() && !ball.is_in_solver();
    if (!moves_freely || ball.segment.kind == MotionKind::spinning) {
        return;
    }
    predict_fixed_sphere_impacts(index, now, until, queue);
    if (ball.ground == SupportPlane::cloth && environment_.has_cushions) {
        predict_cloth_events(index, now, until, queue);
    }
}

void EventPredictor::predict_cell_crossing(std::uint32_t index, double now, double until,
                                           PredictedEventQueue& queue) const {
    const MovingBody& ball = balls_[index];
    if (ball.is_still() || ball.segment.kind == MotionKind::spinning) {
        return;
    }
    if (const auto crossing = grid_.next_crossing(index, ball.segment, now, until)) {
        push(queue, ball, index, PredictedEventKind::cell_crossing,
             static_cast<std::size_t>(crossing->to), crossing->time);
    }
}

void EventPredictor::enter_cell(const PredictedEvent& crossing, const SearchHorizon& horizon,
                                PredictedEventQueue& queue) {
    const std::uint32_t index = crossing.first;
    const MovingBody& ball = balls_[index];
    const auto side = static_cast<CellGrid::Side>(crossing.second);
    const double end = ball.is_in_solver() ? horizon.step_end : horizon.end;
    const double until = std::min(end, ball.segment.end);
    grid_.cross(index, side);
    grid_.find_ahead(index, side, neighbours_);
    for (const std::uint32_t other : neighbours_) {
        predict_ball_impact(index, other, horizon.now, until, queue);
    }
    predict_cell_crossing(index, horizon.now, until, queue);
}

void EventPredictor::predict_ball_impact(std::uint32_t index, std::uint32_t other, double now,
                                         double until, PredictedEventQueue& queue) const {
    const MovingBody& ball = balls_[index];
    const MovingBody& other_ball = balls_[other];
    if ((ball.is_still() && other_ball.is_still()) || ball.is_gone() || other_ball.is_gone()) {
        return;
    }
    // ODE handles pairs in which it has both balls.
    if ((ball.is_in_solver() && (other_ball.is_in_solver() || other_ball.is_asleep())) ||
        (ball.is_asleep() && other_ball.is_in_solver())) {
        return;
    }
    const double end = std::min(until, other_ball.segment.end);
    const auto time = ball_impact_time(ball.segment, other_ball.segment,
                                       ball.radius + other_ball.radius, now, end);
    if (!time) {
        return;
    }
    const auto [low, high] = std::minmax(index, other);
    queue.push(
        {*time, PredictedEventKind::ball, low, high, balls_[low].version, balls_[high].version});
}

/// Obstacles whose search walks a tree or advances in steps are searched for only a short time
/// ahead.
void EventPredictor::search_obstacles(std::uint32_t index, const SearchHorizon& horizon,
                                      PredictedEventQueue& queue) {
    const MovingBody& ball = balls_[index];
    next_search_[index] = kNever;
    if (ball.is_in_solver() || ball.is_asleep()) {
        return;
    }
    const bool is_flying = ball.ground == SupportPlane::none && !ball.is_still();
    const bool has_solids = bodies_.size() > balls_.size();
    if (!is_flying && !has_solids && environment_.scenery_mesh.empty() &&
        environment_.solids.empty()) {
        return;
    }
    const double segment_end = std::min(horizon.end, ball.segment.end);
    const double until = std::min(segment_end, horizon.now + search_duration(ball, horizon.now));
    predict_solid_impacts(index, horizon.now, std::min(until, horizon.step_end), queue);
    if (ball.is_still()) {
        return;
    }
    predict_scenery_impacts(index, horizon.now, until, queue);
    if (is_flying) {
        predict_flight_events(index, horizon.now, until, queue);
    }
    if (until < segment_end) {
        next_search_[index] = until;
        push(queue, ball, index, PredictedEventKind::search_again, 0, until);
    }
}

void EventPredictor::search_again(const PredictedEvent& search, const SearchHorizon& horizon,
                                  PredictedEventQueue& queue) {
    if (next_search_[search.first] == search.time) {
        search_obstacles(search.first, horizon, queue);
    }
}

/// Of the pairs of a resting ball and a solid, of which there may be very many, only those are
/// tested in which the solid moves, and may reach the ball during ODE's step.
void EventPredictor::predict_all_solid_impacts(const SearchHorizon& horizon,
                                               PredictedEventQueue& queue) {
    ++solid_version_;
    if (balls_.empty()) {
        return;
    }
    std::vector<std::uint32_t> moving_solids;
    std::vector<Aabb> boxes;
    for (auto i = static_cast<std::uint32_t>(balls_.size()); i < bodies_.size(); ++i) {
        if (bodies_[i].is_in_solver()) {
            moving_solids.push_back(i);
            boxes.push_back(reach_of(bodies_[i], horizon.now, horizon.step_end));
        }
    }
    const AabbTree tree(boxes);
    std::vector<std::uint32_t> found;
    for (std::uint32_t i = 0; i < balls_.size(); ++i) {
        const MovingBody& ball = balls_[i];
        if (ball.is_in_solver() || ball.is_asleep() || ball.is_gone()) {
            continue;
        }
        // Without a next search the prediction extends to the end of the segment.
        const double until = std::min({horizon.step_end, ball.segment.end, next_search_[i]});
        if (!ball.is_still()) {
            predict_solid_impacts(i, horizon.now, until, queue);
            continue;
        }
        tree.query(reach_of(ball, horizon.now, until), found);
        for (const std::uint32_t index : found) {
            predict_solid_impact(i, moving_solids[index], horizon.now, until, queue);
        }
    }
}

void EventPredictor::predict_solid_impacts(std::uint32_t index, double now, double until,
                                           PredictedEventQueue& queue) const {
    for (auto i = static_cast<std::uint32_t>(balls_.size()); i < bodies_.size(); ++i) {
        if (!balls_[index].is_still() || bodies_[i].is_in_solver()) {
            predict_solid_impact(index, i, now, until, queue);
        }
    }
}

void EventPredictor::predict_solid_impact(std::uint32_t index, std::uint32_t solid, double now,
                                          double until, PredictedEventQueue& queue) const {
    const MovingBody& ball = balls_[index];
    push(queue, ball, index, PredictedEventKind::solid, solid,
         convex_impact_time(ball.segment, ball.radius, bodies_[solid].motion(), now, until),
         solid_version_);
}

void EventPredictor::predict_scenery_impacts(std::uint32_t index, double now, double until,
                                             PredictedEventQueue& queue) const {
    const MovingBody& ball = balls_[index];
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

void EventPredictor::predict_fixed_sphere_impacts(std::uint32_t index, double now, double until,
                                                  PredictedEventQueue& queue) const {
    const MovingBody& ball = balls_[index];
    for (std::size_t i = 0; i < environment_.spheres.size(); ++i) {
        const FixedSphere& sphere = environment_.spheres[i];
        push(queue, ball, index, PredictedEventKind::fixed_sphere, i,
             point_impact_time(ball.segment, sphere.centre, ball.radius + sphere.radius, now,
                               until));
    }
}

void EventPredictor::predict_cloth_events(std::uint32_t index, double now, double until,
                                          PredictedEventQueue& queue) const {
    const MovingBody& ball = balls_[index];
    const double z = ball.segment.state.position.z;
    const double distance = nose_contact_distance(ball.radius, z, environment_.nose_height);
    const billiards::TableGeometry& table = environment_.table();
    for (std::size_t i = 0; i < table.faces.size(); ++i) {
        push(queue, ball, index, PredictedEventKind::cushion_face, i,
             level_face_impact_time(ball.segment, table.faces[i], distance, now, until));
    }
    for (std::size_t i = 0; i < table.corners.size(); ++i) {
        const billiards::CushionCorner& corner = table.corners[i];
        push(queue, ball, index, PredictedEventKind::cushion_corner, i,
             point_impact_time(ball.segment, in_space(corner.centre, z), distance + corner.radius,
                               now, until));
    }
    for (std::size_t i = 0; i < table.pockets.size(); ++i) {
        const billiards::Pocket& pocket = table.pockets[i];
        push(
            queue, ball, index, PredictedEventKind::pocket_edge, i,
            point_impact_time(ball.segment, in_space(pocket.centre, z), pocket.radius, now, until));
    }
}

void EventPredictor::predict_flight_events(std::uint32_t index, double now, double until,
                                           PredictedEventQueue& queue) const {
    const MovingBody& ball = balls_[index];
    // A ball under the table does not land on the cloth.
    constexpr double kDeepest = 1e-4;  // m
    const double height = ball.segment.position_at(now).z;
    if (environment_.has_cloth && height > ball.radius - kDeepest) {
        const auto time =
            plane_impact_time(ball.segment, Vec3(0, 0, 0), kUp, ball.radius, now, until);
        // A ball that is just passing over a hole's edge counts as being where it will be next.
        constexpr double kAhead = 1e-7;  // s
        if (time && environment_.is_over_cloth(ball.segment.position_at(*time + kAhead))) {
            push(queue, ball, index, PredictedEventKind::ground,
                 static_cast<std::size_t>(SupportPlane::cloth), time);
        }
    }
    if (environment_.floor_height) {
        push(queue, ball, index, PredictedEventKind::ground,
             static_cast<std::size_t>(SupportPlane::floor),
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
            environment_.collided->mesh.first_impact(ball.segment, ball.radius, now, until)) {
        push(queue, ball, index, PredictedEventKind::table_feature, impact->feature, impact->time);
    }
    for (std::size_t i = 0; i < environment_.collided->pocket_edges.size(); ++i) {
        const auto time = environment_.collided->pocket_edges[i].impact_time(
            ball.segment, ball.radius, now, until);
        // Over the cloth the ball touches the plane, not the rim.
        if (time &&
            environment_.pocket_below(ball.segment.position_at(*time)) == static_cast<int>(i)) {
            push(queue, ball, index, PredictedEventKind::pocket_edge_hit, i, time);
        }
    }
    if (!ball.is_potted && !ball.is_off_table) {
        push(queue, ball, index, PredictedEventKind::below_cloth, 0,
             plane_impact_time(ball.segment, Vec3(0, 0, 0), kUp, 0, now, until));
    }
}

}  // namespace carom::sim
