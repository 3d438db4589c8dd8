#include "sim/scheduler/impact_resolver.h"

#include <cmath>

#include "core/length.h"
#include "sim/impact/cushion_impact.h"
#include "sim/scheduler/contact_table.h"
#include "sim/scheduler/touch_finder.h"

namespace carom::sim {
namespace {

/// Restitution and friction of two balls that meet.
ContactNumbers pair_law(const Surroundings& around, const Ball& a, const Ball& b,
                        double slip_speed) {
    ContactNumbers law = around.contacts.between(a.material, b.material);
    if (a.material == MaterialId::ball && b.material == MaterialId::ball) {
        law.friction = ball_friction(around.law.ball_ball, slip_speed);
    }
    return law;
}

/// The foot of the perpendicular from `point` to the nose line of a face.
Vec2 nearest_on(const billiards::CushionFace& face, const Vec2& point) {
    return point - face.normal * (point - face.from).dot(face.normal);
}

Vec2 nearest_on(const billiards::CushionCorner& corner, const Vec2& point) {
    const Vec2 d = point - corner.centre;
    return corner.centre + d * (corner.radius / std::sqrt(d.dot(d)));
}

/// A ball in the air, or against something that is not upright, that parts this slowly stays in
/// touch: ODE carries it on.
bool stays_in_touch(const Ball& ball, double separation, const Vec3& normal) {
    return separation < kLandingSpeed && (ball.ground == Ground::none || std::abs(normal.z) > 1e-6);
}

}  // namespace

void ImpactResolver::resolve(const Touch& touch) {
    const Vec3 centre = balls_[touch.first].stretch.position_at(touch.time);
    const Vec2 level(centre.x, centre.y);
    switch (touch.kind) {
        case TouchKind::ball:
            return meet_ball(touch);
        case TouchKind::box:
            return meet_box(touch);
        case TouchKind::cushion_face:
            return meet_cushion(touch, nearest_on(around_.table.faces[touch.second], level));
        case TouchKind::cushion_corner:
            return meet_cushion(touch, nearest_on(around_.table.corners[touch.second], level));
        case TouchKind::pocket_edge:
            return enter_pocket(touch);
        case TouchKind::rim:
        case TouchKind::table_feature:
        case TouchKind::scenery_feature:
        case TouchKind::fixed_sphere:
        case TouchKind::fixed_solid:
            return meet_surface(touch);
        case TouchKind::ground:
            return land(touch);
        case TouchKind::slate_underside:
            return meet_slate_from_below(touch);
        case TouchKind::below_cloth:
            return sink(touch);
        case TouchKind::stretch_end:
            return balls_.go_on(touch.first, touch.time);
        case TouchKind::line:
        case TouchKind::cell_crossing:
        case TouchKind::look_again:  // the scheduler's
            break;
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
    const ContactNumbers law = pair_law(around_, a, b, std::sqrt(slip.dot(slip)));
    const ImpulsePair impulse =
        ball_ball_impact(balls_.solver(), body_a, body_b, normal, law.restitution, law.friction);
    // The reference models leave out what would make balls on the cloth hop.
    if (!around_.law.hop && a.ground != Ground::none && b.ground != Ground::none) {
        body_a.state.velocity.z = 0;
        body_b.state.velocity.z = 0;
    }
    if (approach > kQuietSpeed) {
        recording_.log_impact(touch.time, a.name, b.name, before_a.position - normal * a.radius,
                              normal, impulse);
    }
    const double separation = (body_a.state.velocity - body_b.state.velocity).dot(normal);
    const bool stay =
        stays_in_touch(a, separation, normal) || stays_in_touch(b, separation, normal);
    leave_lying(touch.first, touch.time);
    leave_lying(touch.second, touch.time);
    balls_.change(touch.first, touch.time, before_a, body_a.state);
    balls_.change(touch.second, touch.time, before_b, body_b.state);
    if (stay) {
        balls_.hand_to_ode(touch.first, touch.time);
        balls_.hand_to_ode(touch.second, touch.time);
    }
}

void ImpactResolver::leave_lying(std::uint32_t index, double time) {
    const Ball& ball = balls_[index];
    if (ball.is_lying) {
        stepped_.wake_near(ball.stretch.state.position, ball.radius, time);
    }
}

void ImpactResolver::meet_box(const Touch& touch) {
    const Ball& ball = balls_[touch.first];
    const StepBody& box = stepped_.all()[touch.second];
    BallBody body = ball.body_at(touch.time);
    const MotionState before = body.state;
    const Pose box_pose{box.state.position, box.state.orientation};
    const SurfaceContact contact =
        convex_contact(*box.shape, box_pose, before.position, ball.radius);
    const auto separation = [&](const Vec3& ball_velocity, const ode::Velocities& box_velocities) {
        const Vec3 arm = contact.point - box_pose.position;
        return (ball_velocity - box_velocities.linear - box_velocities.angular.cross(arm))
            .dot(contact.normal);
    };
    const ode::Velocities box_before{box.state.velocity, box.state.angular_velocity};
    const double approach = -separation(before.velocity, box_before);
    if (approach <= 0) {
        return balls_.hand_to_ode(touch.first, touch.time);
    }
    const ContactNumbers& law = around_.contacts.between(ball.material, box.material);
    const ode::ImpactBody ball_part{ball.mass,
                                    Vec3(0.4 * ball.mass * ball.radius * ball.radius),
                                    {before.position, Quat()},
                                    {before.velocity, before.angular_velocity}};
    const ode::ImpactBody box_part{box.mass, box.inertia, box_pose, box_before};
    const ode::ImpactContact impact{contact.point, contact.normal, law.restitution, law.friction};
    ode::ImpactResult result;
    if (box.is_kinematic()) {
        result = balls_.solver().solve_moved(ball_part, box.velocity_at(contact.point), impact);
        result.second = box_before;
    } else {
        result = balls_.solver().solve(ball_part, box_part, impact);
    }
    if (approach > kQuietSpeed) {
        recording_.log_impact(touch.time, ball.name, *box.name, contact.point, contact.normal,
                              {result.normal_impulse, result.tangential_impulse});
    }
    body.state.velocity = result.first.linear;
    body.state.angular_velocity = result.first.angular;
    const bool stay = separation(result.first.linear, result.second) < kLandingSpeed;
    stepped_.change_box(touch.second, touch.time, result.second.linear, result.second.angular);
    balls_.change(touch.first, touch.time, before, body.state);
    if (stay) {
        balls_.hand_to_ode(touch.first, touch.time);
    }
}

void ImpactResolver::meet_surface(const Touch& touch) {
    const Ball& ball = balls_[touch.first];
    const Vec3 centre = ball.stretch.position_at(touch.time);
    if (touch.kind == TouchKind::rim) {
        bounce(touch, around_.rims[touch.second].contact(centre, ball.radius),
               {"cloth", MaterialId::cloth});
    } else if (touch.kind == TouchKind::fixed_sphere) {
        const FixedSphere& sphere = around_.spheres[touch.second];
        const Vec3 normal = unit(centre - sphere.centre);
        bounce(touch, {sphere.centre + normal * sphere.radius, normal, 0, 0}, sphere.info);
    } else if (touch.kind == TouchKind::fixed_solid) {
        const FixedSolid& solid = around_.solids[touch.second];
        bounce(touch, convex_contact(*solid.shape, solid.pose, centre, ball.radius), solid.info);
    } else {
        const bool is_table = touch.kind == TouchKind::table_feature;
        const StaticMesh& mesh = is_table ? around_.table_mesh : around_.scenery_mesh;
        const SurfaceContact contact = mesh.contact(touch.second, centre, ball.radius);
        bounce(touch, contact, around_.surfaces[contact.surface]);
    }
}

/// It is as hard as the rails' wood.
void ImpactResolver::meet_slate_from_below(const Touch& touch) {
    const Ball& ball = balls_[touch.first];
    const Vec3 down(0, 0, -1);
    const Vec3 top = ball.stretch.position_at(touch.time) - down * ball.radius;
    bounce(touch, {top, down, 0, 0}, {"rail", MaterialId::rail});
}

void ImpactResolver::bounce(const Touch& touch, const SurfaceContact& contact,
                            const SurfaceInfo& info) {
    const Ball& ball = balls_[touch.first];
    BallBody body = ball.body_at(touch.time);
    const MotionState before = body.state;
    const double approach = -before.velocity.dot(contact.normal);
    const ContactNumbers& law = around_.contacts.between(ball.material, info.material);
    const ImpulsePair impulse =
        is_lining(info.material, contact.normal)
            ? lining_impact(body, contact.normal, law.restitution, law.friction)
            : ball_static_impact(balls_.solver(), body, contact.normal, law.restitution,
                                 law.friction);
    if (!around_.law.hop && ball.ground != Ground::none && std::abs(contact.normal.z) < 1e-6) {
        body.state.velocity.z = 0;
    }
    if (approach > kQuietSpeed) {
        recording_.log_impact(touch.time, ball.name, info.name, contact.point, contact.normal,
                              impulse);
    }
    const bool stay = stays_in_touch(ball, body.state.velocity.dot(contact.normal), contact.normal);
    balls_.change(touch.first, touch.time, before, body.state);
    if (stay) {
        balls_.hand_to_ode(touch.first, touch.time);
    }
}

void ImpactResolver::meet_cushion(const Touch& touch, const Vec2& nearest) {
    const Ball& ball = balls_[touch.first];
    BallBody body = ball.body_at(touch.time);
    const MotionState before = body.state;
    const Vec3 nose(nearest.x, nearest.y, around_.nose_height);
    const Vec3 normal = unit(before.position - nose);
    const Vec3 inward = unit(Vec3(normal.x, normal.y, 0));
    const double approach = -before.velocity.dot(inward);
    ImpulsePair impulse;
    if (ball.material == MaterialId::ball) {
        impulse = cushion_impact(body, inward, normal, around_.law);
    } else {
        const ContactNumbers& law = around_.contacts.between(ball.material, MaterialId::cushion);
        impulse = ball_static_impact(balls_.solver(), body, normal, law.restitution, law.friction);
    }
    if (!around_.law.hop) {
        body.state.velocity.z = 0;
    }
    const double separation = body.state.velocity.dot(inward);
    if (separation < kLeastSeparation) {
        body.state.velocity += inward * (kLeastSeparation - separation);
    }
    if (approach > kQuietSpeed) {
        recording_.log_impact(touch.time, ball.name, "cushion", nose, normal, impulse);
    }
    balls_.change(touch.first, touch.time, before, body.state);
}

/// A ball that comes over the edge faster than sqrt(g R) leaves it at once: the edge would have to
/// pull it down. A slower one turns over the edge first.
void ImpactResolver::enter_pocket(const Touch& touch) {
    const Ball& ball = balls_[touch.first];
    const Vec3 centre = ball.stretch.position_at(touch.time);
    const billiards::Pocket& pocket = around_.table.pockets[touch.second];
    const Vec3 inward = unit(Vec3(pocket.centre.x - centre.x, pocket.centre.y - centre.y, 0));
    const double speed = ball.stretch.velocity_at(touch.time).dot(inward);
    if (speed * speed > around_.downward_gravity * ball.radius) {
        balls_.fall(touch.first, touch.time);
    } else {
        recording_.keep(ball.track, touch.time, ball.stretch.state_at(touch.time));
        balls_.hand_to_ode(touch.first, touch.time);
    }
}

void ImpactResolver::sink(const Touch& touch) {
    const Ball& ball = balls_[touch.first];
    balls_.note_sunk(touch.first, touch.time, ball.stretch.position_at(touch.time));
    balls_.go_on(touch.first, touch.time);
}

void ImpactResolver::land(const Touch& touch) {
    Ball& ball = balls_[touch.first];
    const auto ground = static_cast<Ground>(touch.second);
    const MotionState before = ball.stretch.state_at(touch.time);
    if (around_.downward_gravity <= 0) {
        const Vec3 up(0, 0, 1);
        bounce(
            touch, {before.position - up * ball.radius, up, 0, 0},
            {ground_name(ground), ground == Ground::floor ? MaterialId::floor : MaterialId::cloth});
        return;
    }
    ball.ground = ground;
    balls_.change(touch.first, touch.time, before, before);
}

}  // namespace carom::sim
