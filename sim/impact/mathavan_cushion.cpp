#include "sim/impact/mathavan_cushion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/length.h"
#include "sim/numeric/false_position.h"

namespace carom::sim {
namespace {

/// Largest steps as a fraction of the approach speed.
constexpr double kMaxStep = 0.5;
constexpr double kFirstStep = 0.3;
constexpr double kMaxStiffStep = 1.0 / 1024;
/// Of velocities in a step, as a fraction of the approach speed.
constexpr double kTolerance = 1e-7;
/// Slip below this fraction of the ball's speed counts as none.
constexpr double kNoSlip = 1e-10;
/// Limit for a ball wedged under the nose by friction, which would be pressed there forever.
constexpr double kMaxImpulseRatio = 20;  // times the approach; a free ball takes 2 to 4

constexpr int kMaxSteps = 20000;  // some dozens are usual

/// In the frame of the contact: x along the cushion, y level and away from it, z up; t is up in the
/// plane in which the ball touches the nose, whose normal n is (0, cosine, sine). All quantities
/// are divided by the ball's mass; spin is R w. So impulses and spin are velocities, and an impulse
/// j at the unit direction d from the centre changes the spin by 5/2 d x j.
enum Part : std::uint8_t {
    kVx,
    kVy,
    kVz,
    kWx,
    kWy,
    kWz,
    kWork,  // of the normal impulse at the nose
    kFx,    // friction's impulse at the nose, along x and t
    kFt,
    kParts
};
using Motion = std::array<double, kParts>;

/// Forces per unit of normal force at the nose.
struct Forces {
    Vec2 nose{0, 0};     // friction, along x and t
    Vec2 cloth{0, 0};    // friction, along x and y
    double support = 0;  // normal force of the cloth
};

/// Change of the slip at a contact of a solid sphere per unit of impulse there.
constexpr double kResponse = 3.5;

Vec2 limited(const Vec2& v, double limit) {
    const double squared = v.dot(v);
    return squared > limit * limit ? v * (limit / std::sqrt(squared)) : v;
}

class CushionContact {
  public:
    /// `sine`: of the angle by which the normal rises from the level.
    CushionContact(double sine, double friction, double cloth_friction, double approach,
                   double no_slip)
        : sine_(sine),
          cosine_(std::sqrt(1 - sine * sine)),
          friction_(friction),
          cloth_friction_(cloth_friction),
          approach_(approach),
          no_slip_(no_slip),
          next_step_(kFirstStep * approach) {}

    /// The velocity away from the nose.
    [[nodiscard]] double parting(const Motion& m) const {
        return cosine_ * m[kVy] + sine_ * m[kVz];
    }

    /// The motion after the next step.
    [[nodiscard]] Motion advance(const Motion& motion, double& step) {
        const Slips slips = slips_of(motion);
        const Forces now = forces(motion, slips);
        if (is_stiff(slips, now)) {
            step = longest_step(motion, slips, rate(motion, now), kMaxStiffStep * approach_);
            return after_stiff(motion, slips, step);
        }
        const Motion first = rate(motion, now);
        step = longest_step(motion, slips, first, std::min(next_step_, kMaxStep * approach_));
        for (int i = 0; i < 60; ++i) {
            double error = 0;
            Motion next = after(motion, first, step, &error);
            const double ratio = error / (kTolerance * approach_);
            const double factor = step_factor(ratio);
            if (ratio <= 1) {
                const Slips later = slips_of(next);
                next_step_ = factor * step *
                             std::min({1.0, shrinking(slips.nose_speed, later.nose_speed),
                                       shrinking(slips.cloth_speed, later.cloth_speed)});
                return next;
            }
            step *= factor;
        }
        return after(motion, first, step);
    }

    /// The motion after `step`.
    [[nodiscard]] Motion after(const Motion& motion, double step) {
        const Slips slips = slips_of(motion);
        const Forces now = forces(motion, slips);
        return is_stiff(slips, now) ? after_stiff(motion, slips, step)
                                    : after(motion, rate(motion, now), step);
    }

    /// Change of parting() per unit of normal impulse.
    [[nodiscard]] double parting_rate(const Motion& motion) { return parting(rate(motion)); }

  private:
    /// Tangential velocities of the ball's surface at both contacts.
    struct Slips {
        Vec2 nose, cloth;
        double nose_speed, cloth_speed;
    };
    [[nodiscard]] Vec2 nose_slip(const Motion& m) const {
        return {m[kVx] - sine_ * m[kWy] + cosine_ * m[kWz],
                cosine_ * m[kVz] - sine_ * m[kVy] - m[kWx]};
    }
    [[nodiscard]] static Vec2 cloth_slip(const Motion& m) {
        return {m[kVx] - m[kWy], m[kVy] + m[kWx]};
    }
    [[nodiscard]] Slips slips_of(const Motion& motion) const {
        const Vec2 nose = nose_slip(motion);
        const Vec2 cloth = cloth_slip(motion);
        return {nose, cloth, std::sqrt(nose.dot(nose)), std::sqrt(cloth.dot(cloth))};
    }

    /// By which a step changes whose error is `ratio` times the tolerance: its fifth root, nearly
    /// (Hairer, Norsett and Wanner, Solving ordinary differential equations I, 1993, section II.4).
    [[nodiscard]] static double step_factor(double ratio) {
        const double eighth = std::sqrt(std::sqrt(std::sqrt(std::max(ratio, 1e-8))));
        return std::clamp(0.85 / (eighth * std::sqrt(eighth)), 0.2, 5.0);
    }

    /// Slip turns faster the smaller it is.
    [[nodiscard]] double shrinking(double before, double after) const {
        return before > no_slip_ && after > no_slip_ ? after / before : 1;
    }

    /// The motion after `step` with the rate `k1` at its beginning, and an estimate of its error
    /// (Dormand and Prince, A family of embedded Runge-Kutta formulae, 1980).
    [[nodiscard]] Motion after(const Motion& motion, const Motion& k1, double step,
                               double* error = nullptr) {
        Motion at;
        const auto stage = [&](auto combination) {
            for (std::size_t i = 0; i < kWork; ++i) {
                at[i] = motion[i] + step * combination(i);
            }
            return rate(at);
        };
        const Motion k2 = stage([&](std::size_t i) { return k1[i] / 5; });
        const Motion k3 = stage([&](std::size_t i) { return 3.0 / 40 * k1[i] + 9.0 / 40 * k2[i]; });
        const Motion k4 = stage([&](std::size_t i) {
            return 44.0 / 45 * k1[i] - 56.0 / 15 * k2[i] + 32.0 / 9 * k3[i];
        });
        const Motion k5 = stage([&](std::size_t i) {
            return 19372.0 / 6561 * k1[i] - 25360.0 / 2187 * k2[i] + 64448.0 / 6561 * k3[i] -
                   212.0 / 729 * k4[i];
        });
        const Motion k6 = stage([&](std::size_t i) {
            return 9017.0 / 3168 * k1[i] - 355.0 / 33 * k2[i] + 46732.0 / 5247 * k3[i] +
                   49.0 / 176 * k4[i] - 5103.0 / 18656 * k5[i];
        });
        Motion next;
        for (std::size_t i = 0; i < kParts; ++i) {
            next[i] = motion[i] +
                      step * (35.0 / 384 * k1[i] + 500.0 / 1113 * k3[i] + 125.0 / 192 * k4[i] -
                              2187.0 / 6784 * k5[i] + 11.0 / 84 * k6[i]);
        }
        if (error != nullptr) {
            const Motion k7 = rate(next);
            for (std::size_t i = 0; i < kWork; ++i) {
                *error = std::max(*error,
                                  std::abs(step * (71.0 / 57600 * k1[i] - 71.0 / 16695 * k3[i] +
                                                   71.0 / 1920 * k4[i] - 17253.0 / 339200 * k5[i] +
                                                   22.0 / 525 * k6[i] - 1.0 / 40 * k7[i])));
            }
        }
        return next;
    }

    /// Likewise by the implicit midpoint rule, where a slip turns faster than it grows, as after
    /// sticking.
    [[nodiscard]] Motion after_stiff(const Motion& motion, const Slips& slips, double step) {
        const Forces middle = find_forces(motion, slips, 0.5 * step, false, false);
        Motion half = rate(motion, middle);
        for (std::size_t i = 0; i < kParts; ++i) {
            half[i] = motion[i] + 0.5 * step * half[i];
        }
        Motion next = rate(half, middle);
        for (std::size_t i = 0; i < kParts; ++i) {
            next[i] = motion[i] + step * next[i];
        }
        return next;
    }

    /// `longest`, or until a slip ends if its direction stays, or where a lifted ball lands on the
    /// cloth again.
    [[nodiscard]] double longest_step(const Motion& motion, const Slips& slips,
                                      const Motion& change, double longest) const {
        constexpr double kNearlyAll = 1 - 1e-9;
        const auto end_at = [&](const Vec2& slip, double speed, const Vec2& slip_rate) {
            const double closing = -slip.dot(slip_rate);
            if (speed > no_slip_ && closing > 0) {
                longest = std::min(longest, kNearlyAll * speed * speed / closing);
            }
        };
        end_at(slips.nose, slips.nose_speed, nose_slip(change));
        end_at(slips.cloth, slips.cloth_speed, cloth_slip(change));
        if (motion[kVz] > no_slip_ && change[kVz] < 0) {
            longest = std::min(longest, -motion[kVz] / change[kVz]);
        }
        return longest;
    }

    [[nodiscard]] bool is_stiff(const Slips& slips, const Forces& f) const {
        const double size = kResponse * kMaxStiffStep * approach_;
        return (slips.nose_speed > no_slip_ && size * friction_ > slips.nose_speed) ||
               (slips.cloth_speed > no_slip_ &&
                size * cloth_friction_ * f.support > slips.cloth_speed);
    }

    /// Change of the motion per unit of normal impulse.
    [[nodiscard]] Motion rate(const Motion& motion) {
        return rate(motion, forces(motion, slips_of(motion)));
    }

    [[nodiscard]] Motion rate(const Motion& motion, const Forces& f) const {
        return {f.nose.x + f.cloth.x,
                cosine_ - sine_ * f.nose.y + f.cloth.y,
                sine_ + cosine_ * f.nose.y + f.support,
                2.5 * (f.cloth.y - f.nose.y),
                -2.5 * (sine_ * f.nose.x + f.cloth.x),
                2.5 * cosine_ * f.nose.x,
                parting(motion),
                f.nose.x,
                f.nose.y};
    }

    /// The normal force of the cloth balances the downward force at the nose.
    [[nodiscard]] double support(const Motion& motion, const Vec2& nose_friction) const {
        const double down = -(sine_ + cosine_ * nose_friction.y);
        return motion[kVz] <= no_slip_ ? std::max(down, 0.0) : 0.0;
    }

    /// Where a contact slips, its friction is against the slip; otherwise it prevents slip.
    [[nodiscard]] Forces forces(const Motion& motion, const Slips& slips) {
        const bool is_nose_known = slips.nose_speed > no_slip_;
        const bool is_cloth_known = slips.cloth_speed > no_slip_;
        if (!is_nose_known || !is_cloth_known) {
            return find_forces(motion, slips, 0, is_nose_known, is_cloth_known);
        }
        Forces f;
        f.nose = slips.nose * (-friction_ / slips.nose_speed);
        f.support = support(motion, f.nose);
        f.cloth = slips.cloth * (-cloth_friction_ * f.support / slips.cloth_speed);
        return f;
    }

    /// The friction that stops what slip there is after an impulse of `ahead` (0: keeps it from
    /// growing), or the largest possible one, by alternating iteration between the two contacts.
    [[nodiscard]] const Forces& find_forces(const Motion& motion, const Slips& slips, double ahead,
                                            bool is_nose_known, bool is_cloth_known) {
        const double fraction = ahead > 0 ? 1 / ahead : 0;
        Forces& f = forces_;  // the last solution is a good start
        if (is_nose_known) {
            f.nose = slips.nose * (-friction_ / slips.nose_speed);
        }
        for (int i = 0; i < 100; ++i) {
            const Forces last = f;
            if (!is_nose_known) {
                const Vec2 slip_rate = slips.nose * fraction + nose_slip(rate(motion, f));
                f.nose = limited(f.nose - slip_rate / kResponse, friction_);
            }
            f.support = support(motion, f.nose);
            const double limit = cloth_friction_ * f.support;
            if (is_cloth_known) {
                f.cloth = slips.cloth * (-limit / slips.cloth_speed);
            } else {
                const Vec2 slip_rate = slips.cloth * fraction + cloth_slip(rate(motion, f));
                f.cloth = limited(f.cloth - slip_rate / kResponse, limit);
            }
            const Vec2 nose = f.nose - last.nose;
            const Vec2 cloth = f.cloth - last.cloth;
            if (nose.dot(nose) + cloth.dot(cloth) < 1e-28) {
                break;
            }
        }
        return f;
    }

    double sine_, cosine_;
    double friction_;
    double cloth_friction_;
    double approach_;
    double no_slip_;
    double next_step_;
    Forces forces_;
};

/// The work within a step: the polynomial of fifth degree with its values, slopes (the parting
/// velocity) and second derivatives at both ends.
class WorkInStep {
  public:
    WorkInStep(CushionContact& contact, const Motion& from, const Motion& to, double step)
        : step_(step) {
        const double u0 = step * contact.parting(from);
        const double u1 = step * contact.parting(to);
        const double a0 = 0.5 * step * step * contact.parting_rate(from);
        const double a1 = 0.5 * step * step * contact.parting_rate(to);
        const double rise = to[kWork] - from[kWork] - u0 - a0;
        const double slope = u1 - u0 - 2 * a0;
        const double bend = a1 - a0;
        terms_ = {from[kWork],
                  u0,
                  a0,
                  10 * rise - 4 * slope + bend,
                  -15 * rise + 7 * slope - 2 * bend,
                  6 * rise - 3 * slope + bend};
    }

    [[nodiscard]] double at(double part) const {
        const double x = part / step_;
        double value = 0;
        for (std::size_t i = 6; i-- > 0;) {
            value = value * x + terms_[i];
        }
        return value;
    }
    /// The parting velocity, up to a constant factor.
    [[nodiscard]] double slope_at(double part) const {
        const double x = part / step_;
        double value = 0;
        for (std::size_t i = 6; i-- > 1;) {
            value = value * x + static_cast<double>(i) * terms_[i];
        }
        return value;
    }

  private:
    double step_;
    std::array<double, 6> terms_;
};

/// Where in a step the work reaches `final_work`, which it passes between the parts `low` and
/// `step`, and the motion there.
Motion end_in_step(CushionContact& contact, const Motion& motion, const WorkInStep& work,
                   double low, double& step, double final_work) {
    const double high_value = work.at(step) - final_work;
    const double low_value = work.at(low) - final_work;
    double part = low;
    if (low_value < 0) {
        part =
            false_position({low, low_value}, {step, high_value}, 1e-15 * (high_value - low_value),
                           [&](double at) { return work.at(at) - final_work; });
    }
    Motion end = contact.after(motion, part);
    for (int i = 0; i < 3; ++i) {
        const double speed = contact.parting(end);
        const double missing = final_work - end[kWork];
        if (!(speed > 0) || std::abs(missing) <= 1e-15 * std::abs(high_value - low_value)) {
            break;
        }
        part = std::clamp(part + missing / speed, low, step);
        end = contact.after(motion, part);
    }
    step = part;
    return end;
}

/// Integrates the motion until restitution has returned its part of the work of compression;
/// returns the normal impulse up to then.
double integrate(CushionContact& contact, Motion& motion, double approach, double restitution) {
    double impulse = 0;
    bool is_compressing = true;
    double final_work = 0;
    for (int i = 0; i < kMaxSteps && impulse < kMaxImpulseRatio * approach; ++i) {
        double step = 0;
        const Motion next = contact.advance(motion, step);
        double low = 0;
        const bool ends_compression = is_compressing && contact.parting(next) >= 0;
        if (ends_compression || (!is_compressing && next[kWork] >= final_work)) {
            const WorkInStep work(contact, motion, next, step);
            if (ends_compression) {
                is_compressing = false;
                low = false_position({0, work.slope_at(0)}, {step, work.slope_at(step)},
                                     1e-15 * std::abs(work.slope_at(0)),
                                     [&](double at) { return work.slope_at(at); });
                // The work of compression is negative; the fraction e^2 of it is returned.
                final_work = (1 - restitution * restitution) * work.at(low);
            }
            if (next[kWork] >= final_work) {
                motion = end_in_step(contact, motion, work, low, step, final_work);
                return impulse + step;
            }
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
    const Vec3 y = unit(Vec3(normal.x, normal.y, 0));
    const Vec3 x = y.cross(kUp);
    const Vec3& v = state.velocity;
    const Vec3 w = state.angular_velocity * ball.radius;
    Motion motion{v.dot(x), v.dot(y), v.z, w.dot(x), w.dot(y), w.z, 0, 0, 0};
    CushionContact contact(normal.z, friction, cloth_friction, approach,
                           kNoSlip * (length(v) + length(w)));
    const double impulse = integrate(contact, motion, approach, restitution);
    if (contact.parting(motion) < 0) {
        motion[kVy] = std::max(motion[kVy], 0.0);  // wedged under the nose
    }
    state.velocity = x * motion[kVx] + y * motion[kVy] + kUp * motion[kVz];
    state.angular_velocity = (x * motion[kWx] + y * motion[kWy] + kUp * motion[kWz]) / ball.radius;
    const Vec2 nose_friction(motion[kFx], motion[kFt]);
    return {ball.mass * impulse, ball.mass * std::sqrt(nose_friction.dot(nose_friction))};
}

}  // namespace carom::sim
