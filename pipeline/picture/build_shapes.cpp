#include "pipeline/picture/build_shapes.h"

#include <cmath>
#include <numbers>
#include <type_traits>
#include <utility>
#include <variant>

#include "core/elementary.h"
#include "core/error.h"
#include "pipeline/picture/colours.h"

namespace carom::pipeline {
namespace {

constexpr double kStandardRadius = 0.028575;  // m
constexpr double kTextSize = 0.042;           // picture heights
constexpr double kGap = 0.012;                // between a ball and its label, picture heights
constexpr double kAboveCloth = 0.0005;        // m, so that zones are nearer than the cloth
constexpr double kLine = 0.005;               // of a zone's edge, picture heights
constexpr double kZoneOpacity = 0.3;
constexpr double kStepsPerTurn = 96;

}  // namespace

double SceneMoment::radius(const std::string& object) const {
    for (const sim::Body& body : shot.world.bodies) {
        if (body.name == object) {
            const auto* sphere = std::get_if<sim::Sphere>(&body.shape);
            return sphere != nullptr ? sphere->radius : kStandardRadius;
        }
    }
    return kStandardRadius;
}

Vec3 SceneMoment::place(const ScenePoint& point) const {
    const sim::Track* track = point.object.empty() ? nullptr : timeline.find(point.object);
    return track != nullptr ? track->sample(time).position : point.at;
}

SceneText scene_text(std::string text, const Vec3& at, const Annotation& look, double usual_size) {
    SceneText result;
    result.text = std::move(text);
    result.at = at;
    result.font = look.font;
    result.size = look.size.value_or(usual_size);
    result.colour = text_colour();
    result.box = look.box.value_or(TextBox{Vec3(0), 0});
    return result;
}

std::vector<Vec3> arc_points(const Vec3& centre, const Vec3& start, const Vec3& axis, double turn) {
    const Vec3 side = axis.cross(start);
    const int steps = std::max(
        1, static_cast<int>(std::ceil(std::abs(turn) / (2 * std::numbers::pi) * kStepsPerTurn)));
    std::vector<Vec3> points;
    for (int i = 0; i <= steps; ++i) {
        const SinCos at = sin_cos(turn * i / steps);
        points.push_back(centre + at.cos * start + at.sin * side);
    }
    return points;
}

SceneLine edge_of(const SceneArea& area, const Annotation& look, double usual_width) {
    SceneLine edge;
    edge.points = area.corners;
    edge.is_closed = true;
    edge.colour = area.colour;
    edge.width = look.width.value_or(usual_width);
    edge.dash = look.dash.value_or(Dash::solid);
    return edge;
}

SceneShapes shapes_of(const ZoneAnnotation& zone, const Annotation& look,
                      const SceneMoment& moment) {
    SceneArea area;
    if (zone.radius) {
        Vec3 centre = moment.place(zone.at);
        centre.z = kAboveCloth;
        area.corners = arc_points(centre, {*zone.radius, 0, 0}, {0, 0, 1}, 2 * std::numbers::pi);
        area.corners.pop_back();
    }
    for (const Vec2& corner : zone.polygon) {
        area.corners.emplace_back(corner.x, corner.y, kAboveCloth);
    }
    area.colour = look.colour.value_or(zone_colour());
    area.opacity = kZoneOpacity;
    SceneLine edge = edge_of(area, look, kLine);
    return {std::move(area), std::move(edge)};
}

SceneShapes shapes_of(const LabelAnnotation& label, const Annotation& look,
                      const SceneMoment& moment) {
    const auto pieces = parse_value_text(label.text);
    if (const auto* problem = std::get_if<TextProblem>(&pieces)) {
        throw Error(problem->sentence);
    }
    const double radius = moment.radius(label.of);
    SceneText text = scene_text(
        text_with_values(std::get<std::vector<TextPiece>>(pieces), moment.values, moment.timeline),
        moment.place({label.of}) + radius * moment.view.up(), look, kTextSize);
    text.colour = look.colour.value_or(text_colour());
    text.nearer = radius;
    text.offset = {0, kGap};
    text.is_above = true;
    return {std::move(text)};
}

SceneShapes shapes_of(const Annotation& annotation, const SceneMoment& moment) {
    return std::visit(
        [&](const auto& kind) -> SceneShapes {
            using Kind = std::decay_t<decltype(kind)>;
            if constexpr (std::is_same_v<Kind, TextAnnotation> ||
                          std::is_same_v<Kind, TitleAnnotation> ||
                          std::is_same_v<Kind, TipAnnotation> ||
                          std::is_same_v<Kind, PlanAnnotation> ||
                          std::is_same_v<Kind, ImageAnnotation>) {
                return {};
            } else {
                return shapes_of(kind, annotation, moment);
            }
        },
        annotation.kind);
}

}  // namespace carom::pipeline
