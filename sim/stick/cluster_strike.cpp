#include "sim/stick/cluster_strike.h"

#include <algorithm>
#include <cmath>

#include "core/assert.h"
#include "core/length.h"
#include "sim/numeric/false_position.h"
#include "sim/stick/contact_impulses.h"

namespace carom::sim {
namespace {

/// Increments of the impulse that the free ball would take, and their growth: a ball in a group
/// takes more. Where the impulses are proportional to that of the tip, one increment is exact.
constexpr double kIncrements = 48;
constexpr double kGrowth = 1.02;
constexpr int kMaxIncrements = 2000;  // for groups much heavier than the stick

struct PushState {
    std::vector<Velocities> velocities;
    std::vector<ContactImpulse> contacts;  // since the start
    double impulse = 0;                    // of the tip, N s
    double work = 0;                       // of the tip's compression, J
};

std::vector<Velocities> velocities_of(const FrozenCluster& group) {
    std::vector<Velocities> velocities;
    for (const RigidBody& ball : group.balls) {
        velocities.push_back({ball.state.velocity, ball.state.angular_velocity});
    }
    return velocities;
}

void set_velocities(FrozenCluster& group, const std::vector<Velocities>& velocities) {
    for (std::size_t i = 0; i < group.balls.size(); ++i) {
        group.balls[i].set(velocities[i]);
    }
}

class Push {
  public:
    Push(const FrozenCluster& group, const TipContact& tip, const Strike& strike,
         const BallBall& law)
        : group_(group), tip_(tip), strike_(strike), law_(law), solver_(group) {
        state_.velocities = velocities_of(group);
        state_.contacts.resize(group.contacts.size());
        start_ = state_.velocities[group.struck];
    }

    /// Follows the push with increments of `increment` until `value`, which is continuous and
    /// positive at first, reaches 0.
    template <typename Value>
    void run_until(Value value, double increment) {
        double before = value(state_);
        const double least = 1e-15 * before;
        last_.assign(group_.contacts.size(), {});
        for (int i = 0; i < kMaxIncrements && before > least; ++i) {
            PushState next = after(increment, last_, 1);
            const double now = value(next);
            if (now <= 0) {
                state_ = end_within(value, increment, before, now, std::move(next));
                return;
            }
            keep_as_guess(next, kGrowth);
            state_ = std::move(next);
            before = now;
            increment *= kGrowth;
        }
    }

    [[nodiscard]] const PushState& state() const { return state_; }

    /// The speed of the tip relative to the struck point.
    [[nodiscard]] double closing_speed(const PushState& state) const {
        const Velocities& struck = state.velocities[group_.struck];
        const double point = tip_.direction.dot(struck.linear - start_.linear) +
                             tip_.lever.dot(struck.angular - start_.angular);
        return strike_.speed.value_or(0) - tip_.point_speed(start_.linear, start_.angular) -
               state.impulse / strike_.stick_mass - point;
    }

    /// What the struck ball's speed along the impulse lacks to that of the ball being `speed`.
    [[nodiscard]] double lacking(double speed, const PushState& state) const {
        const Vec3& velocity = state.velocities[group_.struck].linear;
        const double along = tip_.direction.dot(velocity);
        const double across2 = velocity.dot(velocity) - along * along;
        return std::sqrt(std::max(speed * speed - across2, 0.0)) - along;
    }

    /// The change of the struck ball's velocity.
    [[nodiscard]] Vec3 gained(const PushState& state) const {
        return state.velocities[group_.struck].linear - start_.linear;
    }

    [[nodiscard]] bool is_proportional() const {
        const bool rests =
            std::all_of(group_.balls.begin(), group_.balls.end(), [](const RigidBody& ball) {
                return ball.state.velocity == Vec3(0, 0, 0) &&
                       ball.state.angular_velocity == Vec3(0, 0, 0);
            });
        return rests && !varies_;
    }

  private:
    /// The state after the part of `increment` at whose end `value` is 0; after all of it there is
    /// `state`.
    template <typename Value>
    [[nodiscard]] PushState end_within(Value value, double increment, double at_low, double at_high,
                                       PushState state) const {
        false_position({0, at_low}, {increment, at_high}, 1e-15 * at_low, [&](double part) {
            state = after(part, last_, part / increment);
            return value(state);
        });
        return state;
    }

    void keep_as_guess(const PushState& next, double growth) {
        for (std::size_t i = 0; i < last_.size(); ++i) {
            last_[i] = {(next.contacts[i].normal - state_.contacts[i].normal) * growth,
                        (next.contacts[i].friction - state_.contacts[i].friction) * growth};
        }
    }

    /// The state after one more `increment`. Friction acts with the mean of the coefficients before
    /// and after it.
    [[nodiscard]] PushState after(double increment, const std::vector<ContactImpulse>& guess,
                                  double guess_part) const {
        const RigidBody& struck = group_.balls[group_.struck];
        std::vector<Velocities> free = state_.velocities;
        free[group_.struck].linear += tip_.direction * (increment / struck.mass);
        free[group_.struck].angular +=
            tip_.lever * (2.5 * increment / (struck.mass * struck.radius * struck.radius));
        std::vector<ContactImpulse> impulses = guess;
        for (ContactImpulse& impulse : impulses) {
            impulse.normal *= guess_part;
            impulse.friction *= guess_part;
        }
        const std::vector<double> before = coefficients(state_.velocities);
        PushState next;
        next.velocities = free;
        solver_.solve(next.velocities, before, impulses);
        if (varies_) {
            std::vector<double> mean = coefficients(next.velocities);
            for (std::size_t i = 0; i < mean.size(); ++i) {
                mean[i] = 0.5 * (before[i] + mean[i]);
            }
            next.velocities = free;
            solver_.solve(next.velocities, mean, impulses);
        }
        next.impulse = state_.impulse + increment;
        next.work = state_.work + 0.5 * increment * (closing_speed(state_) + closing_speed(next));
        for (std::size_t i = 0; i < impulses.size(); ++i) {
            next.contacts.push_back({state_.contacts[i].normal + impulses[i].normal,
                                     state_.contacts[i].friction + impulses[i].friction});
        }
        return next;
    }

    [[nodiscard]] std::vector<double> coefficients(
        const std::vector<Velocities>& velocities) const {
        std::vector<double> result;
        for (const TouchingPair& contact : group_.contacts) {
            result.push_back(
                contact.friction
                    ? *contact.friction
                    : ball_friction(law_,
                                    length(solver_.relative_velocity(contact, velocities).slip)));
        }
        return result;
    }

    const FrozenCluster& group_;
    const TipContact& tip_;
    const Strike& strike_;
    const BallBall& law_;
    ContactImpulses solver_;
    bool varies_ = law_.friction_model != BallFriction::constant &&
                   std::any_of(group_.contacts.begin(), group_.contacts.end(),
                               [](const TouchingPair& contact) { return !contact.friction; });
    PushState state_;
    Velocities start_;                  // of the struck ball
    std::vector<ContactImpulse> last_;  // those of the last increment, as guesses
};

}  // namespace

ClusterStrikeResult strike_cluster(FrozenCluster& group, const Strike& strike, const Vec3& aim,
                                   const BallBall& law) {
    const RigidBody& struck = group.balls[group.struck];
    const TipContact tip = tip_contact(strike, aim, struck.radius);
    const std::optional<StrikeResult> free = strike_ball(strike, aim, struck);
    CAROM_ASSERT(free.has_value());
    Push push(group, tip, strike, law);
    const double increment =
        struck.mass * length(free->velocity) / (push.is_proportional() ? 1 : kIncrements);
    if (strike.ball_speed) {
        push.run_until(
            [&](const PushState& state) { return push.lacking(*strike.ball_speed, state); },
            increment);
    } else {
        push.run_until([&](const PushState& state) { return push.closing_speed(state); },
                       increment);
        const double e = strike.tip_restitution;
        const double kept = (1 - e * e) * push.state().work;
        push.run_until([&](const PushState& state) { return state.work - kept; }, increment);
    }
    ClusterStrikeResult result{push.state().impulse, push.gained(push.state()), {}};
    for (const ContactImpulse& impulse : push.state().contacts) {
        result.contacts.push_back({impulse.normal, length(impulse.friction)});
    }
    set_velocities(group, push.state().velocities);
    return result;
}

void separate_balls(FrozenCluster& group, const ClusterStrikeResult& push) {
    std::vector<double> least;
    for (std::size_t i = 0; i < group.contacts.size(); ++i) {
        const TouchingPair& contact = group.contacts[i];
        const double change = push.contacts[i].normal * (1 / group.balls[contact.first].mass +
                                                         1 / group.balls[contact.second].mass);
        least.push_back(change > kMinSeparation ? kMinSeparation : 0);
    }
    ContactImpulses contacts(group);
    contacts.set_least_separations(std::move(least));
    std::vector<Velocities> velocities = velocities_of(group);
    std::vector<ContactImpulse> impulses(group.contacts.size());
    contacts.solve(velocities, std::vector<double>(group.contacts.size(), 0), impulses);
    set_velocities(group, velocities);
}

}  // namespace carom::sim
