#include <memory>
#include <utility>
#include <variant>

#include "core/error.h"
#include "pipeline/config/build/body_shape.h"
#include "pipeline/config/build/builder.h"
#include "pipeline/config/text.h"
#include "sim/shape/mass_properties.h"

namespace carom::pipeline::config {

namespace {

using sim::BodyKind;

/// The initial position of the centre of mass.
Vec3 centre_of(const ObjectSection& object) {
    return object.at + object.rotate.rotateVector(object.centre);
}

Mat44 scaling(const Vec3& scale) {
    Mat44 result;
    result.setScale(scale);
    return result;
}

/// The object's axes in world coordinates, without its translation.
Mat44 linear_map(const ObjectSection& object) {
    if (!object.axes) {
        return scaling(object.scale) * object.rotate.toMatrix44();
    }
    Mat44 map;
    for (int row = 0; row < 3; ++row) {
        for (int axis = 0; axis < 3; ++axis) {
            map[row][axis] = (*object.axes)[static_cast<std::size_t>(row)][axis];
        }
    }
    return map;
}

/// The simulation has at most one floor, which is infinite and level.
void add_floor(const Named<ObjectSection>& object, Builder& builder) {
    const Vec3 normal = object.value.rotate.rotateVector(Vec3(0, 0, 1));
    const bool is_level = normal.z > 1 - 1e-12;
    if (object.value.physics->kind != BodyKind::fixed || !is_level ||
        builder.shot.world.floor_height) {
        builder.reader.error(object.value.shape_place,
                             "a plane with physics is the simulation's floor: it must be fixed and "
                             "level, and there must be no other floor (a table has its own)");
        return;
    }
    builder.shot.world.floor_height = object.value.at.z;
}

/// Whether the key is given, with a valid or an invalid value.
bool has_physics_key(const std::string& object, const char* key, const Builder& builder) {
    const Place section = builder.place_of({"objects", object, "physics"});
    return builder.place_of({"objects", object, "physics", key}) != section;
}

void check_mass(const Named<ObjectSection>& object, Builder& builder) {
    const ObjectPhysics& physics = *object.value.physics;
    if (physics.kind == BodyKind::dynamic && !has_physics_key(object.name, "density", builder) &&
        !has_physics_key(object.name, "mass", builder)) {
        builder.reader.error(builder.place_of({"objects", object.name, "physics"}),
                             "object '" + object.name +
                                 "' moves, so its 'physics' needs either "
                                 "'density' or 'mass'");
    }
    if (physics.kind == BodyKind::fixed && (physics.velocity || physics.spin)) {
        builder.reader.error(builder.place_of({"objects", object.name, "physics"}),
                             "object '" + object.name + "' is fixed and cannot have a velocity");
    }
}

/// Sets the path of a kinematic body. The simulation positions a body by its centre of mass, but
/// the keys move the object's origin.
void follow_keys(const Named<ObjectSection>& object, const sim::Track& keys, sim::Body& body) {
    sim::KeyedPath path{std::make_shared<const sim::Track>(keys), object.value.centre};
    if (auto* hull = std::get_if<sim::ConvexHull>(&body.shape); hull && !object.value.solid) {
        path.centre = sim::mass_properties(*sim::convex_hull(hull->points)).centre;
        for (Vec3& point : hull->points) {
            point -= path.centre;
        }
    }
    const MotionState start = keys.sample(0);
    body.pose = {start.position + start.orientation.rotateVector(path.centre), start.orientation};
    body.path = std::move(path);
}

/// `keys` is the track of a kinematic body, else nullptr.
void add_body(const Named<ObjectSection>& object, const sim::Track* keys, Builder& builder) {
    const ObjectPhysics& physics = *object.value.physics;
    check_mass(object, builder);
    std::optional<sim::BodyShape> shape = body_shape(object, builder);
    if (!shape) {
        return;
    }
    sim::Body body;
    body.name = object.name;
    body.shape = std::move(*shape);
    body.kind = physics.kind.value_or(BodyKind::dynamic);
    body.mass =
        physics.mass.value_or(physics.density.value_or(1000) * volume(object.value).value_or(1));
    body.material = physics.material;
    body.pose = {centre_of(object.value), object.value.rotate};
    body.velocity = physics.velocity.value_or(Vec3(0, 0, 0));
    body.angular_velocity = physics.spin.value_or(Vec3(0, 0, 0));
    if (keys != nullptr) {
        follow_keys(object, *keys, body);
    }
    builder.shot.world.bodies.push_back(std::move(body));
}

/// The track moves the object's origin; a hull's shape is placed relative to it by its centre.
void add_keyed(const Named<ObjectSection>& object, Builder& builder) {
    const bool pushes = object.value.physics.has_value();
    (pushes ? builder.kinematic : builder.keyed).insert(object.name);
    if (object.value.motion->keys.size() < 2) {
        return;  // their problem was reported
    }
    try {
        builder.shot.keyed.push_back(
            keyed_track(object.name, *object.value.motion, {object.value.at, object.value.rotate}));
    } catch (const Error& failure) {
        builder.reader.error(builder.place_of({"objects", object.name, "motion"}), failure.what());
        return;
    }
    if (pushes) {
        add_body(object, &builder.shot.keyed.back(), builder);
    }
}

void add_to_scene(const Named<ObjectSection>& object, bool is_moving, Builder& builder) {
    render::ObjectDescription seen;
    seen.name = object.name;
    seen.shape = *object.value.shape;
    seen.material = object.value.material.value_or("plain");
    if (object.value.motion) {
        Mat44 centre;
        centre.setTranslation(object.value.centre);
        seen.world_from_object =
            centre * (object.value.axes ? linear_map(object.value) : scaling(object.value.scale));
        seen.track = object.name;
    } else if (is_moving) {
        seen.world_from_object = scaling(object.value.scale);
        seen.track = object.name;
    } else {
        const Mat44 linear = linear_map(object.value);
        Mat44 translation;
        translation.setTranslation(object.value.at + object.value.centre * linear);
        seen.world_from_object = linear * translation;
    }
    builder.shot.scene.objects.push_back(std::move(seen));
}

}  // namespace

void build_objects(Builder& builder) {
    for (const Named<ObjectSection>& object : builder.file.objects) {
        if (!builder.claim_name(object.name, object.place, "object") || !object.value.shape) {
            continue;
        }
        const bool has_physics = object.value.physics.has_value();
        const bool is_moving = has_physics && object.value.physics->kind == BodyKind::dynamic;
        if (object.value.motion) {
            add_keyed(object, builder);
        } else if (!has_physics) {
            builder.scenery[object.name] = object.value.at;
        } else if (std::holds_alternative<render::PlaneShape>(*object.value.shape)) {
            add_floor(object, builder);
            builder.scenery[object.name] = object.value.at;
        } else {
            add_body(object, nullptr, builder);
            (is_moving ? builder.bodies : builder.fixed).insert(object.name);
        }
        if (is_moving && std::holds_alternative<render::SphereShape>(*object.value.shape)) {
            builder.balls.insert(object.name);
        }
        add_to_scene(object, is_moving, builder);
    }
}

}  // namespace carom::pipeline::config
