// Angles: two sides, an arc and the value.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "core/elementary.h"
#include "pipeline/picture/build_shapes.h"
#include "pipeline/picture/colours.h"
#include "pipeline/picture/contact.h"
#include "pipeline/picture/measured_way.h"

namespace carom::pipeline {
namespace {

constexpr double kWidth = 0.005;     // picture heights
constexpr double kTextSize = 0.042;  // picture heights
constexpr double kBeyond = 1.12;     // of the sides, radii of the arc
constexpr double kText = 1.4;        // of the value's place, radii of the arc
constexpr double kResting = 1e-3;    // m/s

/// One side of an angle.
struct Side {
    Vec3 direction;                                         // unit, level
    double most = std::numeric_limits<double>::infinity();  // of its length, m
};

struct Sides {
    Vec3 vertex;
    Side first, second;
};

std::optional<Vec3> level(const Vec3& vector, double least) {
    const double length = std::sqrt(vector.x * vector.x + vector.y * vector.y);
    if (length < least) {
        return std::nullopt;
    }
    return Vec3(vector.x / length, vector.y / length, 0);
}

std::optional<Side> side_along(const std::optional<Vec3>& direction) {
    return direction ? std::optional(Side{*direction}) : std::nullopt;
}

std::optional<Sides> sides_of(const Vec3& vertex, const std::optional<Side>& first,
                              const std::optional<Side>& second) {
    return first && second ? std::optional(Sides{vertex, *first, *second}) : std::nullopt;
}

/// Along the way of an object after the contact, as far as it goes before its next contact.
std::optional<Side> side_after(const std::string& object, const std::string& other,
                               const Contact& contact, const AngleAnnotation& angle,
                               const SceneMoment& moment) {
    const auto way = measured_way(moment.timeline, object, contact, other, angle.after);
    if (!way || !way->direction) {
        return std::nullopt;
    }
    Side side{*way->direction};
    if (way->end != WayEnd::none) {
        side.most = std::max(0.0, side.direction.dot(way->end_place - contact.centre));
    }
    return side;
}

std::optional<Sides> sides_of(const AngleAnnotation& angle, const SceneMoment& moment) {
    if (!angle.points.empty()) {
        const Vec3 vertex = moment.place(angle.points[1]);
        return sides_of(vertex, side_along(level(moment.place(angle.points[0]) - vertex, 1e-6)),
                        side_along(level(moment.place(angle.points[2]) - vertex, 1e-6)));
    }
    const std::vector<std::string>& names =
        angle.between.empty() ? angle.deflection : angle.between;
    const std::optional<Contact> contact = first_contact(moment.timeline, names[0], names[1]);
    if (!contact) {
        return std::nullopt;
    }
    const std::optional<Side> first = side_after(names[0], names[1], *contact, angle, moment);
    return sides_of(contact->centre, first,
                    angle.between.empty()
                        ? side_along(level(contact->velocity, kResting))
                        : side_after(names[1], names[0], *contact, angle, moment));
}

SceneLine line_of(std::vector<Vec3> points, const Annotation& look) {
    SceneLine line;
    line.points = std::move(points);
    line.colour = look.colour.value_or(angle_colour());
    line.width = look.width.value_or(kWidth);
    line.dash = look.dash.value_or(Dash::solid);
    return line;
}

}  // namespace

SceneShapes shapes_of(const AngleAnnotation& angle, const Annotation& look,
                      const SceneMoment& moment) {
    const std::optional<Sides> sides = sides_of(angle, moment);
    if (!sides) {
        return {};
    }
    const Vec3& vertex = sides->vertex;
    const auto& [first, most_of_first] = sides->first;
    const auto& [second, most_of_second] = sides->second;
    const double turn = arctangent2(first.cross(second).z, first.dot(second));
    const double length = kBeyond * angle.radius;
    SceneShapes shapes{line_of({vertex, vertex + std::min(length, most_of_first) * first}, look),
                       line_of({vertex, vertex + std::min(length, most_of_second) * second}, look)};
    const Vec3 axis(0, 0, 1);
    const double radius =
        std::min({angle.radius, most_of_first / kBeyond, most_of_second / kBeyond});
    shapes.push_back(line_of(arc_points(vertex, radius * first, axis, turn), look));
    if (angle.value) {
        const Vec3 middle = arc_points({0, 0, 0}, first, axis, turn / 2).back();
        const double degrees = std::abs(turn) * 180 / std::numbers::pi;
        SceneText text = scene_text(number_text(degrees, "", ".0f") + "°",
                                    vertex + kText * angle.radius * middle, look, kTextSize);
        text.colour = look.colour.value_or(angle_colour());
        shapes.push_back(std::move(text));
    }
    return shapes;
}

}  // namespace carom::pipeline
