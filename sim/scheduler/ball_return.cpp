#include "sim/scheduler/ball_return.h"

#include <algorithm>
#include <cmath>

#include "core/length.h"

namespace carom::sim {
namespace {

/// A ball that has left stops so far (m) below the floor: out of sight, and above the lower edge of
/// a table's apron.
constexpr double kBelowFloor = 0.02;

}  // namespace

BallReturn::BallReturn(const StaticEnvironment& environment, const std::vector<MovingBody>& bodies)
    : environment_(environment), bodies_(bodies), potted_(environment.table().pockets.size()) {
    double largest = 0;  // of the balls: the radius of all other bodies is 0
    for (const MovingBody& body : bodies) {
        largest = std::max(largest, body.radius);
    }
    // Without gravity straight down, nothing falls through a floor.
    if (!environment.has_ball_return || environment.downward_gravity <= 0 || largest == 0) {
        return;
    }
    for (const billiards::Pocket& pocket : environment.table().pockets) {
        capacity_.push_back(capacity(pocket.radius, pocket.drop, largest));
    }
}

/// Balls in a narrow tube lie alternately at opposite walls, `across` apart seen from above.
std::size_t BallReturn::capacity(double pocket_radius, double drop, double ball_radius) {
    const double across = std::max(2 * (pocket_radius - ball_radius), 0.0);
    const double rise = std::max(
        std::sqrt(std::max(4 * ball_radius * ball_radius - across * across, 0.0)), ball_radius);
    // The highest centre of the ball that lies on the others.
    const double highest = -0.5 * ball_radius;
    const double lowest = ball_radius - drop;
    return highest > lowest ? static_cast<std::size_t>((highest - lowest) / rise) : 0;
}

std::vector<std::uint32_t> BallReturn::balls_in(std::size_t pocket, double time) const {
    std::vector<std::uint32_t> inside;
    for (const std::uint32_t index : potted_[pocket]) {
        const MovingBody& ball = bodies_[index];
        const Vec3 centre = ball.segment.position_at(time);
        const bool is_leaving = ball.is_gone() || std::any_of(due_.begin(), due_.end(),
                                                              [index](const Leaving& leaving) {
                                                                  return leaving.ball == index;
                                                              });
        // A ball may have bounced out again; one that is just falling in is at height 0.
        constexpr double kThreshold = 1e-6;  // m
        if (!is_leaving && centre.z < kThreshold &&
            environment_.pocket_below(centre) == static_cast<int>(pocket)) {
            inside.push_back(index);
        }
    }
    return inside;
}

void BallReturn::let_go(std::uint32_t ball, std::size_t pocket) {
    const double drop = environment_.table().pockets[pocket].drop;
    due_.push_back({ball, -drop - bodies_[ball].radius - kBelowFloor});
}

void BallReturn::note_potted(std::uint32_t ball, std::size_t pocket, double time) {
    potted_[pocket].push_back(ball);
    if (capacity_.empty()) {
        return;
    }
    const std::vector<std::uint32_t> others = balls_in(pocket, time);
    for (std::size_t i = 0; i + capacity_[pocket] < others.size(); ++i) {
        let_go(others[i], pocket);
    }
}

void BallReturn::note_blocked(std::uint32_t ball, std::size_t pocket, double time) {
    if (capacity_.empty()) {
        return;
    }
    constexpr double kNear = 1e-3;  // m
    const std::vector<std::uint32_t> inside = balls_in(pocket, time);
    const MovingBody& blocked = bodies_[ball];
    const bool lies_on_one = std::any_of(inside.begin(), inside.end(), [&](std::uint32_t index) {
        const MovingBody& lower = bodies_[index];
        return length(lower.segment.position_at(time) - blocked.segment.position_at(time)) <
               lower.radius + blocked.radius + kNear;
    });
    if (lies_on_one) {
        let_go(inside.front(), pocket);
    }
}

void BallReturn::forget(std::uint32_t ball) {
    for (std::vector<std::uint32_t>& potted : potted_) {
        std::erase(potted, ball);
    }
    std::erase_if(due_, [ball](const Leaving& leaving) { return leaving.ball == ball; });
}

std::vector<BallReturn::Leaving> BallReturn::take_due() {
    std::vector<Leaving> taken;
    taken.swap(due_);
    return taken;
}

}  // namespace carom::sim
