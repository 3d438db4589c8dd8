#include <utility>
#include <variant>

#include "pipeline/config/build/builder.h"
#include "pipeline/config/text.h"
#include "pipeline/shot/solid_mesh.h"
#include "render/geometry/mesh_file.h"
#include "sim/shape/mass_properties.h"
#include "sim/timeline/error.h"

namespace carom::pipeline::config {

namespace {

using sim::BodyKind;

constexpr double kPi = 3.14159265358979323846;

std::string shape_name(const render::Shape& shape) {
    constexpr const char* kNames[] = {"sphere",   "box",           "plane", "rectangle", "mesh",
                                      "triangle", "parallelogram", "disk",  "cylinder",  "cone"};
    return kNames[shape.index()];
}

/// Where the centre of mass is at the start.
Vec3 centre_of(const ObjectSection& object) {
    return object.at + object.rotate.rotateVector(object.centre);
}

Mat44 scaling(const Vec3& scale) {
    Mat44 result;
    result.setScale(scale);
    return result;
}

/// The object's axes in the world's, without its place.
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

/// What collides with shapes that only stand and have no solid of their own; empty for others.
std::optional<sim::TriangleMesh> still_mesh(const render::Shape& shape) {
    if (const auto* rectangle = std::get_if<render::RectangleShape>(&shape)) {
        const double x = rectangle->size.x / 2;
        const double y = rectangle->size.y / 2;
        return sim::TriangleMesh{{{-x, -y, 0}, {x, -y, 0}, {x, y, 0}, {-x, y, 0}},
                                 {{0, 1, 2}, {0, 2, 3}}};
    }
    if (const auto* triangle = std::get_if<render::TriangleShape>(&shape)) {
        return sim::TriangleMesh{{triangle->corners.begin(), triangle->corners.end()}, {{0, 1, 2}}};
    }
    if (const auto* sides = std::get_if<render::ParallelogramShape>(&shape)) {
        const Vec3& a = sides->corner;
        const Vec3& u = sides->edge_u;
        const Vec3& v = sides->edge_v;
        return sim::TriangleMesh{{a, a + u, a + u + v, a + v}, {{0, 1, 2}, {0, 2, 3}}};
    }
    if (const auto* disk = std::get_if<render::DiskShape>(&shape)) {
        return disk_mesh(disk->radius);
    }
    if (const auto* cone = std::get_if<render::ConeShape>(&shape)) {
        return cone_mesh(*cone);
    }
    return std::nullopt;
}

sim::TriangleMesh scaled_mesh(const std::string& file, const Vec3& scale) {
    const render::MeshShape mesh = render::read_mesh(file);
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
    if (auto still = still_mesh(shape)) {
        return std::move(*still);
    }
    const auto& mesh = std::get<render::MeshShape>(shape);
    try {
        return scaled_mesh(mesh.file, object.value.scale);
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

/// The track leads the object's origin; a hull's shape is placed in it by its centre.
void add_keyed(const Named<ObjectSection>& object, Builder& builder) {
    builder.keyed.insert(object.name);
    if (object.value.motion->keys.size() < 2) {
        return;  // what is wrong with them was said
    }
    try {
        builder.shot.keyed.push_back(
            keyed_track(object.name, *object.value.motion, {object.value.at, object.value.rotate}));
    } catch (const Error& failure) {
        builder.reader.error(builder.place_of({"objects", object.name, "motion"}), failure.what());
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
        if (!builder.claim(object.name, object.place, "object") || !object.value.shape) {
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
