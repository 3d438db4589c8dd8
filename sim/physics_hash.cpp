#include <cstdint>
#include <string_view>
#include <variant>

#include "sim/bake.h"

namespace carom::sim {
namespace {

/// Counts up with every change to the simulation that can change a bake.
constexpr std::int64_t kSimulationRevision = 10;

template <typename T, typename Add>
void add_optional(Hasher& hasher, const std::optional<T>& value, Add add) {
    hasher.add(value.has_value());
    if (value) {
        add(*value);
    }
}

void add(Hasher& hasher, const PairContact& pair) {
    hasher.add(pair.restitution).add(pair.friction).add(pair.rolling_friction);
}

void add(Hasher& hasher, const ContactLaw& law) {
    hasher.add(law.ball_cloth.sliding_friction)
        .add(law.ball_cloth.rolling_friction)
        .add(law.ball_cloth.spinning_friction)
        .add(law.ball_cloth.restitution)
        .add(law.ball_ball.restitution)
        .add(law.ball_ball.friction)
        .add(static_cast<std::int64_t>(law.ball_ball.friction_model))
        .add(static_cast<std::int64_t>(law.ball_cushion.model))
        .add(law.ball_cushion.restitution)
        .add(law.ball_cushion.friction)
        .add(law.hop);
    add(hasher, law.otherwise);
    hasher.add(std::uint64_t{law.pairs.size()});
    for (const auto& [names, pair] : law.pairs) {
        hasher.add(std::string_view(names.first)).add(std::string_view(names.second));
        add(hasher, pair);
    }
}

void add(Hasher& hasher, const billiards::PocketMeasures& pocket) {
    hasher.add(pocket.mouth)
        .add(pocket.throat)
        .add(pocket.jaw_angle)
        .add(pocket.hole_radius)
        .add(pocket.shelf)
        .add(pocket.drop)
        .add(pocket.lip_radius);
}

void add(Hasher& hasher, const billiards::TableMeasures& table) {
    hasher.add(static_cast<std::int64_t>(table.kind))
        .add(table.length)
        .add(table.width)
        .add(table.nose_height)
        .add(table.cushion_width)
        .add(table.rail_width)
        .add(table.rail_height)
        .add(table.height)
        .add(table.has_cushions);
    const auto add_pocket = [&](const billiards::PocketMeasures& pocket) { add(hasher, pocket); };
    add_optional(hasher, table.corner_pocket, add_pocket);
    add_optional(hasher, table.side_pocket, add_pocket);
}

struct ShapeHash {
    Hasher& hasher;

    void operator()(const Sphere& sphere) const { hasher.add(sphere.radius); }
    void operator()(const Box& box) const { hasher.add(box.size); }
    void operator()(const Capsule& capsule) const {
        hasher.add(capsule.radius).add(capsule.length);
    }
    void operator()(const Cylinder& cylinder) const {
        hasher.add(cylinder.radius).add(cylinder.height);
    }
    void operator()(const ConvexHull& hull) const {
        hasher.add(std::uint64_t{hull.points.size()});
        for (const Vec3& point : hull.points) {
            hasher.add(point);
        }
    }
    void operator()(const TriangleMesh& mesh) const {
        hasher.add(std::uint64_t{mesh.vertices.size()});
        for (const Vec3& vertex : mesh.vertices) {
            hasher.add(vertex);
        }
        hasher.add(std::uint64_t{mesh.triangles.size()});
        for (const auto& triangle : mesh.triangles) {
            for (const std::uint32_t index : triangle) {
                hasher.add(index);
            }
        }
    }
};

void add(Hasher& hasher, const KeyedPath& path) {
    hasher.add(path.centre).add(std::uint64_t{path.track->keys().size()});
    for (const Key& key : path.track->keys()) {
        hasher.add(key.time)
            .add(key.position)
            .add(key.orientation)
            .add(key.velocity_in)
            .add(key.angular_velocity_in)
            .add(key.velocity_out)
            .add(key.angular_velocity_out);
    }
}

void add(Hasher& hasher, const Body& body) {
    hasher.add(std::string_view(body.name)).add(std::uint64_t{body.shape.index()});
    std::visit(ShapeHash{hasher}, body.shape);
    hasher.add(static_cast<std::int64_t>(body.kind))
        .add(body.mass)
        .add(std::string_view(body.material))
        .add(body.pose.position)
        .add(body.pose.orientation)
        .add(body.velocity)
        .add(body.angular_velocity);
    if (body.path && body.path->track) {
        add(hasher, *body.path);
    }
}

struct ActionHash {
    Hasher& hasher;

    void operator()(const Force& force) const {
        hasher.add(force.newtons).add(force.duration).add(force.at_point);
        hasher.add(static_cast<std::int64_t>(force.axes));
    }
    void operator()(const Torque& torque) const {
        hasher.add(torque.newton_metres).add(torque.duration);
        hasher.add(static_cast<std::int64_t>(torque.axes));
    }
    void operator()(const Impulse& impulse) const {
        hasher.add(impulse.newton_seconds).add(impulse.at_point);
        hasher.add(static_cast<std::int64_t>(impulse.axes));
    }
    void operator()(const SetVelocity& velocity) const {
        const auto add_vector = [this](const Vec3& v) { hasher.add(v); };
        add_optional(hasher, velocity.linear, add_vector);
        add_optional(hasher, velocity.angular, add_vector);
    }
    void operator()(const Strike& strike) const {
        const auto add_number = [this](double v) { hasher.add(v); };
        add_optional(hasher, strike.speed, add_number);
        add_optional(hasher, strike.ball_speed, add_number);
        add_optional(hasher, strike.toward,
                     [this](const std::string& v) { hasher.add(std::string_view(v)); });
        add_optional(hasher, strike.toward_point, [this](const Vec3& v) { hasher.add(v); });
        add_optional(hasher, strike.direction, add_number);
        hasher.add(strike.elevation)
            .add(strike.tip)
            .add(strike.stick_mass)
            .add(strike.end_mass_ratio);
    }
};

void add(Hasher& hasher, const ForceEvent& event) {
    hasher.add(std::string_view(event.object)).add(event.time);
    add_optional(hasher, event.trigger, [&](const Trigger& trigger) {
        hasher.add(static_cast<std::int64_t>(trigger.kind))
            .add(std::string_view(trigger.a))
            .add(std::string_view(trigger.b))
            .add(trigger.from)
            .add(trigger.to);
    });
    hasher.add(event.after).add(std::uint64_t{event.action.index()});
    std::visit(ActionHash{hasher}, event.action);
}

}  // namespace

Hash128 physics_hash(const WorldDescription& world) {
    Hasher hasher;
    hasher.add("carom physics").add(kSimulationRevision);
    hasher.add(world.gravity)
        .add(world.duration)
        .add(world.step)
        .add(world.seed)
        .add(world.key_reduction.position_error)
        .add(world.key_reduction.orientation_error);
    add(hasher, world.contact_law);
    add_optional(hasher, world.table,
                 [&](const billiards::TableMeasures& table) { add(hasher, table); });
    add_optional(hasher, world.floor_height, [&](double height) { hasher.add(height); });
    hasher.add(std::uint64_t{world.bodies.size()});
    for (const Body& body : world.bodies) {
        add(hasher, body);
    }
    hasher.add(std::uint64_t{world.events.size()});
    for (const ForceEvent& event : world.events) {
        add(hasher, event);
    }
    return hasher.finish();
}

}  // namespace carom::sim
