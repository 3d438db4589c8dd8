#include "sim/scheduler/touching_balls.h"

#include <algorithm>
#include <cmath>

#include "core/length.h"
#include "sim/numeric/tolerances.h"
#include "sim/scheduler/impact_group.h"

namespace carom::sim {
namespace {

bool touch(const MotionState& a, const MotionState& b, double distance) {
    const Vec3 d = a.position - b.position;
    const double reach = distance + kFrozenGap;
    return d.dot(d) <= reach * reach &&
           std::abs((a.velocity - b.velocity).dot(unit(d))) <= kFrozenSpeed;
}

}  // namespace

TouchingBalls find_touching_balls(std::span<const MovingBody> balls, std::uint32_t struck,
                                  double time, const StaticEnvironment& environment) {
    TouchingBalls found;
    std::vector<std::uint32_t>& indices = found.indices;
    indices.push_back(struck);
    std::vector<char> is_found(balls.size(), 0);
    is_found[struck] = 1;
    for (std::size_t next = 0; next < indices.size(); ++next) {
        const MovingBody& ball = balls[indices[next]];
        const MotionState state = ball.segment.state_at(time);
        for (std::uint32_t other = 0; other < balls.size(); ++other) {
            if (is_found[other] == 0 && touch(state, balls[other].segment.state_at(time),
                                              ball.radius + balls[other].radius)) {
                is_found[other] = 1;
                indices.push_back(other);
            }
        }
    }
    std::sort(indices.begin(), indices.end());
    for (std::size_t i = 0; i < indices.size(); ++i) {
        const MovingBody& ball = balls[indices[i]];
        found.group.balls.push_back(ball.rigid_at(time));
        const RigidBody& body = found.group.balls.back();
        if (indices[i] == struck) {
            found.group.struck = i;
        }
        for (std::size_t k = 0; k < i; ++k) {
            const RigidBody& other = found.group.balls[k];
            if (touch(body.state, other.state, body.radius + other.radius)) {
                const Vec3 normal = unit(other.state.position - body.state.position);
                found.group.contacts.push_back(
                    touching_pair(environment, balls[indices[k]], ball, normal));
                found.group.contacts.back().first = k;
                found.group.contacts.back().second = i;
            }
        }
    }
    std::vector<TouchingPair>& contacts = found.group.contacts;
    std::stable_partition(contacts.begin(), contacts.end(), [&](const TouchingPair& contact) {
        return contact.first == found.group.struck || contact.second == found.group.struck;
    });
    return found;
}

}  // namespace carom::sim
