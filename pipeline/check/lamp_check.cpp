#include "pipeline/check/lamp_check.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>
#include <variant>

#include "pipeline/camera/view_axes.h"
#include "pipeline/check/shape_box.h"
#include "pipeline/check/whole_mesh.h"
#include "pipeline/shot/material_textures.h"

namespace carom::pipeline {

namespace {

constexpr int kColumns = 9;  // of points on the cloth
constexpr int kRows = 5;
constexpr double kLowest = 0.3;  // m above the cloth; lower things stand on the table
constexpr std::uintmax_t kLargestMesh = 4U << 20U;  // bytes

/// A straight way from a camera to a point.
struct Way {
    Vec3 from;
    Vec3 along;  // to the point
};

/// The fraction of the way at which it enters the box; nothing if it misses it or starts in it.
std::optional<double> entry(const Way& way, const Imath::Box3d& box) {
    double enter = 0;
    double leave = 1;
    for (int axis = 0; axis < 3; ++axis) {
        double a = (box.min[axis] - way.from[axis]) / way.along[axis];
        double b = (box.max[axis] - way.from[axis]) / way.along[axis];
        if (way.along[axis] == 0) {
            const bool is_between =
                box.min[axis] <= way.from[axis] && way.from[axis] <= box.max[axis];
            a = is_between ? 0 : 2;
            b = is_between ? 1 : -1;
        }
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave && enter > 0 ? std::optional(enter) : std::nullopt;
}

/// The fraction of the way at which it meets a triangle (Moeller and Trumbore, "Fast, Minimum
/// Storage Ray/Triangle Intersection", Journal of Graphics Tools 2(1), 1997, section 2).
std::optional<double> meeting(const Way& way, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 normal = way.along.cross(c - a);
    const double determinant = normal.dot(b - a);
    if (determinant == 0) {
        return std::nullopt;
    }
    const Vec3 from = way.from - a;
    const double u = normal.dot(from) / determinant;
    const Vec3 other = from.cross(b - a);
    const double v = other.dot(way.along) / determinant;
    const double t = other.dot(c - a) / determinant;
    return u >= 0 && v >= 0 && u + v <= 1 && t > 0 && t < 1 ? std::optional(t) : std::nullopt;
}

/// Whether a light's surface is in the way.
struct LightInWay {
    const Way& way;

    bool operator()(const render::SphereLight& light) const {
        const Vec3 from = way.from - light.centre;
        const double nearest =
            std::clamp(-from.dot(way.along) / way.along.dot(way.along), 0.0, 1.0);
        return from.length() > light.radius && (from + nearest * way.along).length() < light.radius;
    }
    bool operator()(const render::RectangleLight& light) const {
        const std::optional<Vec3> hit = crossing(light.centre, light.normal);
        return hit && std::abs(hit->dot(light.edge_u)) < light.edge_u.length2() &&
               std::abs(hit->dot(light.edge_v)) < light.edge_v.length2();
    }
    bool operator()(const render::DiskLight& light) const {
        const std::optional<Vec3> hit = crossing(light.centre, light.normal);
        return hit && hit->length() < light.radius;
    }
    bool operator()(const render::ShadeLight& light) const {
        const std::optional<Vec3> hit = crossing(light.centre, light.normal);
        return hit && hit->length() < light.shape.radius;
    }
    /// Where the way crosses a plane from its front, from `centre` on; from behind a light cannot
    /// be seen.
    [[nodiscard]] std::optional<Vec3> crossing(const Vec3& centre, const Vec3& normal) const {
        const double height = normal.dot(way.from - centre);
        const double fraction = -height / normal.dot(way.along);
        if (!(height > 0) || !(fraction > 0 && fraction < 1)) {
            return std::nullopt;
        }
        return way.from + fraction * way.along - centre;
    }
    template <class Other>
    bool operator()(const Other& /*without a surface*/) const {
        return false;
    }
};

std::vector<Vec3> corners_of(const render::MeshShape& mesh) {
    std::vector<Vec3> corners;
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) {
            corners.push_back(mesh.vertices[vertex]);
        }
    }
    return corners;
}

}  // namespace

LampCheck::LampCheck(const Shot& shot) : shot_(shot) {}

bool LampCheck::is_above_table(const render::CameraState& camera) const {
    constexpr double kSine = 0.70710678;
    const Vec3 ahead = (camera.target - camera.position).normalized();
    return shot_.world.table && camera.position.z > 0 && ahead.z < -kSine;
}

void LampCheck::find_fixtures() {
    std::set<std::string> bodies;
    for (const sim::Body& body : shot_.world.bodies) {
        bodies.insert(body.name);
    }
    WholeMeshes meshes(kLargestMesh);
    for (const render::ObjectDescription& object : shot_.scene.objects) {
        const auto has_holes = [&](const render::MaterialDescription& material) {
            return material.name == object.material && is_cut_out(material);
        };
        const bool is_fixture = object.track.empty() && !object.name.starts_with("table/") &&
                                bodies.count(object.name) == 0 &&
                                std::ranges::none_of(shot_.scene.materials, has_holes);
        if (!is_fixture) {
            continue;
        }
        Fixture fixture{object.name, object.world_from_object.inverse(), {}, {}};
        if (const auto* mesh = std::get_if<render::MeshShape>(&object.shape)) {
            const auto whole = meshes.find(*mesh);
            if (!whole) {
                continue;
            }
            fixture.corners = corners_of(whole->mesh);
            for (const Vec3& corner : fixture.corners) {
                fixture.box.extendBy(corner);
            }
        } else if (const auto box = box_of(object.shape)) {
            fixture.box = *box;
        } else {
            continue;
        }
        fixtures_.push_back(std::move(fixture));
    }
}

bool LampCheck::is_hidden_by(const Fixture& fixture, const Vec3& camera, const Vec3& point) const {
    const Vec3 from = camera * fixture.object_from_world;
    const Way way{from, point * fixture.object_from_world - from};
    const auto is_high = [&](const std::optional<double>& fraction) {
        return fraction && camera.z + *fraction * (point.z - camera.z) > kLowest;
    };
    if (fixture.corners.empty()) {
        return is_high(entry(way, fixture.box));
    }
    if (!entry(way, fixture.box) && !fixture.box.intersects(from)) {
        return false;
    }
    for (std::size_t i = 0; i + 2 < fixture.corners.size(); i += 3) {
        if (is_high(
                meeting(way, fixture.corners[i], fixture.corners[i + 1], fixture.corners[i + 2]))) {
            return true;
        }
    }
    return false;
}

std::map<std::string, double> LampCheck::hidden_shares(const render::CameraState& camera) {
    if (!std::exchange(has_fixtures_, true)) {
        find_fixtures();
    }
    const sim::billiards::TableMeasures& table = *shot_.world.table;
    const double aspect = static_cast<double>(shot_.render.width) / shot_.render.height;
    std::map<std::string, double> hidden;
    double seen = 0;
    for (int i = 0; i < kColumns * kRows; ++i) {
        const int row = i / kColumns;
        const int column = i % kColumns;
        const Vec3 point(table.length * ((column + 0.5) / kColumns - 0.5),
                         table.width * ((row + 0.5) / kRows - 0.5), 0);
        if (!is_in_picture(camera, aspect, point, 0)) {
            continue;
        }
        ++seen;
        const Way way{camera.position, point - camera.position};
        for (const render::LightDescription& light : shot_.scene.lights) {
            if (std::visit(LightInWay{way}, light.light)) {
                ++hidden[light.name];
            }
        }
        for (const Fixture& fixture : fixtures_) {
            if (is_hidden_by(fixture, camera.position, point)) {
                ++hidden[fixture.name];
            }
        }
    }
    for (auto& [name, share] : hidden) {
        share /= seen;
    }
    return hidden;
}

}  // namespace carom::pipeline
