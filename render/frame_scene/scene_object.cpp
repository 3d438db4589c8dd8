#include "render/frame_scene/scene_object.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/geometry/obj_file.h"
#include "sim/timeline/error.h"

namespace carom::render {
namespace {

constexpr double kRoundness = 1e-6;  // relative difference of a ball's scales

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

/// Half sizes of the shape before any scaling.
struct HalfSizeOf {
    const std::string& name;

    Vec3 operator()(const SphereShape& shape) const {
        check_size(shape.radius, name, "the radius");
        return Vec3(shape.radius);
    }
    Vec3 operator()(const BoxShape& shape) const {
        for (int axis = 0; axis < 3; ++axis) {
            check_size(shape.size[axis], name, "a box's edge");
        }
        return 0.5 * shape.size;
    }
    Vec3 operator()(const PlaneShape&) const { return Vec3(1); }
    Vec3 operator()(const RectangleShape& shape) const {
        check_size(shape.size.x, name, "a rectangle's edge");
        check_size(shape.size.y, name, "a rectangle's edge");
        return Vec3(0.5 * shape.size.x, 0.5 * shape.size.y, 1);
    }
    Vec3 operator()(const MeshShape&) const { return Vec3(1); }
};

struct KindOf {
    ShapeKind operator()(const SphereShape&) const { return ShapeKind::ball; }
    ShapeKind operator()(const BoxShape&) const { return ShapeKind::box; }
    ShapeKind operator()(const PlaneShape&) const { return ShapeKind::plane; }
    ShapeKind operator()(const RectangleShape&) const { return ShapeKind::rectangle; }
    ShapeKind operator()(const MeshShape&) const { return ShapeKind::mesh; }
};

bool equal_scales(const Vec3& scale) {
    const double largest = std::max({scale.x, scale.y, scale.z});
    const double smallest = std::min({scale.x, scale.y, scale.z});
    return largest - smallest <= kRoundness * largest;
}

/// Whether the map's axes are at right angles.
bool has_right_angles(const Mat44& m) {
    const auto row = [&](int i) { return Vec3(m[i][0], m[i][1], m[i][2]).normalized(); };
    return std::abs(row(0).dot(row(1))) <= kRoundness &&
           std::abs(row(0).dot(row(2))) <= kRoundness && std::abs(row(1).dot(row(2))) <= kRoundness;
}

/// Neither turned, mirrored nor sheared.
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

float reach_of(ShapeKind kind, const V3f& half_size) {
    switch (kind) {
        case ShapeKind::ball:
            return std::max({half_size.x, half_size.y, half_size.z});
        case ShapeKind::box:
            return half_size.length();
        case ShapeKind::rectangle:
            return V2f(half_size.x, half_size.y).length();
        default:
            return 1;  // a plane has none, a mesh is measured
    }
}

const MeshShape& loaded(const MeshShape& shape, MeshFiles& files) {
    if (shape.file.empty()) {
        return shape;
    }
    const auto known = files.find(shape.file);
    return known != files.end() ? known->second
                                : files.emplace(shape.file, read_obj(shape.file)).first->second;
}

void set_mesh(SceneObject& object, const MeshShape& shape, const Mat44& map, MeshFiles& files) {
    object.mesh = std::make_shared<TriangleMesh>(make_mesh(loaded(shape, files), map, object.name));
    object.reach = 0;
    for (const V3f& vertex : object.mesh->vertices) {
        object.reach = std::max(object.reach, vertex.length());
    }
}

UnitFrame frame_of(const Mat44& world_from_unit) {
    return {Affine::narrowed(world_from_unit.inverse()), Affine::narrowed(world_from_unit)};
}

}  // namespace

SceneObject make_object(const ObjectDescription& description, std::uint32_t material,
                        bool has_texture, MeshFiles& files) {
    SceneObject object;
    object.name = description.name;
    object.track = description.track;
    object.material = material;
    object.has_texture = has_texture;
    object.kind = std::visit(KindOf{}, description.shape);
    const Mat44 world_from_object = checked_transform(description);
    const Vec3 scale = axis_scales(world_from_object);
    const Vec3 half_size = std::visit(HalfSizeOf{description.name}, description.shape);
    object.half_size = V3f(half_size * scale);
    object.is_round = object.kind == ShapeKind::ball && equal_scales(scale) &&
                      (object.is_tracked() || has_right_angles(world_from_object));
    object.is_upright_box = object.kind == ShapeKind::box && is_upright(world_from_object);
    object.reach = reach_of(object.kind, object.half_size);
    object.frame = frame_of(scaling(half_size) * world_from_object);
    object.body_from_world = Affine::narrowed(world_from_object.inverse() * scaling(scale));
    if (object.kind == ShapeKind::plane) {
        object.half_size = V3f(1);
        object.frame = frame_of(world_from_object);
    }
    if (const auto* mesh = std::get_if<MeshShape>(&description.shape)) {
        set_mesh(object, *mesh, object.is_tracked() ? scaling(scale) : world_from_object, files);
    }
    return object;
}

std::optional<SceneObject> make_light_object(const LightDescription& description,
                                             std::uint32_t light) {
    SceneObject object;
    object.name = description.name;
    object.light = light;
    if (const auto* sphere = std::get_if<SphereLight>(&description.light)) {
        check_size(sphere->radius, object.name, "a sphere light's radius");
        Mat44 place;
        place.setTranslation(sphere->centre);
        object.kind = ShapeKind::ball;
        object.is_round = true;
        object.half_size = V3f(static_cast<float>(sphere->radius));
        object.reach = object.half_size.x;
        object.frame = frame_of(scaling(Vec3(sphere->radius)) * place);
        return object;
    }
    if (const auto* rectangle = std::get_if<RectangleLight>(&description.light)) {
        const Vec3& u = rectangle->edge_u;
        const Vec3& v = rectangle->edge_v;
        const Vec3& n = rectangle->normal;
        check_size(u.length(), object.name, "a rectangle light's edge");
        check_size(v.length(), object.name, "a rectangle light's edge");
        const double skew =
            std::max({std::abs(u.normalized().dot(v.normalized())), std::abs(u.normalized().dot(n)),
                      std::abs(v.normalized().dot(n)), std::abs(n.length() - 1)});
        if (!(skew < 1e-6)) {
            refuse(object.name,
                   "the edges and the unit normal of a rectangle light must be at "
                   "right angles");
        }
        const Vec3& c = rectangle->centre;
        const Mat44 world_from_unit(u.x, u.y, u.z, 0, v.x, v.y, v.z, 0, n.x, n.y, n.z, 0, c.x, c.y,
                                    c.z, 1);
        object.kind = ShapeKind::rectangle;
        object.is_one_sided = true;
        object.half_size = V3f(static_cast<float>(u.length()), static_cast<float>(v.length()), 1);
        object.reach = reach_of(object.kind, object.half_size);
        object.frame = frame_of(world_from_unit);
        return object;
    }
    return std::nullopt;
}

UnitFrame unit_frame(const V3f& half_size, const V3f& position,
                     const Imath::Quatf& world_from_body) {
    UnitFrame frame;
    const Imath::M33f turn = world_from_body.toMatrix33();
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            frame.world_from_unit.linear[i][j] = half_size[i] * turn[i][j];
            frame.unit_from_world.linear[j][i] = turn[i][j] / half_size[i];
        }
    }
    frame.world_from_unit.translation = position;
    frame.unit_from_world.translation = -frame.unit_from_world.vector(position);
    return frame;
}

}  // namespace carom::render
