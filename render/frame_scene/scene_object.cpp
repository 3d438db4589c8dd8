#include "render/frame_scene/scene_object.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.h"
#include "render/frame_scene/mesh_library.h"
#include "render/light/area_light.h"

namespace carom::render {
namespace {

constexpr double kRoundness = 1e-6;  // relative difference between a sphere's scales

[[noreturn]] void refuse(const std::string& name, const std::string& what) {
    throw Error("object '" + name + "': " + what);
}

void check_size(double size, const std::string& name, const char* what) {
    if (!(size > 0 && std::isfinite(size))) {
        refuse(name, std::string(what) + " must be greater than 0");
    }
}

Mat44 scaling(const Vec3& scale) {
    Mat44 m;
    m.setScale(scale);
    return m;
}

Mat44 checked_transform(const ObjectDescription& description) {
    const Mat44& m = description.world_from_object;
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            if (!std::isfinite(m[row][column])) {
                refuse(description.name, "its transform has a value that is not finite");
            }
        }
    }
    const Vec3 scale = axis_scales(m);
    const double volume = std::abs(m.determinant());
    if (!(volume > 1e-12 * scale.x * scale.y * scale.z) || m[0][3] != 0 || m[1][3] != 0 ||
        m[2][3] != 0 || m[3][3] != 1) {
        refuse(description.name, "its transform is not affine or cannot be inverted");
    }
    return m;
}

/// An object's unit shape (shape_list.h), and its map to the object's own axes.
struct UnitOfObject {
    ShapeKind kind;
    Mat44 object_from_unit{};
    V3f parameters{0, 0, 0};
};

struct MakeUnit {
    const std::string& name;

    UnitOfObject operator()(const SphereShape& shape) const {
        check_size(shape.radius, name, "the radius");
        return {ShapeKind::sphere, scaling(Vec3(shape.radius))};
    }
    UnitOfObject operator()(const BoxShape& shape) const {
        for (int axis = 0; axis < 3; ++axis) {
            check_size(shape.size[axis], name, "a box's edge");
        }
        return {ShapeKind::box, scaling(0.5 * shape.size)};
    }
    UnitOfObject operator()(const PlaneShape&) const { return {ShapeKind::plane}; }
    UnitOfObject operator()(const RectangleShape& shape) const {
        check_size(shape.size.x, name, "a rectangle's edge");
        check_size(shape.size.y, name, "a rectangle's edge");
        return {ShapeKind::rectangle, scaling(Vec3(0.5 * shape.size.x, 0.5 * shape.size.y, 1))};
    }
    UnitOfObject operator()(const MeshShape&) const { return {ShapeKind::mesh}; }
    UnitOfObject operator()(const TriangleShape& shape) const {
        const auto& [a, b, c] = shape.corners;
        return {ShapeKind::triangle, flat(b - a, c - a, a, "a triangle's corners lie in a line")};
    }
    UnitOfObject operator()(const ParallelogramShape& shape) const {
        const Vec3 half_u = 0.5 * shape.edge_u;
        const Vec3 half_v = 0.5 * shape.edge_v;
        return {ShapeKind::rectangle, flat(half_u, half_v, shape.corner + half_u + half_v,
                                           "the edges of a parallelogram are parallel")};
    }
    UnitOfObject operator()(const DiskShape& shape) const {
        check_size(shape.radius, name, "the radius");
        return {ShapeKind::disk, scaling(Vec3(shape.radius, shape.radius, 1))};
    }
    UnitOfObject operator()(const CylinderShape& shape) const {
        check_size(shape.radius, name, "the radius");
        check_size(shape.height, name, "the height");
        return {ShapeKind::frustum, scaling(Vec3(shape.radius, shape.radius, 0.5 * shape.height)),
                V3f(1, 0, 0)};
    }
    UnitOfObject operator()(const ConeShape& shape) const {
        const double larger = std::max(shape.radius, shape.top_radius);
        check_size(larger, name, "the larger radius of a cone");
        check_size(shape.height, name, "the height");
        if (!(std::min(shape.radius, shape.top_radius) >= 0)) {
            refuse(name, "the radii of a cone must not be negative");
        }
        const Vec3 middle_and_slope(0.5 * (shape.top_radius + shape.radius) / larger,
                                    0.5 * (shape.top_radius - shape.radius) / larger, 0);
        return {ShapeKind::frustum, scaling(Vec3(larger, larger, 0.5 * shape.height)),
                V3f(middle_and_slope)};
    }

    UnitOfObject operator()(const CapsuleShape& shape) const {
        check_size(shape.radius, name, "the radius");
        check_size(shape.length, name, "the length");
        return {ShapeKind::capsule, scaling(Vec3(shape.radius)),
                V3f(static_cast<float>(0.5 * shape.length / shape.radius), 0, 0)};
    }

    UnitOfObject operator()(const RoundedBoxShape& shape) const {
        check_size(shape.radius, name, "the radius");
        for (int axis = 0; axis < 3; ++axis) {
            check_size(shape.size[axis], name, "a rounded box's edge");
            if (!(2 * shape.radius <= shape.size[axis])) {
                refuse(name, "the radius of a rounded box is more than half of its smallest side");
            }
        }
        return {ShapeKind::rounded_box, scaling(Vec3(shape.radius)),
                V3f(shape.core() / shape.radius)};
    }

  private:
    Mat44 flat(const Vec3& x, const Vec3& y, const Vec3& origin, const char* problem) const {
        const Vec3 normal = x.cross(y);
        const double area = normal.length();
        if (!(area > 1e-9 * x.length() * y.length()) || !std::isfinite(area) ||
            !std::isfinite(origin.length())) {
            refuse(name, problem);
        }
        const Vec3 n = normal / area;
        return Mat44(x.x, x.y, x.z, 0, y.x, y.y, y.z, 0, n.x, n.y, n.z, 0, origin.x, origin.y,
                     origin.z, 1);
    }
};

bool equal_scales(const Vec3& scale) {
    const double largest = std::max({scale.x, scale.y, scale.z});
    const double smallest = std::min({scale.x, scale.y, scale.z});
    return largest - smallest <= kRoundness * largest;
}

/// Whether the map keeps the axes perpendicular.
bool has_right_angles(const Mat44& m) {
    const auto row = [&](int i) { return Vec3(m[i][0], m[i][1], m[i][2]).normalized(); };
    return std::abs(row(0).dot(row(1))) <= kRoundness &&
           std::abs(row(0).dot(row(2))) <= kRoundness && std::abs(row(1).dot(row(2))) <= kRoundness;
}

/// Whether the map neither rotates, mirrors nor shears.
bool is_upright(const Mat44& m) {
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            if (row == column ? m[row][column] <= 0 : m[row][column] != 0) {
                return false;
            }
        }
    }
    return true;
}

/// Largest distance of the mapped unit shape's surface from the image of its centre. A plane has
/// none, and a mesh is measured.
double bounding_radius_of(const UnitOfObject& unit, const Mat44& world_from_unit) {
    const Vec3 scale = axis_scales(world_from_unit);
    const bool is_straight = has_right_angles(world_from_unit);
    return visit_shape(unit.kind, 1.0, [&](auto shape) {
        using Shape = decltype(shape);
        if (is_straight) {
            return Shape::bounding_radius(scale, unit.parameters);
        }
        // Every shape lies within its box or, if that is larger, the unit cube.
        const V3f half = Shape::half_size(unit.parameters);
        return std::max(half.x, 1.f) * scale.x + std::max(half.y, 1.f) * scale.y +
               std::max(half.z, 1.f) * scale.z;
    });
}

double length_of_translation(const Mat44& m) {
    return Vec3(m[3][0], m[3][1], m[3][2]).length();
}

}  // namespace

UnitFrame frame_of(const Mat44& world_from_unit) {
    return {Affine::narrowed(world_from_unit.inverse()), Affine::narrowed(world_from_unit)};
}

SceneObject make_object(const ObjectDescription& description, std::uint32_t material,
                        bool has_texture, MeshLibrary& meshes) {
    SceneObject object;
    object.name = description.name;
    object.track = description.track;
    object.material = material;
    object.has_texture = has_texture;
    const Mat44 world_from_object = checked_transform(description);
    const UnitOfObject unit = std::visit(MakeUnit{description.name}, description.shape);
    const Mat44 world_from_unit = unit.object_from_unit * world_from_object;
    object.kind = unit.kind;
    object.parameters = unit.parameters;
    const double offset = object.is_tracked() ? length_of_translation(world_from_unit) : 0;
    const Vec3 scale = axis_scales(world_from_object);
    object.half_size = V3f(axis_scales(world_from_unit));
    object.is_round = object.kind == ShapeKind::sphere && equal_scales(scale) && offset == 0 &&
                      has_right_angles(world_from_object);
    object.is_upright_box = object.kind == ShapeKind::box && is_upright(world_from_object);
    object.bounding_radius = static_cast<float>(offset + bounding_radius_of(unit, world_from_unit));
    object.frame = frame_of(world_from_unit);
    object.metres_from_world = Affine::narrowed(world_from_object.inverse() * scaling(scale));
    if (object.kind == ShapeKind::mesh) {
        meshes.give(object, description);
    }
    return object;
}

std::optional<SceneObject> make_light_object(const LightDescription& description,
                                             std::uint32_t light) {
    const std::optional<AreaLight> surface = area_light_of(description);
    if (!surface) {
        return std::nullopt;
    }
    const UnitOfObject unit{surface->constants.kind, {}, surface->constants.parameters};
    SceneObject object;
    object.name = description.name;
    object.light = light;
    object.kind = unit.kind;
    object.parameters = unit.parameters;
    object.is_round = object.kind == ShapeKind::sphere;
    object.is_one_sided = surface->constants.is_one_sided;
    object.half_size = V3f(axis_scales(surface->world_from_unit));
    object.bounding_radius = static_cast<float>(bounding_radius_of(unit, surface->world_from_unit));
    object.frame = frame_of(surface->world_from_unit);
    return object;
}

UnitFrame placed(const UnitFrame& in_body, const V3f& position,
                 const Imath::Quatf& world_from_body) {
    UnitFrame frame;
    const Imath::M33f turn = world_from_body.toMatrix33();
    frame.world_from_unit.linear = in_body.world_from_unit.linear * turn;
    frame.world_from_unit.translation = in_body.world_from_unit.translation * turn + position;
    frame.unit_from_world.linear = turn.transposed() * in_body.unit_from_world.linear;
    frame.unit_from_world.translation =
        in_body.unit_from_world.translation - frame.unit_from_world.vector(position);
    return frame;
}

}  // namespace carom::render
