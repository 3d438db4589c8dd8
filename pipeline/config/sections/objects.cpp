#include <algorithm>
#include <cmath>
#include <numbers>

#include "pipeline/config/sections/object_shapes.h"
#include "pipeline/config/sections/repeat.h"
#include "pipeline/config/sections/sections.h"
#include "sim/limits.h"

namespace carom::pipeline::config {

namespace {

using sim::BodyKind;

const MapSpec<ObjectPhysics>& object_physics_spec() {
    static const MapSpec<ObjectPhysics> spec = [] {
        MapSpec<ObjectPhysics> s("object physics", "How an object takes part in the simulation.");
        s.key("kind", &ObjectPhysics::kind,
              choice<BodyKind>({{"dynamic", BodyKind::dynamic},
                                {"fixed", BodyKind::fixed},
                                {"kinematic", BodyKind::kinematic}}),
              "`dynamic`: the simulation moves the object; `fixed`: others collide with it, but it "
              "never moves; `kinematic`: the keys of its `motion` move it, and it pushes others "
              "but is not pushed. The default is `kinematic` for an object with a `motion` and "
              "`dynamic` for others");
        s.key("density", &ObjectPhysics::density,
              quantity(Dimension::density, above_up_to(0, 100'000)),
              "density, from which the mass is computed with the volume");
        s.key("mass", &ObjectPhysics::mass, quantity(Dimension::mass, above_up_to(0, 100'000)),
              "mass, instead of the density");
        s.key("material", &ObjectPhysics::material, text("a physical material"),
              "physical material for the contact law (see `physics.pairs`)");
        s.key("velocity", &ObjectPhysics::velocity,
              vector3(Dimension::speed, between(-sim::kMaxSpeed, sim::kMaxSpeed)),
              "velocity at the start");
        s.key("spin", &ObjectPhysics::spin,
              vector3(Dimension::angular_speed, between(-sim::kMaxSpin, sim::kMaxSpin)),
              "angular velocity at the start, world axes");
        s.at_most_one_of({"density", "mass"});
        return s;
    }();
    return spec;
}

using PhysicsWord = std::pair<std::string, std::optional<BodyKind>>;

const std::vector<PhysicsWord>& physics_words() {
    static const std::vector<PhysicsWord> words{
        {"false", std::nullopt}, {"fixed", BodyKind::fixed}, {"true", BodyKind::kinematic}};
    return words;
}

/// Whether an object with this `physics` takes part in the simulation. Then only rotations are
/// allowed, because the simulation has no scaled shapes except meshes.
bool takes_part(const Node& physics) {
    const auto is_meant = [&](const PhysicsWord& word) {
        return physics.is_scalar() && physics.text == word.first && word.second.has_value();
    };
    return physics.is_map() ||
           std::any_of(physics_words().begin(), physics_words().end(), is_meant);
}

/// `false`, `fixed`, `true` or a map.
ValueType<std::optional<ObjectPhysics>> object_physics() {
    using Result = std::optional<ObjectPhysics>;
    const auto word = convert<Result>(choice<std::optional<BodyKind>>(physics_words()),
                                      [](std::optional<BodyKind> kind) -> Result {
                                          if (!kind) {
                                              return std::nullopt;
                                          }
                                          ObjectPhysics physics;
                                          physics.kind = *kind;
                                          return physics;
                                      });
    const auto map = convert<Result>(record(object_physics_spec()),
                                     [](ObjectPhysics physics) -> Result { return physics; });
    return any_of<Result>({{is_scalar, word}, {is_map, map}});
}

void check_axes(Reader& reader, const Node& node, ObjectSection& object) {
    if (object.axes) {
        const std::vector<Vec3>& a = *object.axes;
        const double volume = std::abs(a[0].cross(a[1]).dot(a[2]));
        if (!(volume > 1e-9 * a[0].length() * a[1].length() * a[2].length())) {
            reader.error(node.find("axes")->key_place,
                         "the axes of " + reader.label() + " lie in one plane");
            object.axes.reset();
        }
    }
}

/// An object that keys move may have `physics: true` or a map without another kind.
void check_motion(Reader& reader, const Node& node, ObjectSection& object) {
    const Entry* physics = node.find("physics");
    const bool is_keyed = node.find("motion") != nullptr;
    if (!object.physics || physics == nullptr) {
        return;
    }
    if (!object.physics->kind) {
        object.physics->kind = is_keyed ? BodyKind::kinematic : BodyKind::dynamic;
    }
    const bool is_kinematic = object.physics->kind == BodyKind::kinematic;
    if (is_keyed && !is_kinematic) {
        reader.error(physics->key_place,
                     "'motion' moves " + reader.label() +
                         ", so its 'physics' must be 'true' (it pushes others) or "
                         "'false'");
    } else if (is_kinematic && !is_keyed) {
        reader.error(physics->key_place,
                     "'physics: true' needs a 'motion', which " + reader.label() +
                         " does not have; if the simulation moves the object, give a map with "
                         "'density' or 'mass'");
    }
    for (const char* key : {"density", "mass", "velocity", "spin"}) {
        const Entry* entry = is_keyed && is_kinematic ? physics->value.find(key) : nullptr;
        if (entry != nullptr) {
            reader.error(entry->key_place, "'" + std::string(key) +
                                               "' is only for objects that the simulation moves; "
                                               "the keys of 'motion' move " +
                                               reader.label());
        }
    }
    if (is_keyed != is_kinematic) {
        object.physics.reset();
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
                 "'smooth' is only for a mesh from a file, which " + reader.label() + " is not");
}

void check_shape(Reader& reader, const Node& node, ObjectSection& object) {
    for (const std::string& key : shape_keys()) {
        if (const Entry* entry = node.find(key)) {
            object.shape_place = entry->key_place;
        }
    }
    if (object.shape && object.is_degenerate) {
        const bool is_triangle = node.find("triangle") != nullptr;
        reader.error(object.shape_place,
                     std::string(is_triangle ? "the corners" : "the three points") + " of " +
                         reader.label() + " lie on a line");
        object.shape.reset();
    }
    if (node.find("hull") != nullptr && object.shape && !object.solid) {
        reader.error(object.shape_place, "the points of " + reader.label() +
                                             " lie in one plane; a hull needs four that do not");
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
                                 "An object that is not a ball. It is visible, and others collide "
                                 "with it if it has `physics`.");
        add_shapes(s);
        // This key is removed before the sections are read (repeat.h); it is here for the
        // reference.
        s.set(
            "repeat", record(repeat_spec()), [](ObjectSection&, const auto&) {},
            "the object stands for many, along a curve or in a grid");
        s.key("at", &ObjectSection::at, vector3(Dimension::length),
              "position of the object's origin in world coordinates");
        s.key("rotate", &ObjectSection::rotate, rotation(),
              "angles about the world's x, y and z axis in this order, or {axis, angle}");
        s.key("scale", &ObjectSection::scale, scale(),
              "factors by which the object's own axes are scaled before it is rotated")
            .excluded_by({"physics", takes_part, "mesh",
                          "cannot be used with 'physics' except for a mesh; give the shape of {} "
                          "its final size "
                          "instead"});
        s.key("axes", &ObjectSection::axes, list_of(vector3(Dimension::none), 3, 3),
              "instead of `rotate` and `scale`: the vectors to which the x, y and z axes are "
              "mapped, of any length and at any angles")
            .excluded_by({"physics", takes_part, "",
                          "cannot be used with 'physics'; rotate {} with 'rotate' instead"});
        s.key("smooth", &ObjectSection::smooth, angle(between(0, std::numbers::pi)),
              "edges of a mesh look round if the angle between their triangles is at most this");
        s.key("material", &ObjectSection::material, name_of(ReferenceKind::material),
              "material of the surface. The default is a plain grey");
        s.set(
            "physics", object_physics(),
            [](ObjectSection& object, const std::optional<ObjectPhysics>& value) {
                object.physics = value;
            },
            "`false`: the object is only visible; `fixed`: others collide with it; `true`: "
            "`motion` moves it and it pushes others; or a map",
            "false");
        s.set(
            "motion", record(motion_spec()),
            [](ObjectSection& object, const KeyedMotion& motion) { object.motion = motion; },
            "the object moves from key to key, beginning at `at` and `rotate`. It is only visible, "
            "or with `physics: true` pushes the bodies that it touches");
        s.at_most_one_of({"rotate", "axes"});
        s.at_most_one_of({"scale", "axes"});
        s.check(check_shape);
        s.check(check_axes);
        s.check(check_motion);
        s.check(check_smooth);
        return s;
    }();
    return spec;
}

}  // namespace carom::pipeline::config
