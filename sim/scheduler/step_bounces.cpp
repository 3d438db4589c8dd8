#include "sim/scheduler/step_bounces.h"

#include "sim/scheduler/contact_numbers.h"

namespace carom::sim {

double approach_speed(const std::vector<StepBody>& bodies, const FoundContact& found) {
    const ode::StepContact& contact = found.contact;
    Vec3 relative = bodies[static_cast<std::size_t>(contact.first)].velocity_at(contact.point);
    if (found.other >= 0)
        relative -= bodies[static_cast<std::size_t>(found.other)].velocity_at(contact.point);
    return -relative.dot(contact.normal);
}

void StepBounces::resolve(std::vector<FoundContact>& contacts, double time) {
    constexpr int kMostBounces = 200;
    for (int i = 0; i < kMostBounces; ++i) {
        const FoundContact* fastest = nullptr;
        double speed = ode::kBounceSpeed;
        for (const FoundContact& found : contacts) {
            if (!bodies_[static_cast<std::size_t>(found.contact.first)].is_ball)
                continue;
            const double candidate = approach_speed(bodies_, found);
            if (candidate > speed) {
                speed = candidate;
                fastest = &found;
            }
        }
        if (fastest == nullptr)
            break;
        bounce(*fastest, time);
    }
    for (FoundContact& found : contacts) {
        if (bodies_[static_cast<std::size_t>(found.contact.first)].is_ball)
            found.contact.restitution = 0;
    }
}

void StepBounces::bounce(const FoundContact& found, double time) {
    const ode::StepContact& contact = found.contact;
    StepBody& ball = bodies_[static_cast<std::size_t>(contact.first)];
    StepBody* other = found.other >= 0 ? &bodies_[static_cast<std::size_t>(found.other)] : nullptr;
    const ode::ImpactContact impact{contact.point, contact.normal, contact.restitution,
                                    contact.friction};
    ode::ImpactResult result;
    if (other != nullptr) {
        result = balls_.solver().solve(ball.impact_body(), other->impact_body(), impact);
    } else if (is_lining(finder_.info(found.other).material, contact.normal)) {
        BallBody body{ball.mass, ball.radius, ball.state};
        const ImpulsePair pair =
            lining_impact(body, contact.normal, contact.restitution, contact.friction);
        result.first = {body.state.velocity, body.state.angular_velocity};
        result.normal_impulse = pair.normal;
        result.tangential_impulse = pair.tangential;
    } else {
        result = balls_.solver().solve_static(ball.impact_body(), impact);
    }
    take(ball, result.first, time);
    if (other != nullptr)
        take(*other, result.second, time);
    recording_.log_impact(
        time, ball.name, other != nullptr ? other->name : finder_.info(found.other).name,
        contact.point, contact.normal, {result.normal_impulse, result.tangential_impulse});
}

void StepBounces::take(StepBody& body, const ode::Velocities& velocities, double time) {
    if (!body.is_awake)
        sleep_.wake(body, time);
    const MotionState before = body.state;
    body.state.velocity = velocities.linear;
    body.state.angular_velocity = velocities.angular;
    recording_.add_break(body.track, time, before, body.state);
}

}  // namespace carom::sim
