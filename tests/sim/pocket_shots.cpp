#include "pocket_shots.h"

#include <cmath>

#include "shots.h"

namespace carom::sim::test {
namespace {

constexpr double kAway = 0.5;      // m
constexpr double kFarthest = 0.08;  // m
constexpr double kLook = 0.004;

/// From 0 outwards on the side of `sign`: the last offset that drops before the first that misses.
double edge(const PocketTable& table, const billiards::PocketLayout& pocket, PocketShot shot,
            double sign, double& beyond) {
    const auto drops_at = [&](double offset) {
        shot.offset = sign * offset;
        return drops(table, pocket, shot);
    };
    double inside = 0;
    double outside = kLook;
    while (outside <= kFarthest && drops_at(outside)) {
        inside = outside;
        outside += kLook;
    }
    for (double offset = outside + kLook; offset <= kFarthest; offset += kLook)
        beyond += drops_at(offset) ? kLook : 0;
    while (outside - inside > 1e-4) {
        const double middle = 0.5 * (inside + outside);
        (drops_at(middle) ? inside : outside) = middle;
    }
    return sign * inside;
}

}  // namespace

billiards::TableLayout PocketTable::layout() const {
    return billiards::lay_out(*billiards::standard_table(kind, size), radius);
}

const std::vector<PocketTable>& pocket_tables() {
    using billiards::TableKind;
    static const std::vector<PocketTable> tables{{TableKind::pool, "9 ft", 0.028575, 0.170097},
                                                 {TableKind::pool, "8 ft", 0.028575, 0.170097},
                                                 {TableKind::pool, "7 ft", 0.028575, 0.170097},
                                                 {TableKind::snooker, "12 ft", 0.02619375, 0.14}};
    return tables;
}

bool drops(const PocketTable& table, const billiards::PocketLayout& pocket,
           const PocketShot& shot) {
    const double c = std::cos(shot.angle);
    const double s = std::sin(shot.angle);
    const Vec2 way(pocket.axis.x * c - pocket.axis.y * s, pocket.axis.x * s + pocket.axis.y * c);
    const Vec2 left(-way.y, way.x);
    const Vec2 start = pocket.mouth - way * kAway + left * shot.offset;
    const Vec3 velocity(way.x * shot.speed, way.y * shot.speed, 0);
    Body body = ball("one", start.x, start.y, velocity, rolling_spin(velocity, table.radius));
    body.shape = Sphere{table.radius};
    body.mass = table.mass;
    body.pose.position.z = table.radius;
    WorldDescription world;
    // Time to come to rest in the jaws, none to come back from another cushion.
    world.duration = 1.2 * kAway / shot.speed + 0.6;
    world.table = billiards::standard_table(table.kind, table.size);
    world.bodies = {body};
    const Timeline timeline = bake(world).timeline;
    const Event* potted = find_event(timeline, EventKind::potted, "one");
    return potted != nullptr && potted->b == pocket.pocket.name;
}

Opening find_opening(const PocketTable& table, const billiards::PocketLayout& pocket, double speed,
                     double angle) {
    Opening opening;
    const PocketShot shot{speed, angle, 0};
    if (!drops(table, pocket, shot))
        return opening;
    opening.high = edge(table, pocket, shot, 1, opening.beyond);
    opening.low = edge(table, pocket, shot, -1, opening.beyond);
    return opening;
}

}  // namespace carom::sim::test
