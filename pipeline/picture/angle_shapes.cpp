// Angles: two sides, an arc and the value.
#include <cmath>
#include <numbers>
#include <optional>

#include "core/elementary.h"
#include "pipeline/picture/build_shapes.h"
#include "pipeline/picture/colours.h"
#include "pipeline/picture/contact.h"

namespace carom::pipeline {
namespace {

constexpr double kWidth = 0.005;     // picture heights
constexpr double kTextSize = 0.042;  // picture heights
constexpr double kBeyond = 1.12;     // of the sides, radii of the arc
constexpr double kText = 1.4;        // of the value's place, radii of the arc
constexpr double kResting = 1e-3;    // m/s

struct Sides {
    Vec3 vertex;
    Vec3 first, second;  // unit, level
};

std::optional<Vec3> level(const Vec3& vector, double least) {
    const double length = std::sqrt(vector.x * vector.x + vector.y * vector.y);
    if (length < least) {
        return std::nullopt;
    }
    return Vec3(vector.x / length, vector.y / length, 0);
}

std::optional<Sides> sides_of(const Vec3& vertex, const std::optional<Vec3>& first,
                              const std::optional<Vec3>& second) {
    return first && second ? std::optional(Sides{vertex, *first, *second}) : std::nullopt;
}

/// The direction in which an object moves `after` a contact.
std::optional<Vec3> way_after(const std::string& object, const Contact& contact, double after,
                              const SceneMoment& moment) {
    const sim::Track* track = moment.timeline.find(object);
    return track != nullptr ? level(track->sample(contact.time + after).velocity, kResting)
                            : std::nullopt;
}

std::optional<Sides> sides_of(const AngleAnnotation& angle, const SceneMoment& moment) {
    if (!angle.points.empty()) {
        const Vec3 vertex = moment.place(angle.points[1]);
        return sides_of(vertex, level(moment.place(angle.points[0]) - vertex, 1e-6),
                        level(moment.place(angle.points[2]) - vertex, 1e-6));
    }
    const std::vector<std::string>& names =
        angle.between.empty() ? angle.deflection : angle.between;
    const std::optional<Contact> contact = first_contact(moment.timeline, names[0], names[1]);
    if (!contact) {
        return std::nullopt;
    }
    const std::optional<Vec3> first = way_after(names[0], *contact, angle.after, moment);
    return sides_of(contact->centre, first,
                    angle.between.empty() ? level(contact->velocity, kResting)
                                          : way_after(names[1], *contact, angle.after, moment));
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
    const double turn =
        angle_of(sides->first.dot(sides->second), sides->first.cross(sides->second).z);
    SceneShapes shapes{line_of({vertex, vertex + kBeyond * angle.radius * sides->first}, look),
                       line_of({vertex, vertex + kBeyond * angle.radius * sides->second}, look)};
    const Vec3 axis(0, 0, 1);
    shapes.push_back(line_of(arc_points(vertex, angle.radius * sides->first, axis, turn), look));
    if (angle.value) {
        const Vec3 middle = arc_points({0, 0, 0}, sides->first, axis, turn / 2).back();
        const double degrees = std::abs(turn) * 180 / std::numbers::pi;
        SceneText text = scene_text(number_text(degrees, "", ".0f") + "°",
                                    vertex + kText * angle.radius * middle, look, kTextSize);
        text.colour = look.colour.value_or(angle_colour());
        shapes.push_back(std::move(text));
    }
    return shapes;
}

}  // namespace carom::pipeline
