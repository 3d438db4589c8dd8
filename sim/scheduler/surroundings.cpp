#include "sim/scheduler/surroundings.h"

#include <cmath>

namespace carom::sim {
namespace {

/// The radius that the table's cushions are drawn for: that of the first ball.
double table_ball_radius(const WorldDescription& world) {
    for (const Body& body : world.bodies) {
        const auto* sphere = std::get_if<Sphere>(&body.shape);
        if (sphere != nullptr && body.kind == BodyKind::dynamic && body.material == "ball")
            return sphere->radius;
    }
    return Sphere{}.radius;
}

}  // namespace

Surroundings::Surroundings(const WorldDescription& world)
    : gravity(world.gravity), law(world.contact_law), floor_height(world.floor_height) {
    if (gravity.x == 0 && gravity.y == 0 && gravity.z < 0)
        downward_gravity = -gravity.z;
    if (!world.table)
        return;
    has_cloth = true;
    has_cushions = world.table->has_cushions;
    nose_height = world.table->nose_height;
    cloth_half_extent =
        Vec2(world.table->length, world.table->width) * 0.5 + Vec2(world.table->cushion_width);
    if (has_cushions)
        table = billiards::build_table(*world.table, table_ball_radius(world));
}

bool Surroundings::is_over_cloth(const Vec3& centre) const {
    if (!has_cloth)
        return false;
    if (!has_cushions)
        return true;
    return std::abs(centre.x) <= cloth_half_extent.x && std::abs(centre.y) <= cloth_half_extent.y &&
           pocket_below(centre) < 0;
}

int Surroundings::pocket_below(const Vec3& centre) const {
    for (std::size_t i = 0; i < table.pockets.size(); ++i) {
        const billiards::Pocket& pocket = table.pockets[i];
        const Vec2 d = Vec2(centre.x, centre.y) - pocket.centre;
        if (d.dot(d) < pocket.radius * pocket.radius)
            return static_cast<int>(i);
    }
    return -1;
}

}  // namespace carom::sim
