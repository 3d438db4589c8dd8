#include <utility>
#include <variant>

#include "pipeline/config/build/builder.h"
#include "pipeline/config/text.h"
#include "render/geometry/obj_file.h"
#include "sim/shape/mass_properties.h"
#include "sim/timeline/error.h"

namespace carom::pipeline::config {

namespace {

using sim::BodyKind;

constexpr double kPi = 3.14159265358979323846;

std::string shape_name(const render::Shape& shape) {
    constexpr const char* kNames[] = {"sphere", "box", "plane", "rectangle", "mesh"};
    return kNames[shape.index()];
}

/// Where the centre of mass is at the start.
Vec3 centre_of(const ObjectSection& object) {
    return object.at + object.rotate.rotateVector(object.centre);
}

/// Volume of the shapes that can move.
std::optional<double> volume(const ObjectSection& object) {
    const render::Shape& shape = *object.shape;
    if (object.solid) {
        if (const auto* capsule = std::get_if<sim::Capsule>(&*object.solid)) {
            return sim::capsule_volume(capsule->radius, capsule->length);
        }
        if (const auto* cylinder = std::get_if<sim::Cylinder>(&*object.solid)) {
            return sim::cylinder_volume(cylinder->radius, cylinder->height);
        }
        const auto hull = sim::convex_hull(std::get<sim::ConvexHull>(*object.solid).points);
        return hull ? std::optional(sim::mass_properties(*hull).volume) : std::nullopt;
    }
    if (const auto* sphere = std::get_if<render::SphereShape>(&shape)) {
        return 4.0 / 3.0 * kPi * sphere->radius * sphere->radius * sphere->radius;
    }
    if (const auto* box = std::get_if<render::BoxShape>(&shape)) {
        return box->size.x * box->size.y * box->size.z;
    }
    return std::nullopt;
}

sim::TriangleMesh rectangle_mesh(const Vec2& size) {
    const double x = size.x / 2;
    const double y = size.y / 2;
    return {{{-x, -y, 0}, {x, -y, 0}, {x, y, 0}, {-x, y, 0}}, {{0, 1, 2}, {0, 2, 3}}};
}

sim::TriangleMesh read_mesh(const std::string& file, double scale) {
    const render::MeshShape mesh = render::read_obj(file);
    sim::TriangleMesh result;
    for (const Vec3& vertex : mesh.vertices) {
        result.vertices.push_back(vertex * scale);
    }
    result.triangles = mesh.triangles;
    return result;
}

/// The shape that others collide with; empty after a problem.
std::optional<sim::BodyShape> body_shape(const Named<ObjectSection>& object, Builder& builder) {
    const render::Shape& shape = *object.value.shape;
    if (object.value.solid) {
        return object.value.solid;
    }
    if (const auto* sphere = std::get_if<render::SphereShape>(&shape)) {
        return sim::Sphere{sphere->radius};
    }
    if (const auto* box = std::get_if<render::BoxShape>(&shape)) {
        return sim::Box{box->size};
    }
    if (object.value.physics->kind == BodyKind::dynamic) {
        builder.reader.error(object.value.shape_place,
                             "a " + shape_name(shape) + " cannot move: object '" + object.name +
                                 "' needs 'physics: fixed' or 'physics: false'");
        return std::nullopt;
    }
    if (const auto* rectangle = std::get_if<render::RectangleShape>(&shape)) {
        return rectangle_mesh(rectangle->size);
    }
    const auto& mesh = std::get<render::MeshShape>(shape);
    try {
        return read_mesh(mesh.file, object.value.scale);
    } catch (const Error& failure) {
        builder.reader.error(object.value.shape_place, failure.what());
        return std::nullopt;
    }
}

/// The infinite floor of the simulation is level, and there is one.
void add_floor(const Named<ObjectSection>& object, Builder& builder) {
    const Vec3 normal = object.value.rotate.rotateVector(Vec3(0, 0, 1));
    const bool is_level = normal.z > 1 - 1e-12;
    if (object.value.physics->kind != BodyKind::fixed || !is_level ||
        builder.shot.world.floor_height) {
        builder.reader.error(object.value.shape_place,
                             "a plane takes part in the simulation only as its one floor: fixed, "
                             "level and without a table's own");
        return;
    }
    builder.shot.world.floor_height = object.value.at.z;
}

void check_mass(const Named<ObjectSection>& object, Builder& builder) {
    const ObjectPhysics& physics = *object.value.physics;
    if (physics.kind == BodyKind::dynamic && !physics.density && !physics.mass) {
        builder.reader.error(builder.place_of({"objects", object.name, "physics"}),
                             "object '" + object.name +
                                 "' moves, so its 'physics' needs either "
                                 "'density' or 'mass'");
    }
    if (physics.kind == BodyKind::fixed && (physics.velocity || physics.spin)) {
        builder.reader.error(builder.place_of({"objects", object.name, "physics"}),
                             "object '" + object.name + "' is fixed and can have no velocity");
    }
}

void add_body(const Named<ObjectSection>& object, Builder& builder) {
    const ObjectPhysics& physics = *object.value.physics;
    check_mass(object, builder);
    std::optional<sim::BodyShape> shape = body_shape(object, builder);
    if (!shape) {
        return;
    }
    sim::Body body;
    body.name = object.name;
    body.shape = std::move(*shape);
    body.kind = physics.kind;
    body.mass =
        physics.mass.value_or(physics.density.value_or(1000) * volume(object.value).value_or(1));
    body.material = physics.material;
    body.pose = {centre_of(object.value), object.value.rotate};
    body.velocity = physics.velocity.value_or(Vec3(0, 0, 0));
    body.angular_velocity = physics.spin.value_or(Vec3(0, 0, 0));
    builder.shot.world.bodies.push_back(std::move(body));
}

void add_to_scene(const Named<ObjectSection>& object, bool is_moving, Builder& builder) {
    render::ObjectDescription seen;
    seen.name = object.name;
    seen.shape = *object.value.shape;
    seen.material = object.value.material.value_or("plain");
    const double s = object.value.scale;
    seen.world_from_object.setScale(Vec3(s, s, s));
    if (is_moving) {
        seen.track = object.name;
    } else {
        Mat44 translation;
        translation.setTranslation(centre_of(object.value));
        seen.world_from_object =
            seen.world_from_object * object.value.rotate.toMatrix44() * translation;
    }
    builder.shot.scene.objects.push_back(std::move(seen));
}

}  // namespace

void build_objects(Builder& builder) {
    for (const Named<ObjectSection>& object : builder.file.objects) {
        if (!builder.claim(object.name, object.place, "object") || !object.value.shape) {
            continue;
        }
        const bool has_physics = object.value.physics.has_value();
        const bool is_moving = has_physics && object.value.physics->kind == BodyKind::dynamic;
        if (!has_physics) {
            builder.scenery[object.name] = object.value.at;
        } else if (std::holds_alternative<render::PlaneShape>(*object.value.shape)) {
            add_floor(object, builder);
            builder.scenery[object.name] = object.value.at;
        } else {
            add_body(object, builder);
            (is_moving ? builder.bodies : builder.fixed).insert(object.name);
        }
        if (is_moving && std::holds_alternative<render::SphereShape>(*object.value.shape)) {
            builder.balls.insert(object.name);
        }
        add_to_scene(object, is_moving, builder);
    }
}

}  // namespace carom::pipeline::config
