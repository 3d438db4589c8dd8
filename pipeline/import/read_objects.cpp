// Reads the shapes of a scene text.
#include "pipeline/config/text.h"
#include "pipeline/import/scene_reader.h"

namespace carom::pipeline::scene_text {

namespace {

constexpr Limits kSize{0, 1e9, false, true};
constexpr Limits kSwitch{0, 1, true, false, true};
constexpr double kLongest = 3600;  // s

}  // namespace

void SceneReader::add_object(Object object, const std::optional<Name>& material, Real physics) {
    object.material = refer("material", material);
    object.uses_physics = physics.value_or(0) == 1;
    claim("object", object.name, model_.objects.size());
    model_.objects.push_back(std::move(object));
}

ForceEvent SceneReader::force_event(const std::string& owner, const Item& block) {
    std::optional<Vec3> force;
    Real time;
    Attributes(owner + " in add_force_event", problems_)
        .vector("force", force)
        .required()
        .real("time", time, {0, kLongest})
        .required()
        .read(block.group, block.place);
    return {force.value_or(Vec3(0, 0, 0)), time.value_or(0)};
}

void SceneReader::plane(const Name& name, const Item& block) {
    Object o;
    o.name = name;
    o.kind = ShapeKind::plane;
    std::optional<Name> material;
    attributes("plane", name)
        .vector("normal", o.normal)
        .required()
        .vector("position", o.position)
        .required()
        .word("material", material)
        .read(block.group, name.place);
    if (o.normal && o.normal->length() < 1e-9) {
        problems_.error(name.place, "'normal' of " + owner("plane", name) + " has no length");
    }
    add_object(std::move(o), material, {});
}

void SceneReader::sphere(const Name& name, const Item& block) {
    Object o;
    o.name = name;
    o.kind = ShapeKind::sphere;
    std::optional<Name> material;
    Real physics;
    attributes("sphere", name)
        .vector("position", o.position)
        .required()
        .real("radius", o.radius, kSize)
        .required()
        .word("material", material)
        .real("use_physics", physics, kSwitch)
        .vector("v_e", o.equator)
        .vector("v_n", o.pole)
        .blocks(
            "add_force_event",
            [&](const Item& item) { o.events.push_back(force_event(owner("sphere", name), item)); })
        .read(block.group, name.place);
    add_object(std::move(o), material, physics);
}

void SceneReader::triangle(const Name& name, const Item& block) {
    Object o;
    o.name = name;
    o.kind = ShapeKind::triangle;
    std::optional<Name> material;
    attributes("triangle", name)
        .vector("vertex0", o.vertices[0])
        .required()
        .vector("vertex1", o.vertices[1])
        .required()
        .vector("vertex2", o.vertices[2])
        .required()
        .word("material", material)
        .read(block.group, name.place);
    add_object(std::move(o), material, {});
}

void SceneReader::rectangle(const Name& name, const Item& block) {
    Object o;
    o.name = name;
    o.kind = ShapeKind::rectangle;
    std::optional<Name> material;
    attributes("rectangle", name)
        .vector("vertex0", o.vertices[0])
        .also("position0")
        .required()
        .vector("vertex1", o.vertices[1])
        .also("position1")
        .required()
        .vector("vertex2", o.vertices[2])
        .also("position2")
        .required()
        .word("material", material)
        .read(block.group, name.place);
    add_object(std::move(o), material, {});
}

void SceneReader::box(const Name& name, const Item& block) {
    Object o;
    o.name = name;
    o.kind = ShapeKind::box;
    std::optional<Name> material;
    Real physics;
    attributes("box", name)
        .vector("vertex0", o.vertices[0])
        .required()
        .vector("vertex1", o.vertices[1])
        .also("position1")
        .required()
        .vector("vertex2", o.vertices[2])
        .required()
        .real("height", o.height, kSize)
        .also("heigth")
        .required()
        .word("material", material)
        .real("use_physics", physics, kSwitch)
        .read(block.group, name.place);
    add_object(std::move(o), material, physics);
}

}  // namespace carom::pipeline::scene_text
