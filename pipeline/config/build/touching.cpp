// Places the balls that touch another ball, an object or a cushion.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/elementary.h"
#include "pipeline/config/build/builder.h"
#include "pipeline/config/text.h"
#include "sim/billiards/layout.h"
#include "sim/solid_shape.h"
#include "sim/spatial/convex_impact_time.h"
#include "sim/timeline/surface.h"

namespace carom::pipeline::config {

namespace {

using Ball = const Named<BallSection>*;

sim::Body* body_named(Builder& builder, const std::string& name) {
    std::vector<sim::Body>& bodies = builder.shot.world.bodies;
    const auto found = std::ranges::find(bodies, name, &sim::Body::name);
    return found != bodies.end() ? &*found : nullptr;
}

double radius_of(const sim::Body& ball) {
    return std::get<sim::Sphere>(ball.shape).radius;
}

/// From how far along the level unit vector `away` from its centre a ball of `radius` at height
/// `radius` touches the body; empty for a surface, and for a body that it does not meet there.
std::optional<double> touching_distance(const sim::Body& body, const Vec3& away, double radius) {
    const double rise = radius - body.pose.position.z;
    if (const auto* sphere = std::get_if<sim::Sphere>(&body.shape)) {
        const double reach = sphere->radius + radius;
        return std::abs(rise) < reach ? std::optional(std::sqrt(reach * reach - rise * rise))
                                      : std::nullopt;
    }
    const std::optional<sim::SolidShape> solid = sim::solid_shape(body.shape);
    if (!solid) {
        return std::nullopt;
    }
    const Pose pose{body.pose.position, body.pose.orientation * solid->principal};
    const auto depth_at = [&](double distance) {
        const Vec3 centre = body.pose.position + away * distance + Vec3(0, 0, rise);
        return sim::convex_contact(*solid->shape, pose, centre, radius).depth;
    };
    double inside = 0, outside = 2 * radius;
    if (depth_at(inside) <= 0) {
        return std::nullopt;
    }
    while (depth_at(outside) > 0) {
        outside *= 2;
    }
    for (int i = 0; i < 100 && inside < outside; ++i) {
        const double middle = 0.5 * (inside + outside);
        (depth_at(middle) > 0 ? inside : outside) = middle;
    }
    return outside;
}

/// The place against the partner, which has its own.
std::optional<Vec3> place_against(const sim::Body& partner, const sim::Body& ball,
                                  double direction) {
    const SinCos turn = sin_cos(direction);
    const double radius = radius_of(ball);
    const Vec3& centre = partner.pose.position;
    // Both balls lie on the cloth, whatever the place of the other one says.
    const auto* other = std::get_if<sim::Sphere>(&partner.shape);
    const auto distance = other != nullptr && partner.material == "ball"
                              ? std::optional(2 * std::sqrt(radius * other->radius))
                              : touching_distance(partner, {turn.cos, turn.sin, 0}, radius);
    return distance ? std::optional(Vec3(centre.x + *distance * turn.cos,
                                         centre.y + *distance * turn.sin, radius))
                    : std::nullopt;
}

/// The distance from the nose line at which a ball on the cloth touches the cushion: its nose, or a
/// small ball the face under it, which leans back.
double cushion_distance(const sim::billiards::TableLayout& layout, double radius) {
    const double above = layout.measures.nose_height - radius;
    const SinCos lean = sin_cos(layout.undercut);
    const double at_face = (radius - above * lean.sin) / lean.cos;
    const bool touches_face = above * lean.cos > at_face * lean.sin;
    return touches_face ? at_face : std::sqrt(std::max(0.0, radius * radius - above * above));
}

/// Places a ball against a cushion; reports one that has none there.
void place_at_cushion(Builder& builder, Ball given, sim::Body& ball) {
    const TouchingPlace& touching = *given->value.touching;
    const Place place = builder.place_of({"balls", given->name, "touching", "cushion"});
    const auto& table = builder.shot.world.table;
    if (!table || !table->has_cushions) {
        if (!builder.file.table || table) {
            builder.reader.error(place, "the shot has no table with cushions");
        }
        return;
    }
    const auto layout = sim::billiards::make_layout(*table, measures_of_set(builder.file).radius);
    const sim::billiards::SideFrame& side =
        layout.sides[static_cast<std::size_t>(*touching.cushion)];
    // u runs counter-clockwise around the field, `along` with x or y.
    const double u = touching.along.value_or(0) * (side.along.x + side.along.y);
    const bool has_nose = std::ranges::any_of(layout.cushions, [&](const auto& cushion) {
        const auto cut = [](const auto& jaw) { return jaw ? jaw->lip_tangent_length : 0; };
        return cushion.side.origin == side.origin && u >= cushion.from + cut(cushion.jaw_from) &&
               u <= cushion.to - cut(cushion.jaw_to);
    });
    if (!has_nose && touching.along) {
        builder.reader.error(
            builder.place_of({"balls", given->name, "touching", "along"}),
            "the cushion has no nose there: it is the place of a pocket, or beyond the end");
        return;
    }
    const double radius = radius_of(ball);
    const Vec2 centre = side.at(u, -cushion_distance(layout, radius));
    ball.pose.position = {centre.x, centre.y, radius};
}

}  // namespace

/// Starts from those whose partner has its place.
void place_touching_balls(Builder& builder) {
    std::vector<Ball> waiting;
    for (const Named<BallSection>& ball : builder.file.balls) {
        sim::Body* body = ball.value.touching ? body_named(builder, ball.name) : nullptr;
        if (body != nullptr && sim::is_surface(ball.value.touching->partner)) {
            builder.reader.error(builder.place_of({"balls", ball.name, "touching", "object"}),
                                 quote(ball.value.touching->partner) +
                                     " is a part of the table, no object; a side of the table is "
                                     "given by the key 'cushion'");
        } else if (body != nullptr && ball.value.touching->cushion) {
            place_at_cushion(builder, &ball, *body);
        } else if (body != nullptr) {
            waiting.push_back(&ball);
        }
    }
    const auto place = [&](Ball ball) {
        const std::string& partner = ball->value.touching->partner;
        const sim::Body* other = body_named(builder, partner);
        if (other == nullptr ||
            std::ranges::find(waiting, partner, &Named<BallSection>::name) != waiting.end()) {
            return false;
        }
        sim::Body& body = *body_named(builder, ball->name);
        if (const auto at = place_against(*other, body, ball->value.touching->direction)) {
            body.pose.position = *at;
        } else {
            builder.reader.error(
                builder.place_of({"balls", ball->name, "touching"}),
                quote(partner) + " has no side there that a ball on the cloth could touch");
        }
        return true;
    };
    for (std::size_t before = 0; before != waiting.size();) {
        before = waiting.size();
        std::erase_if(waiting, place);
    }
    const auto exists = [&](Ball ball) {
        return body_named(builder, ball->value.touching->partner) != nullptr;
    };
    if (!waiting.empty() && std::ranges::all_of(waiting, exists)) {  // else a name is unknown
        builder.reader.error(waiting.front()->place,
                             "ball '" + waiting.front()->name + "' touches '" +
                                 waiting.front()->value.touching->partner +
                                 "', but none of the balls that touch each other has "
                                 "a place: one needs the key 'at'");
    }
}

}  // namespace carom::pipeline::config
