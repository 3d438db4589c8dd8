// Single balls on the cloth follow closed forms. Here ODE integrates the same segments and has to
// arrive at the same states. Without the following measures ODE's error is decimetres over a shot:
// - the contact with the cloth is created explicitly, at depth 0, with its first friction direction
//   along the slip and rolling friction only while the ball rolls;
// - steps end where the law of motion changes;
// - ODE's step is semi-implicit Euler, so positions advance with the mean of both velocities;
// - an orientation turns by h (w0 + w1) / 2 + h^2/12 w1 x w0 (fourth-order Magnus).
#include <algorithm>
#include <cmath>
#include <memory>

#include <gtest/gtest.h>
#include <ode/ode.h>

#include "sim/motion/cloth_motion.h"
#include "sim/ode/process.h"
#include "sim/timeline/rotation.h"
#include "tests/sim/shots.h"

namespace carom::sim::test {
namespace {

const FrictionCoefficients kLaw{0.2, 0.01, 0.0127};

/// One ball on the cloth in a world of ODE.
class OdeBall {
  public:
    explicit OdeBall(const MotionState& state) : state_(state) {
        dWorldSetGravity(world_, 0, 0, -kGravity);
        dMass mass;
        dMassSetSphereTotal(&mass, kMass, kRadius);
        dBodySetMass(body_, &mass);
        dBodySetGyroscopicMode(body_, 0);
        dBodySetFiniteRotationMode(body_, 1);
    }
    OdeBall(const OdeBall&) = delete;
    OdeBall& operator=(const OdeBall&) = delete;
    ~OdeBall() {
        dJointGroupDestroy(contacts_);
        dWorldDestroy(world_);
    }

    [[nodiscard]] const MotionState& state() const { return state_; }

    void step(double h, MotionKind kind) {
        const MotionState before = state_;
        dBodySetPosition(body_, before.position.x, before.position.y, before.position.z);
        dBodySetLinearVel(body_, before.velocity.x, before.velocity.y, before.velocity.z);
        const Vec3& w = before.angular_velocity;
        dBodySetAngularVel(body_, w.x, w.y, w.z);
        const dContact contact = cloth_contact(kind);
        dJointAttach(dJointCreateContact(world_, contacts_, &contact), body_, nullptr);
        dWorldStep(world_, h);
        dJointGroupEmpty(contacts_);
        const dReal* v = dBodyGetLinearVel(body_);
        const dReal* after = dBodyGetAngularVel(body_);
        state_.velocity = {v[0], v[1], 0};
        state_.angular_velocity = {after[0], after[1], after[2]};
        state_.position = before.position + (before.velocity + state_.velocity) * (0.5 * h);
        state_.position.z = kRadius;
        const Vec3 turn = (w + state_.angular_velocity) * (0.5 * h) +
                          state_.angular_velocity.cross(w) * (h * h / 12);
        state_.orientation = rotation_from_vector(turn) * before.orientation;
    }

  private:
    [[nodiscard]] dContact cloth_contact(MotionKind kind) const {
        dContact contact{};
        contact.surface.mode = dContactApprox1 | dContactFDir1 | dContactRolling | dContactAxisDep;
        contact.surface.mu = kLaw.sliding_friction;
        const bool rolls = kind == MotionKind::rolling;
        contact.surface.rho = contact.surface.rho2 =
            rolls ? 1.4 * kLaw.rolling_friction * kRadius : 0;
        contact.surface.rhoN = kLaw.spinning_friction * kRadius;
        Vec3 direction = rolls ? state_.velocity : slip_velocity(state_, kRadius);
        direction = direction.length() > 0 ? direction / direction.length() : Vec3(1, 0, 0);
        for (int i = 0; i < 3; ++i) {
            contact.geom.pos[i] = state_.position[i] - (i == 2 ? kRadius : 0);
            contact.geom.normal[i] = i == 2 ? 1 : 0;
            contact.fdir1[i] = direction[i];
        }
        return contact;
    }

    ode::ThreadGuard guard_;
    dWorldID world_ = dWorldCreate();
    dBodyID body_ = dBodyCreate(world_);
    dJointGroupID contacts_ = dJointGroupCreate(0);
    MotionState state_;
};

struct Errors {
    double position = 0, velocity = 0, spin = 0, orientation = 0;
    int segments = 0;
};

/// Moves the ball for `duration` by the closed forms, and by ODE in steps of at most `h`.
Errors compare(MotionState state, double h, double duration) {
    OdeBall ode(state);
    Errors worst;
    double now = 0;
    while (now < duration) {
        const MotionSegment segment = cloth_segment(now, state, kRadius, kGravity, kLaw);
        ++worst.segments;
        const double end = std::min(segment.end, duration);
        while (now < end && segment.kind != MotionKind::resting) {
            const double next = std::min(now + h, end);
            ode.step(next - now, segment.kind);
            now = next;
            const MotionState exact = segment.state_at(now);
            worst.position =
                std::max(worst.position, (exact.position - ode.state().position).length());
            worst.velocity =
                std::max(worst.velocity, (exact.velocity - ode.state().velocity).length());
            worst.spin = std::max(
                worst.spin,
                (exact.angular_velocity - ode.state().angular_velocity).length() * kRadius);
            const Quat& q = ode.state().orientation;
            const double cosine = exact.orientation.r * q.r + exact.orientation.v.dot(q.v);
            worst.orientation =
                std::max(worst.orientation, 2 * std::sqrt(2 * std::max(0.0, 1 - std::abs(cosine))));
        }
        state = segment.state_at(end);
        now = end;
    }
    return worst;
}

TEST(ClosedForm_OfEveryLaw, AgreesWithOde) {
    struct Start {
        Vec3 velocity, spin;
    };
    const Start starts[] = {
        {{2, 0, 0}, {0, 0, 0}},           // stun
        {{1.5, 1, 0}, {-20, 40, 30}},     // follow with side
        {{2, -0.5, 0}, {30, -120, -50}},  // draw: slides and returns
        {{1.5, 0.4, 0}, {60, -70, 90}},   // masse
        {{0.3, 0.2, 0}, rolling_spin({0.3, 0.2, 0})},
        {{0, 0, 0}, {0, 0, 25}},  // spins in place
    };
    for (const Start& start : starts) {
        MotionState state;
        state.position = {0.1, -0.2, kRadius};
        state.velocity = start.velocity;
        state.angular_velocity = start.spin;
        const Errors worst = compare(state, 1.0 / 240, 6);
        SCOPED_TRACE(std::to_string(start.velocity.x) + " " + std::to_string(start.spin.x));
        EXPECT_GE(worst.segments, start.velocity.x == 0 ? 2 : 1);
        EXPECT_LT(worst.position, 1e-7);
        EXPECT_LT(worst.velocity, 1e-7);
        EXPECT_LT(worst.spin, 1e-7);
        EXPECT_LT(worst.orientation, 1e-4);
    }
}

}  // namespace
}  // namespace carom::sim::test
