#include <cmath>

#include "pipeline/config/sections/sections.h"
#include "pipeline/shot/solid_mesh.h"
#include "sim/shape/mass_properties.h"

namespace carom::pipeline::config {

namespace {

using sim::BodyKind;

const MapSpec<ObjectPhysics>& object_physics_spec() {
    static const MapSpec<ObjectPhysics> spec = [] {
        MapSpec<ObjectPhysics> s("object physics", "An object's part in the simulation.");
        s.key("kind", &ObjectPhysics::kind,
              choice<BodyKind>({{"dynamic", BodyKind::dynamic}, {"fixed", BodyKind::fixed}}),
              "`fixed`: others collide with it, it never moves");
        s.key("density", &ObjectPhysics::density,
              quantity(Dimension::density, above_up_to(0, 100'000)),
              "gives the mass by the volume");
        s.key("mass", &ObjectPhysics::mass, quantity(Dimension::mass, above_up_to(0, 100'000)),
              "instead of the density");
        s.key("material", &ObjectPhysics::material, text("a physical material"),
              "for the contact law (see `physics.pairs`)");
        s.key("velocity", &ObjectPhysics::velocity, vector3(Dimension::speed), "at the start");
        s.key("spin", &ObjectPhysics::spin, vector3(Dimension::angular_speed),
              "angular velocity at the start, world axes");
        s.at_most_one_of({"density", "mass"});
        return s;
    }();
    return spec;
}

/// `false`, `fixed` or a map.
ValueType<std::optional<ObjectPhysics>> object_physics() {
    using Result = std::optional<ObjectPhysics>;
    const auto word = convert<Result>(choice<bool>({{"false", false}, {"fixed", true}}),
                                      [](bool is_fixed) -> Result {
                                          if (!is_fixed) {
                                              return std::nullopt;
                                          }
                                          ObjectPhysics physics;
                                          physics.kind = BodyKind::fixed;
                                          return physics;
                                      });
    const auto map = convert<Result>(record(object_physics_spec()),
                                     [](ObjectPhysics physics) -> Result { return physics; });
    return any_of<Result>({{is_scalar, word}, {is_map, map}});
}

const std::vector<std::string>& shape_keys() {
    static const std::vector<std::string> keys{"box",  "sphere",   "rectangle",     "plane",
                                               "mesh", "triangle", "parallelogram", "disk",
                                               "cone", "capsule",  "cylinder",      "hull"};
    return keys;
}

template <class V, class Make>
void add_shape(MapSpec<ObjectSection>& spec, std::string name, ValueType<V> type, Make make,
               std::string description) {
    spec.set(
        std::move(name), std::move(type),
        [make](ObjectSection& object, const V& value) { object.shape = make(value); },
        std::move(description));
}

const MapSpec<sim::Capsule>& capsule_spec() {
    static const MapSpec<sim::Capsule> spec = [] {
        MapSpec<sim::Capsule> s("capsule", "A cylinder about z with a half ball on each end.");
        s.key("radius", &sim::Capsule::radius, length(above_up_to(0, 1000)), "of all of it")
            .required();
        s.key("length", &sim::Capsule::length, length(above_up_to(0, 1000)),
              "between the centres of its ends")
            .required();
        return s;
    }();
    return spec;
}

const MapSpec<sim::Cylinder>& cylinder_spec() {
    static const MapSpec<sim::Cylinder> spec = [] {
        MapSpec<sim::Cylinder> s("cylinder", "A cylinder about z.");
        s.key("radius", &sim::Cylinder::radius, length(above_up_to(0, 1000)), "of its caps")
            .required();
        s.key("height", &sim::Cylinder::height, length(above_up_to(0, 1000)), "from cap to cap")
            .required();
        return s;
    }();
    return spec;
}

/// The hull about its centre of mass: what `at` places is the origin of the points.
void set_hull(ObjectSection& object, const std::vector<Vec3>& points) {
    const std::optional<sim::Polyhedron> hull = sim::convex_hull(points);
    if (!hull) {
        object.shape = render::MeshShape{};
        return;
    }
    object.centre = sim::mass_properties(*hull).centre;
    sim::Polyhedron about_centre = *hull;
    for (Vec3& vertex : about_centre.vertices) {
        vertex -= object.centre;
    }
    object.shape = hull_mesh(about_centre);
    object.solid = sim::ConvexHull{about_centre.vertices};
}

void add_solids(MapSpec<ObjectSection>& s) {
    s.set(
        "capsule", record(capsule_spec()),
        [](ObjectSection& object, const sim::Capsule& capsule) {
            object.shape = capsule_mesh(capsule);
            object.solid = capsule;
        },
        "a cylinder with round ends, its axis along z");
    s.set(
        "cylinder", record(cylinder_spec()),
        [](ObjectSection& object, const sim::Cylinder& cylinder) {
            object.shape = render::CylinderShape{cylinder.radius, cylinder.height};
            object.solid = cylinder;
        },
        "its axis along z");
    s.set("hull", list_of(vector3(Dimension::length, between(-1000, 1000)), 4, 1000), set_hull,
          "the convex hull of points, four or more that are not in a plane");
}

const MapSpec<render::ConeShape>& cone_spec() {
    static const MapSpec<render::ConeShape> spec = [] {
        using Cone = render::ConeShape;
        MapSpec<Cone> s("cone", "A cone about z, its tip up, or cut off below the tip.");
        s.key("radius", &Cone::radius, length(above_up_to(0, 1000)), "at the bottom").required();
        s.key("top_radius", &Cone::top_radius, length(between(0, 1000)), "0: a tip");
        s.key("height", &Cone::height, length(above_up_to(0, 1000)), "from bottom to top")
            .required();
        return s;
    }();
    return spec;
}

/// Whether two edges span an area; otherwise the shape is left out and said to be flat in
/// note_shape_place.
bool spans_area(const Vec3& u, const Vec3& v) {
    return u.cross(v).length() > 1e-9 * u.length() * v.length();
}

void add_flat_shapes(MapSpec<ObjectSection>& s) {
    const auto corners = list_of(vector3(Dimension::length, between(-1e6, 1e6)), 3, 3);
    s.set(
        "triangle", corners,
        [](ObjectSection& object, const std::vector<Vec3>& p) {
            object.shape = render::TriangleShape{{p[0], p[1], p[2]}};
            object.is_degenerate = !spans_area(p[1] - p[0], p[2] - p[0]);
        },
        "its three corners, counter-clockwise seen from its front");
    s.set(
        "parallelogram", corners,
        [](ObjectSection& object, const std::vector<Vec3>& p) {
            object.shape = render::ParallelogramShape{p[0], p[1] - p[0], p[2] - p[0]};
            object.is_degenerate = !spans_area(p[1] - p[0], p[2] - p[0]);
        },
        "a corner and its two neighbours; u runs to the first, v to the second");
    add_shape(
        s, "disk", length(above_up_to(0, 1000)),
        [](double radius) { return render::DiskShape{radius}; }, "radius; it faces +z");
}

void add_shapes(MapSpec<ObjectSection>& s) {
    add_shape(
        s, "box", vector3(Dimension::length, above_up_to(0, 1000)),
        [](const Vec3& size) { return render::BoxShape{size}; },
        "full lengths of its edges along x, y and z");
    add_shape(
        s, "sphere", length(above_up_to(0, 1000)),
        [](double radius) { return render::SphereShape{radius}; }, "radius");
    add_shape(
        s, "rectangle", vector2(Dimension::length, above_up_to(0, 1000)),
        [](const Vec2& size) { return render::RectangleShape{size}; },
        "lengths along x and y; it faces +z");
    add_shape(
        s, "plane", choice<bool>({{"infinite", true}}), [](bool) { return render::PlaneShape{}; },
        "the infinite plane that faces +z");
    add_shape(
        s, "mesh", file(),
        [](const std::string& path) {
            render::MeshShape mesh;
            mesh.file = path;
            return mesh;
        },
        "an OBJ or PLY file");
    add_flat_shapes(s);
    add_shape(
        s, "cone", record(cone_spec()), [](const render::ConeShape& cone) { return cone; },
        "its axis along z");
    add_solids(s);
    s.exactly_one_of(shape_keys());
}

/// Only turns leave a shape what the simulation takes it for; a mesh is collided with as scaled.
void check_transform(Reader& reader, const Node& node, ObjectSection& object) {
    if (object.axes) {
        const std::vector<Vec3>& a = *object.axes;
        const double volume = std::abs(a[0].cross(a[1]).dot(a[2]));
        if (!(volume > 1e-9 * a[0].length() * a[1].length() * a[2].length())) {
            reader.error(node.find("axes")->key_place,
                         "the axes of " + reader.label() + " lie in a plane");
            object.axes.reset();
        }
    }
    if (!object.physics) {
        return;
    }
    for (const char* key : {"axes", "scale"}) {
        const Entry* entry = node.find(key);
        const bool is_mesh = node.find("mesh") != nullptr && std::string(key) == "scale";
        if (entry != nullptr && !is_mesh) {
            const bool is_axes = std::string(key) == "axes";
            const std::string what = std::string("'") + key + "' is for what has no physics; ";
            reader.error(entry->key_place,
                         what + (is_axes ? "turn " + reader.label() + " by 'rotate' instead"
                                         : "give " + reader.label() + " its size instead"));
        }
    }
}

void check_motion(Reader& reader, const Node& node, ObjectSection& object) {
    if (object.motion && object.physics) {
        reader.error(node.find("motion")->key_place,
                     "'motion' is for what has no physics: " + reader.label() +
                         " cannot be moved by keys and take part in the simulation");
        object.motion.reset();
    }
}

void check_smooth(Reader& reader, const Node& node, ObjectSection& object) {
    if (!object.smooth || !object.shape) {
        return;
    }
    if (auto* mesh = std::get_if<render::MeshShape>(&*object.shape);
        mesh != nullptr && !mesh->file.empty()) {
        mesh->smooth_angle = *object.smooth;
        return;
    }
    reader.error(node.find("smooth")->key_place,
                 "'smooth' is for a mesh from a file, which " + reader.label() + " is not");
}

void note_shape_place(Reader& reader, const Node& node, ObjectSection& object) {
    for (const std::string& key : shape_keys()) {
        if (const Entry* entry = node.find(key)) {
            object.shape_place = entry->key_place;
        }
    }
    if (object.shape && object.is_degenerate) {
        const bool is_triangle = node.find("triangle") != nullptr;
        reader.error(object.shape_place,
                     std::string(is_triangle ? "the corners" : "the three points") + " of " +
                         reader.label() + " lie in a line");
        object.shape.reset();
    }
    if (node.find("hull") != nullptr && object.shape && !object.solid) {
        reader.error(object.shape_place, "the points of " + reader.label() +
                                             " lie in a plane: a hull needs four that do not");
        object.shape.reset();
    }
}

ValueType<Vec3> scale() {
    const Range range = above_up_to(0, 1e6);
    const auto even = convert<Vec3>(number(range), [](double s) { return Vec3(s, s, s); });
    auto type = any_of<Vec3>({{is_scalar, even}, {is_list, vector3(Dimension::none, range)}});
    type.show = [](const Vec3&) { return std::string("1"); };
    return type;
}

}  // namespace

const MapSpec<ObjectSection>& object_spec() {
    static const MapSpec<ObjectSection> spec = [] {
        MapSpec<ObjectSection> s("object",
                                 "Something else to see, and to collide with if it has "
                                 "physics.");
        add_shapes(s);
        s.key("at", &ObjectSection::at, vector3(Dimension::length), "its origin in world axes");
        s.key("rotate", &ObjectSection::rotate, rotation(),
              "angles about the world's x, y and z axis in this order, or {axis, angle}");
        s.key("scale", &ObjectSection::scale, scale(),
              "by which its own axes are stretched before it is turned");
        s.key("axes", &ObjectSection::axes, list_of(vector3(Dimension::none), 3, 3),
              "instead of `rotate` and `scale`: where its x, y and z axes go, of any length and at "
              "any angles");
        s.key("smooth", &ObjectSection::smooth, angle(between(0, 3.141592653589793)),
              "of a mesh: edges up to this angle between triangles look round");
        s.key("material", &ObjectSection::material, name_of(ReferenceKind::material),
              "of the look; without it a plain grey");
        s.set(
            "physics", object_physics(),
            [](ObjectSection& object, const std::optional<ObjectPhysics>& value) {
                object.physics = value;
            },
            "`false`: seen only; `fixed`: others collide with it; or a map", "false");
        s.set(
            "motion", record(motion_spec()),
            [](ObjectSection& object, const KeyedMotion& motion) { object.motion = motion; },
            "it goes from key to key, beginning from `at` and `rotate`; seen only");
        s.at_most_one_of({"rotate", "axes"});
        s.at_most_one_of({"scale", "axes"});
        s.check(note_shape_place);
        s.check(check_transform);
        s.check(check_motion);
        s.check(check_smooth);
        return s;
    }();
    return spec;
}

}  // namespace carom::pipeline::config
