// Balls that stand in each other or in a cushion.
#include <algorithm>
#include <cmath>

#include "pipeline/config/build/builder.h"
#include "pipeline/config/text.h"
#include "pipeline/config/units.h"

namespace carom::pipeline::config {

namespace {

struct Ball {
    const sim::Body* body = nullptr;
    double radius = 0;
};

std::vector<Ball> spheres(const Builder& builder) {
    std::vector<Ball> balls;
    for (const sim::Body& body : builder.shot.world.bodies) {
        if (const auto* sphere = std::get_if<sim::Sphere>(&body.shape)) {
            balls.push_back({&body, sphere->radius});
        }
    }
    return balls;
}

/// "0.31 mm"
std::string millimetres(double metres) {
    return show(std::round(metres * 1e5) / 100) + " mm";
}

Place place_of_body(const Builder& builder, const sim::Body& body) {
    return builder.placed.at(body.name);
}

void check_pair(const Ball& a, const Ball& b, Builder& builder) {
    const Vec3 d = a.body->pose.position - b.body->pose.position;
    const double overlap = a.radius + b.radius - std::sqrt(d.dot(d));
    if (overlap > 1e-9 * (a.radius + b.radius)) {
        builder.reader.error(place_of_body(builder, *b.body),
                             quote(b.body->name) + " and " + quote(a.body->name) + " overlap by " +
                                 millimetres(std::max(overlap, 1e-5)));
    }
}

/// Distance in the plane from a point to the segment from -> to.
double distance_to(const Vec2& point, const Vec2& from, const Vec2& to) {
    const Vec2 along = to - from;
    const double length2 = along.dot(along);
    const double t = length2 > 0 ? std::clamp((point - from).dot(along) / length2, 0.0, 1.0) : 0.0;
    const Vec2 gap = point - (from + along * t);
    return std::sqrt(gap.dot(gap));
}

bool is_over_pocket(const Vec2& point, double radius, const Builder& builder) {
    const auto& pockets = builder.table_geometry->pockets;
    return std::any_of(pockets.begin(), pockets.end(), [&](const sim::billiards::Pocket& pocket) {
        const Vec2 gap = point - pocket.centre;
        const double reach = pocket.radius + radius;
        return gap.dot(gap) < reach * reach;
    });
}

/// Whether a ball that is low enough to touch a cushion reaches into one or into the rail.
bool is_in_cushion(const Ball& ball, const Builder& builder) {
    const sim::billiards::TableMeasures& table = *builder.shot.world.table;
    const Vec3& centre = ball.body->pose.position;
    const double rise = table.nose_height - centre.z;
    if (std::abs(rise) >= ball.radius) {
        return false;
    }
    // The nose is a line at its height: what the ball has there is a circle.
    const double reach = std::sqrt(ball.radius * ball.radius - rise * rise) - 1e-6;
    const Vec2 point(centre.x, centre.y);
    const auto& faces = builder.table_geometry->faces;
    const bool touches =
        std::any_of(faces.begin(), faces.end(), [&](const sim::billiards::CushionFace& face) {
            return distance_to(point, face.from, face.to) < reach;
        });
    const bool is_inside =
        std::abs(point.x) < table.length / 2 && std::abs(point.y) < table.width / 2;
    const double outer = table.cushion_width + table.rail_width;
    const bool is_over_frame = !is_inside && std::abs(point.x) < table.length / 2 + outer &&
                               std::abs(point.y) < table.width / 2 + outer;
    return touches || (is_over_frame && !is_over_pocket(point, ball.radius, builder));
}

}  // namespace

void check_placement(Builder& builder) {
    const std::vector<Ball> balls = spheres(builder);
    for (std::size_t j = 0; j < balls.size(); ++j) {
        for (std::size_t i = 0; i < j; ++i) {
            check_pair(balls[i], balls[j], builder);
        }
    }
    const bool has_cushions = builder.table_geometry && builder.shot.world.table->has_cushions;
    for (const Ball& ball : balls) {
        if (has_cushions && is_in_cushion(ball, builder)) {
            builder.reader.warning(place_of_body(builder, *ball.body),
                                   quote(ball.body->name) + " stands in a cushion");
        }
    }
}

}  // namespace carom::pipeline::config
