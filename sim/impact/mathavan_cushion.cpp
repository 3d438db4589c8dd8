#include "sim/impact/mathavan_cushion.h"

#include <algorithm>
#include <utility>

#include "core/length.h"
#include "sim/numeric/false_position.h"

namespace carom::sim {
namespace {

/// Largest steps as a fraction of the approach speed, and of the remaining slip, whose direction
/// turns faster the smaller it is.
constexpr double kMaxStep = 1.0 / 16;
constexpr double kMaxStiffStep = 1.0 / 256;
constexpr double kMaxSlipFraction = 0.3;
/// Slip below this fraction of the ball's speed counts as none.
constexpr double kNoSlip = 1e-10;
/// Limit for a ball wedged under the nose by friction, which would be pressed there forever.
constexpr double kMaxImpulseRatio = 20;  // times the approach; a free ball takes 2 to 4

constexpr int kMaxSteps = 20000;  // some hundreds are usual

/// All quantities are divided by the ball's mass; spin is R w. So impulses and spin are velocities,
/// and an impulse j at the unit direction d from the centre changes the spin by 5/2 d x j.
struct Motion {
    Vec3 velocity;
    Vec3 spin;
    double work = 0;         // of the normal impulse at the nose
    Vec3 friction{0, 0, 0};  // impulse at the nose
};

Motion operator+(const Motion& a, const Motion& b) {
    return {a.velocity + b.velocity, a.spin + b.spin, a.work + b.work, a.friction + b.friction};
}
Motion operator*(const Motion& a, double s) {
    return {a.velocity * s, a.spin * s, a.work * s, a.friction * s};
}

Vec3 across(const Vec3& v, const Vec3& normal) {
    return v - normal * v.dot(normal);
}

Vec3 limited(const Vec3& v, double limit) {
    const double size = length(v);
    return size > limit ? v * (limit / size) : v;
}

/// Tangential velocity of the ball's surface at the contact with this normal (towards the centre).
Vec3 slip(const Motion& motion, const Vec3& normal) {
    return across(motion.velocity - motion.spin.cross(normal), normal);
}

/// Forces per unit of normal force at the nose.
struct Forces {
    Vec3 nose{0, 0, 0};   // friction
    Vec3 cloth{0, 0, 0};  // friction
    double support = 0;   // normal force of the cloth
};

/// Change of the slip at a contact of a solid sphere per unit of impulse there.
constexpr double kResponse = 3.5;

class CushionContact {
  public:
    CushionContact(const Vec3& normal, double friction, double cloth_friction, double no_slip)
        : normal_(normal),
          friction_(friction),
          cloth_friction_(cloth_friction),
          no_slip_(no_slip) {}

    /// The motion after the next step, whose size is at most `approach` times the fractions above.
    [[nodiscard]] Motion advance(const Motion& motion, double approach, double& step) {
        const Slips slips = slips_of(motion);
        const Forces now = forces(motion, slips, 0);
        step = next_step(motion, slips, rate(motion, now), kMaxStep * approach);
        if (is_stiff(slips, now, step)) {
            step = std::min(step, kMaxStiffStep * approach);
        }
        return after(motion, slips, now, step);
    }

    /// The motion after `step`.
    [[nodiscard]] Motion after(const Motion& motion, double step) {
        const Slips slips = slips_of(motion);
        return after(motion, slips, forces(motion, slips, 0), step);
    }

  private:
    /// Of both contacts.
    struct Slips {
        Vec3 nose, cloth;
        double nose_speed, cloth_speed;
    };
    [[nodiscard]] Slips slips_of(const Motion& motion) const {
        const Vec3 nose = slip(motion, normal_);
        const Vec3 cloth = slip(motion, kUp);
        return {nose, cloth, length(nose), length(cloth)};
    }

    /// The motion after `step` under the forces `now` at its beginning, by the classic Runge-Kutta
    /// method; by the implicit midpoint rule where a slip turns faster than it grows or shrinks, as
    /// after sticking.
    [[nodiscard]] Motion after(const Motion& motion, const Slips& slips, const Forces& now,
                               double step) {
        if (is_stiff(slips, now, step)) {
            const Forces middle = forces(motion, slips, 0.5 * step);
            return motion + rate(motion + rate(motion, middle) * (0.5 * step), middle) * step;
        }
        const Motion k1 = rate(motion, now);
        const Motion k2 = rate(motion + k1 * (0.5 * step));
        const Motion k3 = rate(motion + k2 * (0.5 * step));
        const Motion k4 = rate(motion + k3 * step);
        return motion + (k1 + k2 * 2 + k3 * 2 + k4) * (step / 6);
    }

    [[nodiscard]] double next_step(const Motion& motion, const Slips& slips, const Motion& change,
                                   double longest) const {
        const Slips rates = slips_of(change);
        for (const auto& [now, speed] : {std::pair(slips.nose_speed, rates.nose_speed),
                                         std::pair(slips.cloth_speed, rates.cloth_speed)}) {
            if (now > no_slip_ && speed > 0) {
                longest = std::min(longest, kMaxSlipFraction * now / speed);
            }
        }
        // The step ends where a lifted ball lands on the cloth again.
        if (motion.velocity.z > no_slip_ && change.velocity.z < 0) {
            longest = std::min(longest, -motion.velocity.z / change.velocity.z);
        }
        return longest;
    }

    [[nodiscard]] bool is_stiff(const Slips& slips, const Forces& f, double step) const {
        const double nose = slips.nose_speed;
        const double cloth = slips.cloth_speed;
        return (nose > no_slip_ && kResponse * step * friction_ > nose) ||
               (cloth > no_slip_ && kResponse * step * cloth_friction_ * f.support > cloth);
    }

    /// Change of the motion per unit of normal impulse.
    [[nodiscard]] Motion rate(const Motion& motion) {
        return rate(motion, forces(motion, slips_of(motion), 0));
    }

    [[nodiscard]] Motion rate(const Motion& motion, const Forces& f) const {
        const Vec3 torque = f.nose.cross(normal_) + f.cloth.cross(kUp);
        return {normal_ + f.nose + f.cloth + kUp * f.support, torque * 2.5,
                motion.velocity.dot(normal_), f.nose};
    }

    /// The normal force of the cloth balances the downward force at the nose.
    [[nodiscard]] double support(const Motion& motion, const Vec3& nose_friction) const {
        const double down = -(normal_.z + nose_friction.z);
        return motion.velocity.z <= no_slip_ ? std::max(down, 0.0) : 0.0;
    }

    /// Friction against the slip after an impulse of `ahead`. For a contact that slips now and
    /// `ahead` 0, it is known. Otherwise the friction that stops the slip, or the largest possible
    /// one, is found by alternating iteration between the two contacts.
    [[nodiscard]] const Forces& forces(const Motion& motion, const Slips& slips, double ahead) {
        const auto& [nose_slip, cloth_slip, nose_speed, cloth_speed] = slips;
        const bool is_nose_known = ahead == 0 && nose_speed > no_slip_;
        const bool is_cloth_known = ahead == 0 && cloth_speed > no_slip_;
        const double fraction = ahead > 0 ? 1 / ahead : 0;
        Forces& f = forces_;  // the last solution is a good start
        if (is_nose_known) {
            f.nose = nose_slip * (-friction_ / nose_speed);
        }
        for (int i = 0; i < 100; ++i) {
            const Forces last = f;
            if (!is_nose_known) {
                const Vec3 slip_rate = nose_slip * fraction + slip(rate(motion, f), normal_);
                f.nose = limited(f.nose - slip_rate / kResponse, friction_);
            }
            f.support = support(motion, f.nose);
            const double limit = cloth_friction_ * f.support;
            if (is_cloth_known) {
                f.cloth = cloth_slip * (-limit / cloth_speed);
            } else {
                const Vec3 slip_rate = cloth_slip * fraction + slip(rate(motion, f), kUp);
                f.cloth = limited(f.cloth - slip_rate / kResponse, limit);
            }
            if ((is_nose_known && is_cloth_known) ||
                length(f.nose - last.nose) + length(f.cloth - last.cloth) < 1e-14) {
                break;
            }
        }
        return f;
    }

    Vec3 normal_;
    double friction_;
    double cloth_friction_;
    double no_slip_;
    Forces forces_;
};

/// The part of `step` after which `progress` is 0; it is negative before the step and `high_value`
/// >= 0 after it.
template <typename Progress>
double find_end(CushionContact& contact, const Motion& motion, double step, double high_value,
                Progress progress) {
    const double low_value = progress(motion);
    return false_position({0, low_value}, {step, high_value}, 1e-14 * (high_value - low_value),
                          [&](double part) { return progress(contact.after(motion, part)); });
}

/// Integrates `motion` until `progress` of it, which rises, is 0; returns the normal impulse up to
/// then.
template <typename Progress>
double integrate_until(CushionContact& contact, Motion& motion, double approach,
                       Progress progress) {
    double impulse = 0;
    bool is_over = progress(motion) >= 0;
    for (int i = 0; i < kMaxSteps && !is_over && impulse < kMaxImpulseRatio * approach; ++i) {
        double step = 0;
        Motion next = contact.advance(motion, approach, step);
        if (const double value = progress(next); value >= 0) {
            step = find_end(contact, motion, step, value, progress);
            next = contact.after(motion, step);
            is_over = true;
        }
        motion = next;
        impulse += step;
    }
    return impulse;
}

}  // namespace

ImpulsePair mathavan_impact(RigidBody& ball, const Vec3& normal, double restitution,
                            double friction, double cloth_friction) {
    MotionState& state = ball.state;
    const double approach = -state.velocity.dot(normal);
    if (approach <= 0) {
        return {};
    }
    Motion motion{state.velocity, state.angular_velocity * ball.radius, 0};
    const double speed = length(motion.velocity) + length(motion.spin);
    CushionContact contact(normal, friction, cloth_friction, kNoSlip * speed);
    double impulse = integrate_until(contact, motion, approach,
                                     [&](const Motion& m) { return m.velocity.dot(normal); });
    // The work of compression is negative; restitution returns the fraction e^2 of it.
    const double final_work = (1 - restitution * restitution) * motion.work;
    impulse += integrate_until(contact, motion, approach,
                               [&](const Motion& m) { return m.work - final_work; });
    state.velocity = motion.velocity;
    // Wedged under the nose: the remaining approach velocity is removed.
    const Vec3 level(normal.x, normal.y, 0);
    if (state.velocity.dot(normal) < 0) {
        state.velocity -= level * (std::min(state.velocity.dot(level), 0.0) / level.dot(level));
    }
    state.angular_velocity = motion.spin / ball.radius;
    return {ball.mass * impulse, ball.mass * length(motion.friction)};
}

}  // namespace carom::sim
