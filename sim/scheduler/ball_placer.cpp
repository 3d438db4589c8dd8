#include "sim/scheduler/ball_placer.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "core/length.h"

namespace carom::sim {
namespace {

/// A ball that was taken off lies so far (m) below the slate, where the table hides it.
constexpr double kBelowSlate = 0.03;
/// Distance of balls that were taken off, in diameters.
constexpr double kSpacing = 1.1;

std::string quoted(const std::string& name) {
    return "'" + name + "'";
}

}  // namespace

const PlaceBall& BallPlacer::action_of(std::size_t event) const {
    return std::get<PlaceBall>(world_.events[event].action);
}

void BallPlacer::place(std::size_t event, std::uint32_t ball, double time) {
    end_wait(ball, event);
    const Waiting wanted{event, ball};
    if (!try_place(wanted, time)) {
        waiting_.push_back(wanted);
    }
}

void BallPlacer::remove(std::size_t event, std::uint32_t ball, double time) {
    end_wait(ball, event);
    const MovingBody& taken = bodies_.balls()[ball];
    recorder_.log(EventKind::removed, time, taken.name(), taken.segment.position_at(time));
    bodies_.wake_around(ball, time);
    bodies_.take_off(ball, time, hidden_place(ball));
    done_.push_back(event);
}

/// A place of its own for each ball, in a row below the slate.
Vec3 BallPlacer::hidden_place(std::uint32_t ball) const {
    double largest = 0;
    for (const MovingBody& other : bodies_.balls()) {
        largest = std::max(largest, other.radius);
    }
    const double middle = 0.5 * (static_cast<double>(bodies_.balls().size()) - 1);
    return {(ball - middle) * kSpacing * 2 * largest, 0,
            kSlateUnderside - kBelowSlate - bodies_.balls()[ball].radius};
}

bool BallPlacer::can_place_waiting(double time) const {
    return std::any_of(waiting_.begin(), waiting_.end(), [&](const Waiting& waiting) {
        return find_place(waiting, time).has_value();
    });
}

void BallPlacer::place_waiting(double time) {
    std::erase_if(waiting_, [&](const Waiting& waiting) { return try_place(waiting, time); });
}

bool BallPlacer::try_place(const Waiting& waiting, double time) {
    const auto found = find_place(waiting, time);
    if (found) {
        put_down(waiting.ball, found->place, found->spot, time);
        done_.push_back(waiting.event);
    }
    return found.has_value();
}

std::optional<billiards::FreePlace> BallPlacer::find_place(const Waiting& waiting,
                                                           double time) const {
    const PlaceBall& action = action_of(waiting.event);
    if (obstacle(waiting.ball, action.at, time).empty()) {
        return billiards::FreePlace{action.at, action.spot};
    }
    if (action.if_occupied == PlaceBall::IfOccupied::wait) {
        return std::nullopt;
    }
    const auto next =
        billiards::next_place(lying_balls(waiting.ball, time), *world_.table, action.at,
                              action.spot, bodies_.balls()[waiting.ball].radius);
    return next && obstacle(waiting.ball, next->place, time).empty() ? next : std::nullopt;
}

billiards::FreePlaces BallPlacer::lying_balls(std::uint32_t except, double time) const {
    std::vector<billiards::LyingBall> lying;
    for (std::uint32_t i = 0; i < bodies_.balls().size(); ++i) {
        const MovingBody& ball = bodies_.balls()[i];
        const Vec3 centre = ball.segment.position_at(time);
        if (i != except && !ball.is_gone() && centre.z > 0) {
            lying.push_back({ball.name(), {centre.x, centre.y}, ball.radius});
        }
    }
    return {*world_.table, std::move(lying)};
}

std::string BallPlacer::obstacle(std::uint32_t ball, const Vec2& place, double time) const {
    const double radius = bodies_.balls()[ball].radius;
    const Vec3 centre(place.x, place.y, radius);
    for (std::uint32_t i = 0; i < bodies_.balls().size(); ++i) {
        const MovingBody& other = bodies_.balls()[i];
        const double reach = other.radius + radius + billiards::FreePlaces::kApart;
        if (i != ball && !other.is_gone() &&
            length(other.segment.position_at(time) - centre) < reach) {
            return other.name();
        }
    }
    for (const MovingBody& solid : bodies_.solids()) {
        const Pose pose{solid.state.position, solid.state.orientation};
        if (convex_contact(*solid.shape, pose, centre, radius).depth >
            -billiards::FreePlaces::kApart) {
            return solid.name();
        }
    }
    return {};
}

void BallPlacer::put_down(std::uint32_t ball, const Vec2& place, const std::string& spot,
                          double time) {
    const MovingBody& put = bodies_.balls()[ball];
    bodies_.wake_around(ball, time);
    bodies_.put_down(ball, time, place);
    recorder_.log(EventKind::placed, time, put.name(), put.segment.state.position, spot);
}

void BallPlacer::end_wait(std::uint32_t ball, std::size_t by_event) {
    std::erase_if(waiting_, [&](const Waiting& waiting) {
        if (waiting.ball != ball) {
            return false;
        }
        given_up_.push_back(
            {Subject::event(waiting.event), "",
             never_happened(waiting.event,
                            fmt::format("event {} came before its place was free", by_event + 1))});
        return true;
    });
}

std::string BallPlacer::never_happened(std::size_t event, const std::string& why) const {
    return fmt::format("event {} on '{}' never happened: {}", event + 1,
                       world_.events[event].object, why);
}

std::vector<Diagnostic> BallPlacer::never_placed(double time) const {
    std::vector<Diagnostic> warnings = given_up_;
    for (const Waiting& waiting : waiting_) {
        const PlaceBall& action = action_of(waiting.event);
        const std::string place =
            action.spot.empty() ? "its place" : "the spot " + quoted(action.spot);
        const std::string who = quoted(obstacle(waiting.ball, action.at, time));
        const bool is_next = action.if_occupied == PlaceBall::IfOccupied::next;
        warnings.push_back(
            {Subject::event(waiting.event), "spot",
             never_happened(waiting.event,
                            fmt::format("{} {}, at the end by {}", place,
                                        is_next ? "and all others that the rule gives were occupied"
                                                : "was never free",
                                        who))});
    }
    return warnings;
}

}  // namespace carom::sim
