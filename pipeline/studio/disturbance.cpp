#include "pipeline/studio/disturbance.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <variant>

namespace carom::studio {

namespace {

Vec3 turned(const Vec3& v, double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {c * v.x - s * v.y, s * v.x + c * v.y, v.z};
}

const sim::Body* find_body(const sim::WorldDescription& world, const std::string& name) {
    const auto found = std::ranges::find(world.bodies, name, &sim::Body::name);
    return found == world.bodies.end() ? nullptr : &*found;
}

/// Where an object is without disturbances.
Vec3 place_of(const sim::WorldDescription& world, const sim::Timeline& timeline,
              const std::string& name, double time) {
    if (const sim::Track* track = timeline.find(name)) {
        return track->sample(time).position;
    }
    const sim::Body* body = find_body(world, name);
    return body == nullptr ? Vec3(0, 0, 0) : body->pose.position;
}

/// A strike at an object or a point becomes one in a direction, which is turned. One that a trigger
/// starts happens at other times in each run: it keeps its target.
void turn_strike(sim::Strike& strike, const sim::ForceEvent& event,
                 const sim::WorldDescription& world, const sim::Timeline& timeline, double turn) {
    if (strike.direction) {
        *strike.direction += turn;
        return;
    }
    if (event.trigger || (!strike.toward && !strike.toward_point)) {
        return;
    }
    const double time = event.time + event.after;
    const Vec3 from = place_of(world, timeline, event.object, time);
    const Vec3 to =
        strike.toward ? place_of(world, timeline, *strike.toward, time) : *strike.toward_point;
    if (std::hypot(to.x - from.x, to.y - from.y) > 0) {
        strike.direction = std::atan2(to.y - from.y, to.x - from.x) + turn;
        strike.toward.reset();
        strike.toward_point.reset();
    }
}

}  // namespace

Disturbance disturbance_of(int run, const Fan& fan) {
    const double part = (run + 0.5) / fan.runs;
    const double around = 2 * std::numbers::pi * part;
    // The angles in an order in which neighbours are not near each other: every third one.
    const int stride = fan.runs % 3 == 0 ? (fan.runs % 5 == 0 ? 7 : 5) : 3;
    const double other = ((run * stride) % fan.runs + 0.5) / fan.runs;
    return {Vec2(std::cos(around), std::sin(around)) * fan.distance, (2 * other - 1) * fan.angle};
}

sim::WorldDescription disturbed(const sim::WorldDescription& world, const sim::Timeline& timeline,
                                const Disturbance& disturbance) {
    sim::WorldDescription result = world;
    std::set<std::string> struck;
    for (sim::ForceEvent& event : result.events) {
        if (auto* strike = std::get_if<sim::Strike>(&event.action)) {
            struck.insert(event.object);
            turn_strike(*strike, event, world, timeline, disturbance.turn);
        } else if (auto* impulse = std::get_if<sim::Impulse>(&event.action)) {
            impulse->newton_seconds = turned(impulse->newton_seconds, disturbance.turn);
        } else if (auto* force = std::get_if<sim::Force>(&event.action)) {
            force->newtons = turned(force->newtons, disturbance.turn);
        } else if (auto* velocity = std::get_if<sim::SetVelocity>(&event.action)) {
            if (velocity->linear) {
                velocity->linear = turned(*velocity->linear, disturbance.turn);
            }
        }
    }
    for (sim::Body& body : result.bodies) {
        if (body.kind != sim::BodyKind::dynamic) {
            continue;
        }
        body.velocity = turned(body.velocity, disturbance.turn);
        if (struck.contains(body.name)) {
            body.pose.position.x += disturbance.displacement.x;
            body.pose.position.y += disturbance.displacement.y;
        }
    }
    return result;
}

}  // namespace carom::studio
