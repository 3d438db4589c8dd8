// Warns of balls with an unlikely initial position.
#include <algorithm>
#include <cmath>

#include "pipeline/config/build/builder.h"
#include "pipeline/config/show_quantity.h"
#include "pipeline/config/text.h"

namespace carom::pipeline::config {

namespace {

/// A ball farther from the table's rails than this (m) is probably given in another unit.
constexpr double kFarAway = 2;

/// The horizontal distance from the table; 0 above and under it.
double distance_from_table(const Vec2& half, const Vec3& position) {
    const double x = std::max(std::abs(position.x) - half.x, 0.0);
    const double y = std::max(std::abs(position.y) - half.y, 0.0);
    return std::hypot(x, y);
}

/// "0.3 m", with at most three digits.
std::string rounded(double metres) {
    const double scale = std::pow(10, 2 - std::floor(std::log10(metres)));
    return show(std::round(metres * scale) / scale) + " m";
}

Place place_of_ball(const Builder& builder, const std::string& name) {
    return builder.place_of({"balls", name, "at"});
}

void warn_far_away(const sim::Body& ball, double distance, Builder& builder) {
    const Vec3& at = ball.pose.position;
    const Vec2 half = half_outline(*builder.shot.world.table);
    std::string hint = "; lengths without a unit are in metres";
    if (distance_from_table(half, at * 1e-3) == 0) {
        hint += ": for millimetres write [" + show(at.x) + " mm, " + show(at.y) + " mm]";
    }
    builder.reader.warning(
        place_of_ball(builder, ball.name),
        quote(ball.name) + " starts " + rounded(distance) + " away from the table" + hint);
}

bool is_over_a_pocket(const Vec3& place, const Builder& builder) {
    if (!builder.table_geometry) {
        return false;
    }
    const auto& pockets = builder.table_geometry->pockets;
    return std::any_of(pockets.begin(), pockets.end(), [&](const auto& pocket) {
        return (Vec2(place.x, place.y) - pocket.centre).length() < pocket.radius;
    });
}

void check_ball(const sim::Body& ball, double radius, Builder& builder) {
    const sim::billiards::TableMeasures& table = *builder.shot.world.table;
    const Vec3& at = ball.pose.position;
    const double distance = distance_from_table(half_outline(table), at);
    if (distance > kFarAway) {
        return warn_far_away(ball, distance, builder);
    }
    if (distance > 0 && !table.has_cushions && builder.shot.draws_table) {
        builder.reader.warning(place_of_ball(builder, ball.name),
                               quote(ball.name) + " starts " + rounded(distance) +
                                   " outside the drawn cloth, a square of " + show(table.length) +
                                   " m");
    }
    const bool is_under_table = distance == 0 || !table.has_cushions;
    if (is_under_table && at.z < -radius && !is_over_a_pocket(at, builder)) {
        builder.reader.warning(place_of_ball(builder, ball.name),
                               quote(ball.name) + " starts with its centre " + rounded(-at.z) +
                                   " below the cloth; heights are measured upwards from the cloth, "
                                   "and a ball without a height lies on it");
    }
}

}  // namespace

void warn_about_ball_positions(Builder& builder) {
    if (!builder.shot.world.table || builder.reader.has_error()) {
        return;
    }
    for (const sim::Body& body : builder.shot.world.bodies) {
        const auto* sphere = std::get_if<sim::Sphere>(&body.shape);
        const bool is_ball = std::any_of(builder.file.balls.begin(), builder.file.balls.end(),
                                         [&](const auto& ball) { return ball.name == body.name; });
        if (sphere != nullptr && is_ball) {
            check_ball(body, sphere->radius, builder);
        }
    }
}

}  // namespace carom::pipeline::config
