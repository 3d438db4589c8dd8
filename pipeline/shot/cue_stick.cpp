#include "pipeline/shot/cue_stick.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include <Imath/ImathMatrix.h>
#include <fmt/core.h>

#include "core/elementary.h"
#include "core/text.h"
#include "sim/stick/strike.h"

namespace carom::pipeline {

namespace {

using sim::Strike;

constexpr Vec3 kUp{0, 0, 1};
constexpr double kTipDepth = 0.006;   // m, of the leather
constexpr double kFerrule = 0.025;    // m
constexpr double kJointRing = 0.012;  // m
constexpr double kBumper = 0.012;     // m
constexpr double kWrapFrom = 0.28;    // of the butt, from the joint
constexpr double kWrapTo = 0.72;
constexpr double kDegree = 0.017453292519943295;
constexpr double kSteepest = 85 * kDegree;

/// Radius of the stick at `along` (m) behind the front of its tip.
double radius_at(const ShownStick& stick, double along) {
    const double joint = 0.5 * stick.length;
    const double tip = 0.5 * stick.tip_diameter;
    if (along <= joint) {
        return tip + (0.5 * kStickJoint - tip) * along / joint;
    }
    const double share = (along - joint) / (stick.length - joint);
    return 0.5 * (kStickJoint + (kStickButt - kStickJoint) * std::min(share, 1.0));
}

/// A piece of the stick between two distances behind the front of its tip.
render::ObjectDescription piece(const ShownStick& stick, const char* name, double from, double to) {
    render::ObjectDescription object;
    object.name = std::string(kStickPrefix) + name;
    object.shape = render::ConeShape{radius_at(stick, from), radius_at(stick, to), to - from};
    object.world_from_object.setTranslation(Vec3(0, 0, 0.5 * (from + to)));
    object.track = kStickTrack;
    object.material = std::string("stick_") + name;
    return object;
}

/// The sphere of the tip's front meets its edge: half as wide as a coin of 18 mm.
double dome_radius(const ShownStick& stick) {
    return std::max(0.009, 0.5 * stick.tip_diameter * 1.05);
}

Vec3 position_of(const std::string& name, double time, const sim::WorldDescription& world,
                 const sim::Timeline& timeline) {
    if (const sim::Track* track = timeline.find(name)) {
        return track->sample(time).position;
    }
    const auto body = std::ranges::find(world.bodies, name, &sim::Body::name);
    return body == world.bodies.end() ? Vec3(0, 0, 0) : body->pose.position;
}

/// The horizontal unit vector from the ball towards its aim.
Vec3 aim_of(const Strike& strike, const Vec3& from, double time, const sim::WorldDescription& world,
            const sim::Timeline& timeline) {
    if (strike.direction) {
        const SinCos direction = sin_cos(*strike.direction);
        return {direction.cos, direction.sin, 0};
    }
    const Vec3 target = strike.toward ? position_of(*strike.toward, time, world, timeline)
                                      : strike.toward_point.value_or(Vec3(0, 0, 0));
    const Vec3 level(target.x - from.x, target.y - from.y, 0);
    return level.length() > 1e-9 ? level.normalized() : Vec3(1, 0, 0);
}

/// A strike of the world, as the timeline logs it.
struct LoggedStrike {
    std::size_t event = 0;  // of the world
    double time = 0;
    Vec3 centre{0, 0, 0};  // of the ball
    Vec3 aim{1, 0, 0};
    sim::RigidBody ball;  // with its velocities before the strike
};

/// The state of a ball before an event changes it at `time`.
MotionState state_before(const std::string& name, double time, const sim::Timeline& timeline) {
    const sim::Track* track = timeline.find(name);
    if (track == nullptr) {
        return {};
    }
    MotionState state = track->sample(time);
    const auto key = std::ranges::lower_bound(track->keys(), time, {}, &sim::Key::time);
    if (key != track->keys().end() && key->time == time) {
        state.velocity = key->velocity_in;
        state.angular_velocity = key->angular_velocity_in;
    }
    return state;
}

/// The line of the stick at an elevation: where the front of the tip is, and where it points.
struct StickLine {
    Vec3 front;
    Vec3 direction;
};

StickLine line_at(const LoggedStrike& logged, const Strike& strike, double elevation,
                  const ShownStick& stick) {
    const SinCos turn = sin_cos(elevation);
    const Vec3 right(logged.aim.y, -logged.aim.x, 0);
    const Vec3 direction = logged.aim * turn.cos - kUp * turn.sin;
    const Vec3 up = right.cross(direction);
    const double depth = std::sqrt(std::max(0.0, 1 - strike.tip.dot(strike.tip)));
    const Vec3 to_contact = right * strike.tip.x + up * strike.tip.y - direction * depth;
    const double dome = dome_radius(stick);
    return {logged.centre + to_contact * (logged.ball.radius + dome) + direction * dome, direction};
}

std::vector<LoggedStrike> logged_strikes(const ShownStick& stick,
                                         const sim::WorldDescription& world,
                                         const sim::Timeline& timeline) {
    std::vector<LoggedStrike> found;
    std::set<std::size_t> used;
    for (const sim::Event& event : timeline.events) {
        if (event.kind != sim::EventKind::strike) {
            continue;
        }
        // Several strikes of one ball may wait for conditions: the right one gives this velocity.
        std::optional<LoggedStrike> best;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < world.events.size(); ++i) {
            const auto* strike = std::get_if<Strike>(&world.events[i].action);
            const auto body = std::ranges::find(world.bodies, event.a, &sim::Body::name);
            if (strike == nullptr || world.events[i].object != event.a || used.contains(i) ||
                body == world.bodies.end() || !std::holds_alternative<sim::Sphere>(body->shape)) {
                continue;
            }
            LoggedStrike logged{i, event.time, event.place, {}, {}};
            logged.ball =
                sim::RigidBody::ball(body->mass, std::get<sim::Sphere>(body->shape).radius,
                                     state_before(event.a, event.time, timeline));
            logged.aim = aim_of(*strike, event.place, event.time, world, timeline);
            const auto given = sim::strike_ball(*strike, logged.aim, logged.ball);
            if (!given) {
                continue;
            }
            const double difference = (given->velocity - event.vector).length();
            if (difference < least) {
                least = difference;
                best = logged;
            }
        }
        if (best) {
            used.insert(best->event);
            if (std::ranges::find(stick.events, best->event) != stick.events.end()) {
                found.push_back(*best);
            }
        }
    }
    return found;
}

/// The stick's speed before the contact that changes the ball's velocity by `given` (Alciatore, TP
/// B-8, solved for the stick's speed).
double stick_speed(const Strike& strike, const LoggedStrike& logged, const Vec3& given) {
    if (strike.speed) {
        return *strike.speed;
    }
    const sim::RigidBody& ball = logged.ball;
    const sim::TipContact tip = sim::tip_contact(strike, logged.aim, ball.radius);
    return tip.point_speed(ball.state.velocity, ball.state.angular_velocity) +
           given.length() * (1 + ball.mass / strike.stick_mass + 2.5 * strike.tip.dot(strike.tip)) /
               (1 + strike.tip_restitution);
}

/// How far the tip may go on: not into the cloth, and not into a ball that lies ahead.
double free_way(const StickLine& line, const LoggedStrike& logged, const ShownStick& stick,
                const sim::WorldDescription& world, const sim::Timeline& timeline) {
    const double tip = 0.5 * stick.tip_diameter;
    double way = 1;
    if (line.direction.z < -1e-6) {
        way = std::max(0.0, (line.front.z - tip) / -line.direction.z);
    }
    const std::string& struck = world.events[logged.event].object;
    for (const sim::Body& body : world.bodies) {
        const auto* sphere = std::get_if<sim::Sphere>(&body.shape);
        if (sphere == nullptr || body.name == struck) {
            continue;
        }
        const Vec3 offset = position_of(body.name, logged.time, world, timeline) - line.front;
        const double along = offset.dot(line.direction);
        const double beside = (offset - line.direction * along).length();
        const double reach = sphere->radius + tip;
        if (along > 0 && beside < reach) {
            way = std::min(way, along - std::sqrt(reach * reach - beside * beside));
        }
    }
    return std::max(0.0, way - 0.005);
}

/// Whether the stick on this line passes through the rail.
bool hits_rail(const StickLine& line, const ShownStick& stick,
               const sim::billiards::TableMeasures& table) {
    const double outside = table.cushion_width + table.rail_width;
    const double height = std::max(table.nose_height, table.rail_height);
    constexpr int kSteps = 400;
    for (int i = 0; i <= kSteps; ++i) {
        const double along = stick.length * i / kSteps;
        const Vec3 point = line.front - line.direction * along;
        const double beyond =
            std::max(std::abs(point.x) - 0.5 * table.length, std::abs(point.y) - 0.5 * table.width);
        if (beyond > 0 && beyond < outside && point.z - radius_at(stick, along) < height) {
            return true;
        }
    }
    return false;
}

/// The ball, other than the struck one, that the stick on this line passes through; empty if none.
std::string hit_ball(const StickLine& line, const LoggedStrike& logged, const ShownStick& stick,
                     const sim::WorldDescription& world, const sim::Timeline& timeline) {
    for (const sim::Body& body : world.bodies) {
        const auto* sphere = std::get_if<sim::Sphere>(&body.shape);
        if (sphere == nullptr || body.name == world.events[logged.event].object) {
            continue;
        }
        const Vec3 offset = position_of(body.name, logged.time, world, timeline) - line.front;
        const double along = std::clamp(-offset.dot(line.direction), 0.0, stick.length);
        const double distance = (offset + line.direction * along).length();
        if (distance < sphere->radius + radius_at(stick, along) - 1e-4) {
            return body.name;
        }
    }
    return {};
}

/// What the stick touches at an elevation; empty if nothing.
std::string obstacle_at(double elevation, const LoggedStrike& logged, const Strike& strike,
                        const ShownStick& stick, const sim::WorldDescription& world,
                        const sim::Timeline& timeline) {
    const StickLine line = line_at(logged, strike, elevation, stick);
    if (world.table && world.table->has_cushions && hits_rail(line, stick, *world.table)) {
        return "the rail";
    }
    const std::string ball = hit_ball(line, logged, stick, world, timeline);
    return ball.empty() ? "" : "'" + ball + "'";
}

std::string about(const LoggedStrike& logged, const sim::WorldDescription& world) {
    return "the stick that strikes '" + world.events[logged.event].object + "' at " +
           decimal_text(logged.time, 3) + " s";
}

/// The strikes that the stick reaches in time, and those that it does not.
struct Reached {
    std::vector<LoggedStrike> shown;
    std::vector<LoggedStrike> missed;
};

StickStrike to_stroke(const LoggedStrike& logged, const ShownStick& stick,
                      const sim::WorldDescription& world, const sim::Timeline& timeline) {
    const auto& strike = std::get<Strike>(world.events[logged.event].action);
    const StickLine line = line_at(logged, strike, strike.elevation, stick);
    const auto struck = sim::strike_ball(strike, logged.aim, logged.ball);
    const Vec3 given = struck ? struck->velocity : Vec3(0, 0, 0);
    const double speed = stick_speed(strike, logged, given);
    // The ball takes its momentum from the stick.
    const double after = speed - logged.ball.mass / strike.stick_mass * given.dot(line.direction);
    return {logged.time,
            line.front,
            line.direction,
            speed,
            std::max(after, 0.1 * speed),
            free_way(line, logged, stick, world, timeline)};
}

Reached reached(const ShownStick& stick, const sim::WorldDescription& world,
                const sim::Timeline& timeline) {
    constexpr double kLeastBetween = 1.2;  // s, to withdraw and to come back
    Reached result;
    for (const LoggedStrike& logged : logged_strikes(stick, world, timeline)) {
        const double least =
            kLeastBetween + shortest_stroke(to_stroke(logged, stick, world, timeline));
        const bool is_late =
            !result.shown.empty() && logged.time - result.shown.back().time < least;
        (is_late ? result.missed : result.shown).push_back(logged);
    }
    return result;
}

}  // namespace

void add_stick(render::SceneDescription& scene, const ShownStick& stick) {
    const double joint = 0.5 * stick.length;
    const double butt = joint + kJointRing;
    const double end = stick.length - kBumper;
    const double wrap_from = butt + kWrapFrom * (end - butt);
    const double wrap_to = butt + kWrapTo * (end - butt);
    // The front of the leather is a part of a sphere, drawn as rings.
    const double dome = dome_radius(stick);
    const double edge = 0.5 * stick.tip_diameter;
    const double sunk = dome - std::sqrt(dome * dome - edge * edge);
    constexpr int kRings = 4;
    for (int i = 0; i < kRings; ++i) {
        const auto radius_of = [&](int ring) { return edge * ring / kRings; };
        const auto depth_of = [&](int ring) {
            const double radius = radius_of(ring);
            return dome - std::sqrt(dome * dome - radius * radius);
        };
        render::ObjectDescription ring;
        ring.name = fmt::format("{}tip_{}", kStickPrefix, i + 1);
        ring.shape =
            render::ConeShape{radius_of(i), radius_of(i + 1), depth_of(i + 1) - depth_of(i)};
        ring.world_from_object.setTranslation(Vec3(0, 0, 0.5 * (depth_of(i) + depth_of(i + 1))));
        ring.track = kStickTrack;
        ring.material = "stick_tip";
        scene.objects.push_back(ring);
    }
    const double leather = sunk + kTipDepth;
    scene.objects.push_back(piece(stick, "tip", sunk, leather));
    scene.objects.push_back(piece(stick, "ferrule", leather, leather + kFerrule));
    scene.objects.push_back(piece(stick, "shaft", leather + kFerrule, joint));
    scene.objects.push_back(piece(stick, "joint", joint, butt));
    scene.objects.push_back(piece(stick, "butt", butt, wrap_from));
    scene.objects.push_back(piece(stick, "wrap", wrap_from, wrap_to));
    render::ObjectDescription lower = piece(stick, "butt", wrap_to, end);
    lower.name += "_end";
    scene.objects.push_back(lower);
    scene.objects.push_back(piece(stick, "bumper", end, stick.length));
}

std::vector<StickStrike> shown_strikes(const ShownStick& stick, const sim::WorldDescription& world,
                                       const sim::Timeline& timeline) {
    std::vector<StickStrike> strikes;
    for (const LoggedStrike& logged : reached(stick, world, timeline).shown) {
        strikes.push_back(to_stroke(logged, stick, world, timeline));
    }
    return strikes;
}

sim::Track stick_motion(const ShownStick& stick, const sim::WorldDescription& world,
                        const sim::Timeline& timeline) {
    const std::vector<StickStrike> strikes = shown_strikes(stick, world, timeline);
    if (strikes.empty()) {
        sim::Key far_away;
        far_away.position = {0, 0, -1e3};
        return {std::string(kStickTrack), {far_away}};
    }
    return stick_track(std::string(kStickTrack), strikes, timeline.start_time);
}

std::vector<Diagnostic> stick_problems(const ShownStick& stick, const sim::WorldDescription& world,
                                       const sim::Timeline& timeline) {
    std::vector<Diagnostic> problems;
    const Reached strikes = reached(stick, world, timeline);
    for (const LoggedStrike& logged : strikes.missed) {
        problems.push_back({Subject::event(logged.event), "stick",
                            about(logged, world) +
                                " is not shown: it cannot be back in time from the strike before",
                            Severity::warning});
    }
    for (const LoggedStrike& logged : strikes.shown) {
        const auto& strike = std::get<Strike>(world.events[logged.event].action);
        const std::string obstacle =
            obstacle_at(strike.elevation, logged, strike, stick, world, timeline);
        if (obstacle.empty()) {
            continue;
        }
        constexpr double kStep = 0.1 * kDegree;
        double elevation = strike.elevation;
        while (elevation < kSteepest &&
               !obstacle_at(elevation, logged, strike, stick, world, timeline).empty()) {
            elevation += kStep;
        }
        const std::string cure =
            elevation < kSteepest
                ? fmt::format("an elevation of at least {} deg clears it",
                              decimal_text(std::ceil(elevation / kStep - 1e-6) * 0.1, 1))
                : std::string("no elevation clears it");
        problems.push_back(
            {Subject::event(logged.event), "elevation",
             fmt::format("{} passes through {}; {}", about(logged, world), obstacle, cure),
             Severity::warning});
    }
    return problems;
}

}  // namespace carom::pipeline
