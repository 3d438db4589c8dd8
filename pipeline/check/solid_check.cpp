#include "pipeline/check/solid_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <ranges>
#include <tuple>
#include <variant>

#include "pipeline/check/shape_box.h"
#include "pipeline/shot/material_textures.h"
#include "pipeline/shot/table_scene.h"
#include "render/geometry/affine.h"
#include "render/scene/scene_problems.h"

namespace carom::pipeline {
namespace {

constexpr double kSmallestRoom = 3;                     // m
constexpr double kLargestRoom = 40;                     // m
constexpr std::uintmax_t kLargestMesh = 16U << 20U;     // bytes
constexpr std::size_t kMaxTriangles = 400'000;          // of a mesh that is looked at
constexpr std::size_t kMaxTriangleTests = 100'000'000;  // of a shot; about half a second

/// Whether a point in the axes of a shape lies in it. Flat shapes and open ones contain none.
struct Contains {
    const Vec3& p;

    [[nodiscard]] bool in_box(const Vec3& half) const {
        return std::abs(p.x) < half.x && std::abs(p.y) < half.y && std::abs(p.z) < half.z;
    }
    [[nodiscard]] double from_axis() const { return Vec2(p.x, p.y).length(); }

    bool operator()(const render::SphereShape& s) const { return p.length() < s.radius; }
    bool operator()(const render::BoxShape& s) const { return in_box(0.5 * s.size); }
    bool operator()(const render::CylinderShape& s) const {
        return from_axis() < s.radius && std::abs(p.z) < s.height / 2;
    }
    bool operator()(const render::ConeShape& s) const {
        const double up = p.z / s.height + 0.5;
        return up > 0 && up < 1 && from_axis() < s.radius + up * (s.top_radius - s.radius);
    }
    bool operator()(const render::CapsuleShape& s) const {
        const double beyond = std::max(0.0, std::abs(p.z) - s.length / 2);
        return Vec2(from_axis(), beyond).length() < s.radius;
    }
    bool operator()(const render::RoundedBoxShape& s) const {
        const Vec3 core = s.core();
        Vec3 beyond;
        for (int axis = 0; axis < 3; ++axis) {
            beyond[axis] = std::max(0.0, std::abs(p[axis]) - core[axis]);
        }
        return beyond.length() < s.radius;
    }
    template <class Other>
    bool operator()(const Other& /*flat, or a mesh*/) const {
        return false;
    }
};

bool has_inside(const render::Shape& shape) {
    return std::holds_alternative<render::SphereShape>(shape) ||
           std::holds_alternative<render::BoxShape>(shape) ||
           std::holds_alternative<render::CylinderShape>(shape) ||
           std::holds_alternative<render::ConeShape>(shape) ||
           std::holds_alternative<render::CapsuleShape>(shape) ||
           std::holds_alternative<render::RoundedBoxShape>(shape) ||
           std::holds_alternative<render::MeshShape>(shape);
}

/// Whether an even number of triangles meets at each edge, whatever their fronts.
bool is_closed(const render::MeshShape& mesh) {
    using Place = std::tuple<double, double, double>;
    std::map<Place, std::uint32_t> numbers;
    std::vector<std::uint32_t> place(mesh.vertices.size());
    for (std::size_t i = 0; i < place.size(); ++i) {
        const Vec3& v = mesh.vertices[i];
        place[i] = numbers.try_emplace({v.x, v.y, v.z}, static_cast<std::uint32_t>(numbers.size()))
                       .first->second;
    }
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const auto& triangle : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [a, b] = std::minmax(place[triangle[k]], place[triangle[(k + 1) % 3]]);
            if (a != b) {
                edges.emplace_back(a, b);
            }
        }
    }
    std::ranges::sort(edges);
    for (std::size_t first = 0, end = 0; first < edges.size(); first = end) {
        while (end < edges.size() && edges[end] == edges[first]) {
            ++end;
        }
        if ((end - first) % 2 != 0) {
            return false;
        }
    }
    return true;
}

/// Whether a ray from a point crosses a closed surface an odd number of times.
bool is_enclosed(const render::MeshShape& mesh, const Vec3& point, const Vec3& direction) {
    bool is_odd = false;
    for (const auto& [ia, ib, ic] : mesh.triangles) {
        const Vec3 a = mesh.vertices[ia] - point;
        const Vec3 b = mesh.vertices[ib] - point;
        const Vec3 c = mesh.vertices[ic] - point;
        const double u = direction.dot(a.cross(b));
        const double v = direction.dot(b.cross(c));
        const double w = direction.dot(c.cross(a));
        const bool is_front = u > 0 && v > 0 && w > 0;
        const bool is_back = u < 0 && v < 0 && w < 0;
        if ((is_front || is_back) && a.dot(b.cross(c)) * (is_front ? 1 : -1) > 0) {
            is_odd = !is_odd;
        }
    }
    return is_odd;
}

/// Whether a camera may be meant to look out of an object, because it shines or is cut out.
bool shows_its_inside(const Shot& shot, const std::string& material) {
    return std::ranges::any_of(shot.scene.materials, [&](const auto& m) {
        return m.name == material && (is_cut_out(m) || render::is_emissive(m));
    });
}

/// What balls meet of a table that is drawn. What is drawn of it is not made of closed surfaces.
std::vector<render::ObjectDescription> solids_of_table(const Shot& shot) {
    if (!shot.world.table || !shot.draws_table) {
        return {};
    }
    // As the simulation does: of the first ball.
    double radius = sim::Sphere{}.radius;
    for (const sim::Body& body : shot.world.bodies | std::views::reverse) {
        const auto* sphere = std::get_if<sim::Sphere>(&body.shape);
        if (sphere != nullptr && body.material == "ball") {
            radius = sphere->radius;
        }
    }
    render::SceneDescription scene;
    add_table(scene, *shot.world.table, build_table(*shot.world.table, radius).surfaces);
    return scene.objects;
}

}  // namespace

bool is_room(const Shot& shot, const render::ObjectDescription& object, const Imath::Box3d& box) {
    const Vec3 size = box.size() * render::axis_scales(object.world_from_object);
    const double longest = std::max({size.x, size.y, size.z});
    if (!object.track.empty() || longest <= kSmallestRoom || longest > kLargestRoom) {
        return false;
    }
    const Mat44 object_from_world = object.world_from_object.inverse();
    const auto contains = [&](const Vec3& point) {
        return box.intersects(point * object_from_world);
    };
    if (shot.world.table) {
        const Vec3 corner(shot.world.table->length / 2, shot.world.table->width / 2, 0);
        if (!contains(corner) || !contains(-corner)) {
            return false;
        }
    }
    const bool has_content = shot.world.table.has_value() || !shot.world.bodies.empty();
    return has_content && std::ranges::all_of(shot.world.bodies, [&](const sim::Body& body) {
               return body.name == object.name || contains(body.pose.position);
           });
}

SolidCheck::SolidCheck(const Shot& shot, const sim::Timeline& timeline)
    : shot_(shot), table_(solids_of_table(shot)), meshes_(kLargestMesh), work_(kMaxTriangleTests) {
    for (const render::ObjectDescription& object : table_) {
        add(object, timeline);
    }
    for (const render::ObjectDescription& object : shot.scene.objects) {
        add(object, timeline);
    }
}

void SolidCheck::add(const render::ObjectDescription& object, const sim::Timeline& timeline) {
    if (!has_inside(object.shape) || shows_its_inside(shot_, object.material)) {
        return;
    }
    Solid solid;
    solid.object = &object;
    solid.track = object.track.empty() ? nullptr : timeline.find(object.track);
    if (!object.track.empty() && solid.track == nullptr) {
        return;
    }
    solid.object_from_world = object.world_from_object.inverse();
    solid.box = box_of(object.shape);
    if (!solid.box || !is_room(shot_, object, *solid.box)) {
        solids_.push_back(std::move(solid));
    }
}

void SolidCheck::read_mesh(Solid& solid) {
    solid.is_known_mesh = true;
    const auto& shape = std::get<render::MeshShape>(solid.object->shape);
    auto reading = meshes_.find(shape);
    if (!reading || reading->mesh.triangles.size() > kMaxTriangles) {
        return;
    }
    solid.box.emplace();
    for (const Vec3& vertex : reading->mesh.vertices) {
        solid.box->extendBy(vertex);
    }
    if (!is_room(shot_, *solid.object, *solid.box) && is_closed_mesh(shape, reading->mesh)) {
        solid.mesh = std::move(reading);
    }
}

bool SolidCheck::is_closed_mesh(const render::MeshShape& shape, const render::MeshShape& whole) {
    if (shape.file.empty()) {
        return is_closed(whole);
    }
    const auto [place, is_new] = closed_files_.try_emplace(shape.file);
    if (is_new) {
        place->second = is_closed(whole);
    }
    return place->second;
}

bool SolidCheck::is_inside(Solid& solid, const Vec3& point) {
    if (!std::holds_alternative<render::MeshShape>(solid.object->shape)) {
        return std::visit(Contains{point}, solid.object->shape);
    }
    if (solid.box && !solid.box->intersects(point)) {
        return false;
    }
    if (!solid.is_known_mesh) {
        read_mesh(solid);
    }
    if (!solid.mesh || !solid.box->intersects(point)) {
        return false;
    }
    // Three directions, because one of them may hit an edge.
    static constexpr std::array<std::array<double, 3>, 3> kDirections{
        {{0.5381, 0.3172, 0.7809}, {-0.6127, 0.7013, -0.3643}, {0.1879, -0.8123, 0.5521}}};
    int inside = 0;
    for (const auto& [x, y, z] : kDirections) {
        const std::size_t tests = solid.mesh->mesh.triangles.size();
        if (tests > work_) {
            return false;
        }
        work_ -= tests;
        inside += is_enclosed(solid.mesh->mesh, point, Vec3(x, y, z)) ? 1 : 0;
    }
    return inside >= 2;
}

std::vector<std::string> SolidCheck::find_around(const Vec3& point, double scene_time) {
    std::vector<std::string> names;
    for (Solid& solid : solids_) {
        Vec3 local = point;
        if (solid.track != nullptr) {
            const MotionState state = solid.track->sample(scene_time);
            local = state.orientation.inverse().rotateVector(point - state.position);
        }
        if (is_inside(solid, local * solid.object_from_world)) {
            names.push_back(solid.object->name);
        }
    }
    return names;
}

}  // namespace carom::pipeline
