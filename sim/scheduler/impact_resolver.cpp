#include "sim/scheduler/impact_resolver.h"

#include <cmath>

#include "sim/impact/cushion_impact.h"
#include "sim/scheduler/touch_finder.h"

namespace carom::sim {
namespace {

Vec3 unit(const Vec3& v) {
    return v / std::sqrt(v.dot(v));
}

/// Restitution and friction of two balls that meet.
PairContact pair_law(const ContactLaw& law, const Ball& a, const Ball& b, double slip_speed) {
    if (a.material != "ball" || b.material != "ball")
        return law.between(a.material, b.material);
    return {law.ball_ball.restitution, ball_friction(law.ball_ball, slip_speed), 0};
}

/// The foot of the perpendicular from `point` to the nose line of a face.
Vec2 nearest_on(const billiards::CushionFace& face, const Vec2& point) {
    return point - face.normal * (point - face.from).dot(face.normal);
}

Vec2 nearest_on(const billiards::CushionCorner& corner, const Vec2& point) {
    const Vec2 d = point - corner.centre;
    return corner.centre + d * (corner.radius / std::sqrt(d.dot(d)));
}

}  // namespace

void ImpactResolver::resolve(const Touch& touch) {
    const Vec3 centre = balls_[touch.first].stretch.position_at(touch.time);
    const Vec2 level(centre.x, centre.y);
    switch (touch.kind) {
        case TouchKind::ball:
            return meet_ball(touch);
        case TouchKind::cushion_face:
            return meet_cushion(touch, nearest_on(around_.table.faces[touch.second], level));
        case TouchKind::cushion_corner:
            return meet_cushion(touch, nearest_on(around_.table.corners[touch.second], level));
        case TouchKind::pocket_edge:
            return enter_pocket(touch);
        case TouchKind::below_cloth:
            return sink(touch);
        case TouchKind::pocket_wall:
            return meet_pocket_wall(touch);
        case TouchKind::ground:
            return land(touch);
        case TouchKind::stretch_end:
            return balls_.go_on(touch.first, touch.time);
    }
}

void ImpactResolver::meet_ball(const Touch& touch) {
    Ball& a = balls_[touch.first];
    Ball& b = balls_[touch.second];
    BallBody body_a = a.body_at(touch.time);
    BallBody body_b = b.body_at(touch.time);
    const MotionState before_a = body_a.state;
    const MotionState before_b = body_b.state;
    const Vec3 normal = unit(before_a.position - before_b.position);
    const double approach = -(before_a.velocity - before_b.velocity).dot(normal);
    const Vec3 slip = contact_slip(body_a, body_b, normal);
    const PairContact law = pair_law(around_.law, a, b, std::sqrt(slip.dot(slip)));
    const ImpulsePair impulse =
        ball_ball_impact(balls_.solver(), body_a, body_b, normal, law.restitution, law.friction);
    // The reference models leave out what would make balls on the cloth hop.
    if (!around_.law.hop && a.ground != Ground::none && b.ground != Ground::none) {
        body_a.state.velocity.z = 0;
        body_b.state.velocity.z = 0;
    }
    if (approach > kQuietSpeed)
        recording_.log_impact(touch.time, a.name, b.name, before_a.position - normal * a.radius,
                              normal, impulse);
    balls_.change(touch.first, touch.time, before_a, body_a.state);
    balls_.change(touch.second, touch.time, before_b, body_b.state);
}

void ImpactResolver::meet_cushion(const Touch& touch, const Vec2& nearest) {
    Ball& ball = balls_[touch.first];
    BallBody body = ball.body_at(touch.time);
    const MotionState before = body.state;
    const Vec3 nose(nearest.x, nearest.y, around_.nose_height);
    const Vec3 normal = unit(before.position - nose);
    const Vec3 inward = unit(Vec3(normal.x, normal.y, 0));
    const bool on_ground = ball.ground != Ground::none;
    const double approach = -before.velocity.dot(on_ground ? inward : normal);
    ImpulsePair impulse;
    if (ball.material == "ball" && on_ground) {
        impulse = cushion_impact(body, inward, normal, around_.law.ball_cushion);
    } else {
        PairContact law = around_.law.between(ball.material, "cushion");
        if (ball.material == "ball")
            law = {around_.law.ball_cushion.restitution, around_.law.ball_cushion.friction, 0};
        impulse = ball_static_impact(balls_.solver(), body, normal, law.restitution, law.friction);
    }
    if (on_ground) {
        if (!around_.law.hop)
            body.state.velocity.z = 0;
        const double separation = body.state.velocity.dot(inward);
        if (separation < kLeastSeparation)
            body.state.velocity += inward * (kLeastSeparation - separation);
    }
    if (approach > kQuietSpeed)
        recording_.log_impact(touch.time, ball.name, "cushion", nose, normal, impulse);
    balls_.change(touch.first, touch.time, before, body.state);
}

void ImpactResolver::meet_pocket_wall(const Touch& touch) {
    Ball& ball = balls_[touch.first];
    BallBody body = ball.body_at(touch.time);
    const MotionState before = body.state;
    const billiards::Pocket& pocket = around_.table.pockets[touch.second];
    const Vec3 normal =
        unit(Vec3(pocket.centre.x - before.position.x, pocket.centre.y - before.position.y, 0));
    const double approach = -before.velocity.dot(normal);
    const GroundLaw& law = ball.pocket_law;
    const ImpulsePair impulse =
        ball_static_impact(balls_.solver(), body, normal, law.restitution, law.friction);
    if (approach > kQuietSpeed)
        recording_.log_impact(touch.time, ball.name, "pocket",
                              before.position - normal * ball.radius, normal, impulse);
    balls_.change(touch.first, touch.time, before, body.state);
}

void ImpactResolver::enter_pocket(const Touch& touch) {
    balls_[touch.first].pocket = static_cast<int>(touch.second);
    balls_.fall(touch.first, touch.time);
}

void ImpactResolver::sink(const Touch& touch) {
    Ball& ball = balls_[touch.first];
    ball.is_potted = true;
    const Vec3 centre = ball.stretch.position_at(touch.time);
    recording_.log(EventKind::potted, touch.time, ball.name, centre,
                   around_.table.pockets[touch.second].name);
    balls_.go_on(touch.first, touch.time);
}

void ImpactResolver::land(const Touch& touch) {
    Ball& ball = balls_[touch.first];
    const MotionState before = ball.stretch.state_at(touch.time);
    const auto ground = static_cast<Ground>(touch.second);
    if (ground == Ground::cloth && !around_.is_over_cloth(before.position)) {
        ball.pocket = around_.pocket_below(before.position);
        ball.is_off_table = ball.pocket < 0;
        if (ball.is_off_table)
            recording_.log(EventKind::off_table, touch.time, ball.name, before.position);
        balls_.go_on(touch.first, touch.time);
        return;
    }
    ball.ground = ground;
    balls_.change(touch.first, touch.time, before, before);
}

}  // namespace carom::sim
