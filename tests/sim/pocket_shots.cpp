#include "pocket_shots.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shots.h"

namespace carom::sim::test {
namespace {

constexpr double kDistance = 0.5;  // m
constexpr int kOffsets = 13;       // to both sides of the middle
constexpr double kApart = 0.005;

/// True if a ball that rolls from `start` drops into that pocket within `duration`.
bool drops_from(const PocketTable& table, const billiards::PocketLayout& pocket, const Vec2& start,
                const Vec3& velocity, double duration, double jaw_restitution) {
    Body body = ball("one", start.x, start.y, velocity, rolling_spin(velocity, table.radius));
    body.shape = Sphere{table.radius};
    body.mass = table.mass;
    body.pose.position.z = table.radius;
    WorldDescription world;
    world.duration = duration;
    world.table = billiards::standard_table(table.kind, table.size);
    world.table->jaw_restitution = jaw_restitution;
    world.bodies = {body};
    const Timeline timeline = bake(world);
    const Event* potted = find_event(timeline, EventKind::potted, "one");
    return potted != nullptr && potted->b == pocket.pocket.name;
}

}  // namespace

billiards::TableLayout PocketTable::layout() const {
    return billiards::make_layout(*billiards::standard_table(kind, size), radius);
}

const std::vector<PocketTable>& pocket_tables() {
    using billiards::TableKind;
    static const std::vector<PocketTable> tables{{TableKind::pool, "9 ft", 0.028575, 0.170097},
                                                 {TableKind::pool, "8 ft", 0.028575, 0.170097},
                                                 {TableKind::pool, "7 ft", 0.028575, 0.170097},
                                                 {TableKind::snooker, "12 ft", 0.02625, 0.14}};
    return tables;
}

bool drops(const PocketTable& table, const billiards::PocketLayout& pocket,
           const PocketShot& shot) {
    const double c = std::cos(shot.angle);
    const double s = std::sin(shot.angle);
    const Vec2 direction(pocket.axis.x * c - pocket.axis.y * s,
                         pocket.axis.x * s + pocket.axis.y * c);
    const Vec2 left(-direction.y, direction.x);
    const Vec2 start = pocket.mouth - direction * kDistance + left * shot.offset;
    const Vec3 velocity(direction.x * shot.speed, direction.y * shot.speed, 0);
    // Enough time to come to rest in the jaws, but not to return from another cushion.
    return drops_from(table, pocket, start, velocity, 1.2 * kDistance / shot.speed + 0.6,
                      table.layout().measures.jaw_restitution);
}

bool drops_along_rail(const PocketTable& table, const RailShot& shot, double jaw_restitution) {
    const billiards::TableLayout layout = table.layout();
    const billiards::PocketLayout& pocket = layout.pockets.front();  // front left
    const double field_edge = -0.5 * layout.measures.width;
    const double tip = -layout.nose.x + pocket.measures.mouth * std::numbers::sqrt2 / 2;
    const Vec2 direction(-std::cos(shot.angle), -std::sin(shot.angle));
    const Vec2 at_tip(tip, field_edge + table.radius + shot.gap + 1e-6);
    const Vec3 velocity(direction.x * shot.speed, direction.y * shot.speed, 0);
    return drops_from(table, pocket, at_tip - direction * kDistance, velocity,
                      1.2 * kDistance / shot.speed + 0.6, jaw_restitution);
}

double rail_opening(const PocketTable& table, double speed, double angle, double jaw_restitution) {
    constexpr double kStep = 3e-3;
    double inside = -kStep;
    while (inside < 0.05 &&
           drops_along_rail(table, {speed, angle, inside + kStep}, jaw_restitution)) {
        inside += kStep;
    }
    if (inside < 0) {
        return 0;
    }
    double outside = inside + kStep;
    while (outside - inside > 1e-4) {
        const double middle = 0.5 * (inside + outside);
        (drops_along_rail(table, {speed, angle, middle}, jaw_restitution) ? inside : outside) =
            middle;
    }
    return inside;
}

Opening find_opening(const PocketTable& table, const billiards::PocketLayout& pocket, double speed,
                     double angle) {
    const auto drops_at = [&](double offset) {
        return drops(table, pocket, {speed, angle, offset});
    };
    // The longest row of offsets that drop.
    std::vector<int> dropping;
    int first = 0;
    int count = 0;
    int row = 0;
    for (int i = -kOffsets; i <= kOffsets; ++i) {
        const bool is_in = drops_at(i * kApart);
        if (is_in) {
            dropping.push_back(i);
        }
        row = is_in ? row + 1 : 0;
        if (row > count) {
            count = row;
            first = i - row + 1;
        }
    }
    if (count == 0) {
        return {};
    }
    const auto edge = [&](double inside, double outside) {
        while (std::abs(outside - inside) > 1e-4) {
            const double middle = 0.5 * (inside + outside);
            (drops_at(middle) ? inside : outside) = middle;
        }
        return inside;
    };
    const int last = first + count - 1;
    Opening opening{edge(first * kApart, (first - 1) * kApart),
                    edge(last * kApart, (last + 1) * kApart)};
    for (const int i : dropping) {
        if (i >= first && i <= last) {
            continue;
        }
        const double width =
            edge(i * kApart, (i + 1) * kApart) - edge(i * kApart, (i - 1) * kApart);
        opening.beyond = std::max(opening.beyond, width);
    }
    return opening;
}

}  // namespace carom::sim::test
