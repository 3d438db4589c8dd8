// Aim lines, ghost balls and tangent lines.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/elementary.h"
#include "pipeline/picture/build_shapes.h"
#include "pipeline/picture/colours.h"
#include "pipeline/picture/contact.h"

namespace carom::pipeline {
namespace {

constexpr double kWidth = 0.006;        // picture heights
constexpr double kWithoutTable = 1;     // length of an aim line, m
constexpr double kGhostWidth = 0.0045;  // picture heights
constexpr double kGhostOpacity = 0.22;
constexpr double kGhostDashes = 0.25;  // of the usual size
constexpr double kBehind = 2;          // of a tangent behind the ghost ball, ball radii

/// Where a ball is and where it is aimed.
struct Aim {
    Vec3 from;
    Vec3 direction;  // unit, level
    double time = 0;
};

std::optional<Vec3> level(const Vec3& vector) {
    const double length = std::sqrt(vector.x * vector.x + vector.y * vector.y);
    if (length < 1e-9) {
        return std::nullopt;
    }
    return Vec3(vector.x / length, vector.y / length, 0);
}

Vec3 towards_angle(double angle) {
    const SinCos at = sin_cos(angle);
    return {at.cos, at.sin, 0};
}

/// The aim of the first strike on the ball.
std::optional<Aim> aim_of_strike(const std::string& ball, const SceneMoment& moment) {
    const auto event = std::ranges::find_if(moment.timeline.events, [&](const sim::Event& e) {
        return e.kind == sim::EventKind::strike && e.a == ball;
    });
    if (event == moment.timeline.events.end()) {
        return std::nullopt;
    }
    std::optional<Vec3> direction = level(event->vector);
    for (const sim::ForceEvent& action : moment.shot.world.events) {
        const auto* strike = std::get_if<sim::Strike>(&action.action);
        if (strike == nullptr || action.object != ball) {
            continue;
        }
        if (strike->direction) {
            direction = towards_angle(*strike->direction);
        } else if (strike->toward_point) {
            direction = level(*strike->toward_point - event->place);
        } else if (const sim::Track* target =
                       strike->toward ? moment.timeline.find(*strike->toward) : nullptr) {
            direction = level(target->sample(event->time).position - event->place);
        }
        break;
    }
    return direction ? std::optional(Aim{event->place, *direction, event->time}) : std::nullopt;
}

std::optional<Aim> aim_of(const AimAnnotation& aim, const SceneMoment& moment) {
    if (!aim.toward && !aim.direction) {
        return aim_of_strike(aim.of, moment);
    }
    const Vec3 from = moment.place({aim.of});
    const std::optional<Vec3> direction = aim.direction
                                              ? std::optional(towards_angle(*aim.direction))
                                              : level(moment.place(*aim.toward) - from);
    return direction ? std::optional(Aim{from, *direction, moment.time}) : std::nullopt;
}

/// How far a ball can go until it touches another one, m.
double way_to_ball(const Aim& aim, const std::string& ball, const SceneMoment& moment) {
    double way = 1e300;
    for (const sim::Body& body : moment.shot.world.bodies) {
        const auto* sphere = std::get_if<sim::Sphere>(&body.shape);
        const sim::Track* track = moment.timeline.find(body.name);
        if (sphere == nullptr || track == nullptr || body.name == ball) {
            continue;
        }
        Vec3 to = track->sample(aim.time).position - aim.from;
        to.z = 0;
        const double along = to.dot(aim.direction);
        const double reach = sphere->radius + moment.radius(ball);
        const double off = to.dot(to) - along * along;
        if (along > 0 && off < reach * reach) {
            way = std::min(way, std::max(0.0, along - std::sqrt(reach * reach - off)));
        }
    }
    return way;
}

/// How far a ball can go until it touches a cushion, m.
double way_to_cushion(const Aim& aim, double radius, const SceneMoment& moment) {
    if (!moment.shot.world.table || !moment.shot.world.table->has_cushions) {
        return kWithoutTable;
    }
    const sim::billiards::TableMeasures& table = *moment.shot.world.table;
    const auto way = [](double from, double direction, double half) {
        if (std::abs(direction) < 1e-12) {
            return 1e300;
        }
        return std::max(0.0, ((direction > 0 ? half : -half) - from) / direction);
    };
    return std::min(way(aim.from.x, aim.direction.x, table.length / 2 - radius),
                    way(aim.from.y, aim.direction.y, table.width / 2 - radius));
}

}  // namespace

SceneShapes shapes_of(const AimAnnotation& aim, const Annotation& look, const SceneMoment& moment) {
    const std::optional<Aim> way = aim_of(aim, moment);
    if (!way) {
        return {};
    }
    const double length = aim.length.value_or(std::min(
        way_to_ball(*way, aim.of, moment), way_to_cushion(*way, moment.radius(aim.of), moment)));
    SceneLine line;
    line.points = {way->from, way->from + length * way->direction};
    line.colour = look.colour.value_or(aim_colour());
    line.width = look.width.value_or(kWidth);
    line.dash = look.dash.value_or(Dash::dashed);
    return {std::move(line)};
}

SceneShapes shapes_of(const GhostAnnotation& ghost, const Annotation& look,
                      const SceneMoment& moment) {
    const std::optional<Contact> contact = first_contact(moment.timeline, ghost.of, ghost.on);
    if (!contact) {
        return {};
    }
    // The circle along which lines of sight touch the ball.
    const double radius = moment.radius(ghost.of);
    const Vec3 to_camera = moment.view.position() - contact->centre;
    const double distance = to_camera.length();
    if (distance <= radius) {
        return {};
    }
    const Vec3 axis = to_camera / distance;
    const double share = radius / distance;
    const Vec3 side = axis.cross(moment.view.up()).normalized();
    SceneArea area;
    area.corners =
        arc_points(contact->centre + radius * share * axis,
                   radius * std::sqrt(1 - share * share) * side, axis, 2 * std::numbers::pi);
    area.corners.pop_back();
    area.colour = look.colour.value_or(aim_colour());
    area.opacity = kGhostOpacity;
    SceneLine edge = edge_of(area, look, kGhostWidth);
    edge.dash_size = kGhostDashes;
    return {std::move(area), std::move(edge)};
}

SceneShapes shapes_of(const TangentAnnotation& tangent, const Annotation& look,
                      const SceneMoment& moment) {
    const std::optional<Contact> contact = first_contact(moment.timeline, tangent.of, tangent.on);
    const std::optional<Vec3> normal = contact ? level(contact->normal) : std::nullopt;
    if (!normal) {
        return {};
    }
    Vec3 direction(-normal->y, normal->x, 0);
    if (direction.dot(contact->velocity) < 0) {
        direction = -direction;
    }
    SceneLine line;
    line.points = {contact->centre - kBehind * moment.radius(tangent.of) * direction,
                   contact->centre + tangent.length * direction};
    line.colour = look.colour.value_or(tangent_colour());
    line.width = look.width.value_or(kWidth);
    line.dash = look.dash.value_or(Dash::dash_dot);
    return {std::move(line)};
}

}  // namespace carom::pipeline
