#include "pipeline/config/build/body_shape.h"

#include <numbers>
#include <utility>
#include <variant>

#include <fmt/core.h>

#include "core/error.h"
#include "pipeline/config/text.h"
#include "pipeline/shot/solid_mesh.h"
#include "render/geometry/mesh_file.h"
#include "sim/shape/mass_properties.h"

namespace carom::pipeline::config {

namespace {

using sim::BodyKind;

std::string shape_name(const render::Shape& shape) {
    return std::visit([](const auto& one) { return std::string(one.kName); }, shape);
}

/// The collision mesh of shapes that can only be static; empty for others.
std::optional<sim::TriangleMesh> static_mesh(const render::Shape& shape) {
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

/// The convex hull of a kinematic shape, in the object's axes; empty after a problem.
std::optional<sim::BodyShape> kinematic_hull(const Named<ObjectSection>& object, Builder& builder) {
    constexpr std::size_t kMaxVertices = 5000;
    const auto refuse = [&](const std::string& sentence) {
        builder.reader.error(object.value.shape_place, sentence);
        return std::nullopt;
    };
    const render::Shape& shape = *object.value.shape;
    std::optional<sim::TriangleMesh> mesh = static_mesh(shape);
    if (const auto* file = std::get_if<render::MeshShape>(&shape)) {
        try {
            mesh = scaled_mesh(file->file, object.value.scale);
        } catch (const Error& failure) {
            return refuse(failure.what());
        }
    }
    if (mesh && mesh->vertices.size() > kMaxVertices) {
        return refuse(fmt::format(
            "the mesh of object '{}' has {} vertices, but a mesh that pushes others may have "
            "at most {}; add a simpler object with the same 'motion' that pushes instead",
            object.name, mesh->vertices.size(), kMaxVertices));
    }
    std::optional<sim::Polyhedron> hull;
    if (mesh) {
        hull = sim::convex_hull(mesh->vertices);
    }
    if (!hull) {
        return refuse("a " + shape_name(shape) + " is flat and cannot push others; give object '" +
                      object.name + "' 'physics: false' or a shape with a thickness");
    }
    return sim::ConvexHull{std::move(hull->vertices)};
}

}  // namespace

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
        return 4.0 / 3.0 * std::numbers::pi * sphere->radius * sphere->radius * sphere->radius;
    }
    if (const auto* box = std::get_if<render::BoxShape>(&shape)) {
        return box->size.x * box->size.y * box->size.z;
    }
    return std::nullopt;
}

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
    if (object.value.physics->kind == BodyKind::kinematic) {
        return kinematic_hull(object, builder);
    }
    if (object.value.physics->kind == BodyKind::dynamic) {
        const bool is_mesh = std::holds_alternative<render::MeshShape>(shape);
        const std::string alternative =
            is_mesh
                ? ", or use a 'box', 'sphere', 'capsule', 'cylinder' or 'hull' (a 'hull' of the "
                  "mesh's outermost vertices moves like the mesh)"
                : "";
        builder.reader.error(object.value.shape_place,
                             "the simulation cannot move a " + shape_name(shape) +
                                 "; give object '" + object.name +
                                 "' 'physics: fixed' or 'physics: false'" + alternative);
        return std::nullopt;
    }
    if (auto mesh = static_mesh(shape)) {
        return std::move(*mesh);
    }
    const auto& mesh = std::get<render::MeshShape>(shape);
    try {
        return scaled_mesh(mesh.file, object.value.scale);
    } catch (const Error& failure) {
        builder.reader.error(object.value.shape_place, failure.what());
        return std::nullopt;
    }
}

}  // namespace carom::pipeline::config
