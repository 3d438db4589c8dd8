#include "sim/scheduler/step_bounces.h"

#include <algorithm>
#include <string>

#include <fmt/core.h>

#include "sim/numeric/tolerances.h"
#include "sim/scheduler/contact_table.h"

namespace carom::sim {

void StepBounces::resolve(const std::vector<BodyContact>& contacts, double time) {
    constexpr int kMaxBounces = 1000;
    forget_jams(contacts);
    const auto state_of = [this](int number) -> const MotionState& { return body(number).state; };
    for (int i = 0; i < kMaxBounces; ++i) {
        const BodyContact* fastest = nullptr;
        double speed = kBounceSpeed;
        for (const BodyContact& found : contacts) {
            const bool is_ball = body(found.contact.first).is_ball();
            if ((!is_ball && found.contact.depth < -kClosedGap) || is_jammed(found)) {
                continue;
            }
            const double candidate = approach_speed(found, state_of);
            if (candidate > speed) {
                speed = candidate;
                fastest = &found;
            }
        }
        if (fastest == nullptr) {
            break;
        }
        if (body(fastest->contact.first).is_ball()) {
            bounce_ball(*fastest, time);
        } else {
            bounce_pair(contacts, *fastest, time);
        }
        count_impact(*fastest, time);
    }
    log_impacts(time);
}

void StepBounces::forget_jams(const std::vector<BodyContact>& contacts) {
    kinematic_impact_counts_.clear();
    std::erase_if(jams_, [&](const ContactPair& jam) {
        return std::none_of(contacts.begin(), contacts.end(),
                            [&](const BodyContact& found) { return found.pair() == jam; });
    });
}

/// Repeated impacts between two free bodies die away, but a kinematic body never slows down.
void StepBounces::count_impact(const BodyContact& found, double time) {
    constexpr int kMaxImpacts = 50;
    if (!found.is_between_bodies()) {
        return;
    }
    const MovingBody& first = body(found.contact.first);
    const MovingBody& second = body(found.contact.second);
    if (!(first.is_kinematic() || second.is_kinematic()) ||
        ++kinematic_impact_counts_[found.pair()] < kMaxImpacts) {
        return;
    }
    jams_.insert(found.pair());
    const MovingBody& moved = first.is_kinematic() ? first : second;
    const MovingBody& caught = first.is_kinematic() ? second : first;
    if (!warned_pairs_.insert(found.pair()).second) {
        return;
    }
    recorder_.warn(
        {Subject::body(moved.name()), "motion",
         fmt::format("at {:.3f} s the path of '{}' leaves no room for '{}', which gets stuck: "
                     "change the path or move '{}'",
                     time, moved.name(), caught.name(), caught.name())});
}

void StepBounces::bounce_ball(const BodyContact& found, double time) {
    const ode::StepContact& contact = found.contact;
    MovingBody& ball = body(contact.first);
    MovingBody* other = found.is_between_bodies() ? &body(found.contact.second) : nullptr;
    ode::ImpactResult result;
    if (other != nullptr && other->is_kinematic()) {
        result =
            bodies_.impact_solver().solve_kinematic(ball, velocity_at(other->state, contact.point),
                                                    contact, contact.restitution, contact.friction);
    } else if (other != nullptr) {
        result = bodies_.impact_solver().solve(ball, *other, contact, contact.restitution,
                                               contact.friction);
    } else if (is_lining(finder_.info(found.partner).material, contact.normal)) {
        RigidBody body = ball;
        result.impulse = lining_impact(body, contact.normal, contact.restitution, contact.friction);
        result.first = {body.state.velocity, body.state.angular_velocity};
    } else {
        result = bodies_.impact_solver().solve_static(ball, contact, contact.restitution,
                                                      contact.friction);
    }
    set_velocities(ball, result.first, time);
    if (other != nullptr) {
        set_velocities(*other, result.second, time);
    }
    recorder_.log_impact(time, ball.name(), finder_.name_of(found.partner, bodies_.all()),
                         contact.point, contact.normal, result.impulse);
}

/// All contacts of the pair are solved together, including those with a gap below the margin, so
/// that a face lands as a face. No surface is flatter than that, and rounding would let one corner
/// hit first and turn the body.
void StepBounces::bounce_pair(const std::vector<BodyContact>& contacts, const BodyContact& fastest,
                              double time) {
    std::vector<int> moving{fastest.contact.first};
    if (fastest.is_between_bodies()) {
        moving.push_back(fastest.contact.second);
    }
    std::vector<ode::StepContact> struck;
    for (const BodyContact& found : contacts) {
        if (found.pair() == fastest.pair()) {
            struck.push_back(found.contact);
            struck.back().depth = 0;
        }
    }
    std::vector<Velocities> after;
    const ImpulsePair impulse = solve_impact(moving, struck, after);
    for (std::size_t i = 0; i < moving.size(); ++i) {
        set_velocities(body(moving[i]), after[i], time);
    }
    add_to_log(fastest, impulse);
}

/// The state of the kinematic body of a pair, if any: it does no work in its own frame.
MotionState StepBounces::kinematic_frame(const std::vector<int>& moving) {
    for (const int number : moving) {
        if (body(number).is_kinematic()) {
            return body(number).state;
        }
    }
    return {};
}

/// Restitution with friction can add energy in an eccentric impact (Kane and Levinson, Dynamics:
/// Theory and Applications, 1985, section 5.8); without restitution it never does. An impact that
/// would add energy is therefore solved without restitution.
ImpulsePair StepBounces::solve_impact(const std::vector<int>& moving,
                                      std::vector<ode::StepContact>& contacts,
                                      std::vector<Velocities>& after) {
    std::vector<MotionState> states;
    const MotionState frame = kinematic_frame(moving);
    double energy = 0;
    for (const int number : moving) {
        states.push_back(body(number).state);
        energy += body(number).kinetic_energy_in(frame);
    }
    std::vector<ImpulsePair> impulses;
    world_.solve_impact(moving, states, contacts, after, impulses);
    double left = 0;
    for (std::size_t i = 0; i < moving.size(); ++i) {
        RigidBody struck = body(moving[i]);
        struck.set(after[i]);
        left += struck.kinetic_energy_in(frame);
    }
    if (left > energy) {
        for (ode::StepContact& contact : contacts) {
            contact.restitution = 0;
        }
        world_.solve_impact(moving, states, contacts, after, impulses);
    }
    ImpulsePair sum;
    for (const ImpulsePair& impulse : impulses) {
        sum.normal += impulse.normal;
        sum.tangential += impulse.tangential;
    }
    return sum;
}

void StepBounces::add_to_log(const BodyContact& found, const ImpulsePair& impulse) {
    const auto same = std::find_if(
        impacts_.begin(), impacts_.end(),
        [&](const LoggedImpact& impact) { return impact.contact.pair() == found.pair(); });
    if (same == impacts_.end()) {
        impacts_.push_back({found, impulse});
    } else {
        same->impulse.normal += impulse.normal;
        same->impulse.tangential += impulse.tangential;
    }
}

void StepBounces::log_impacts(double time) {
    for (const LoggedImpact& impact : impacts_) {
        const ode::StepContact& contact = impact.contact.contact;
        recorder_.log_impact(time, body(contact.first).name(),
                             finder_.name_of(impact.contact.partner, bodies_.all()), contact.point,
                             contact.normal, impact.impulse);
    }
    impacts_.clear();
}

void StepBounces::set_velocities(MovingBody& body, const Velocities& velocities, double time) {
    if (body.is_kinematic()) {
        return;
    }
    const MotionState before = body.state;
    body.set(velocities);
    recorder_.add_break(body.track, time, body.with_own_axes(before),
                        body.with_own_axes(body.state));
}

}  // namespace carom::sim
