#include "lab/comparison/scene_parts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

#include <fmt/core.h>

namespace carom::pipeline {

namespace {

/// The (2, 3) knot on a torus of radii 2 and 1; t in [0, 2 pi).
Vec3 knot_point(double t) {
    const double across = 2 + std::cos(3 * t);
    return {across * std::cos(2 * t), across * std::sin(2 * t), std::sin(3 * t)};
}

}  // namespace

LaboratoryScene empty_scene(const std::string& name, const PictureSize& size) {
    LaboratoryScene scene;
    scene.name = name;
    render::RenderSettings& settings = scene.settings;
    settings.width = size.width;
    settings.height = size.height;
    settings.integrator = render::IntegratorKind::distributed;
    settings.filter = render::PixelFilter::box;
    settings.filter_width = 1;
    render::DistributedSettings& counts = settings.distributed;
    counts.pixel_samples = size.samples;
    counts.blur_samples = counts.lens_samples = 1;
    counts.shadow_samples = counts.reflection_samples = counts.refraction_samples = 1;
    counts.recursion_limit = size.depth;
    scene.frame.seed = 1;
    return scene;
}

void add_surface(LaboratoryScene& scene, const std::string& name, const Vec3& colour,
                 double reflectance) {
    render::PhongMaterial surface;
    surface.diffuse = colour;
    surface.specular = Vec3(0.3, 0.3, 0.3);
    surface.reflectance = Vec3(reflectance, reflectance, reflectance);
    scene.scene.materials.push_back({name, {}, std::move(surface)});
}

void add_object(LaboratoryScene& scene, render::Shape shape, const Mat44& place,
                const std::string& surface) {
    const std::string name = fmt::format("shape {}", scene.scene.objects.size());
    scene.scene.objects.push_back({name, std::move(shape), place, "", surface});
}

void add_point_light(LaboratoryScene& scene, const Vec3& place, double intensity) {
    render::PointLight light;
    light.position = place;
    light.intensity = Vec3(intensity, intensity, intensity);
    scene.scene.lights.push_back({fmt::format("light {}", scene.scene.lights.size()), light});
}

void set_camera(LaboratoryScene& scene, const Vec3& place, const Vec3& target, double fov) {
    render::CameraState camera;
    camera.position = place;
    camera.target = target;
    camera.vertical_fov = fov;
    camera.focus_distance = (target - place).length();
    scene.frame.camera_open = scene.frame.camera_close = camera;
}

Mat44 moved_to(const Vec3& place) {
    Mat44 map;
    map.setTranslation(place);
    return map;
}

Mat44 turned_to(const Vec3& axis, const Vec3& place) {
    const Vec3 z = axis.normalized();
    const Vec3 x = (std::abs(z.x) < 0.9 ? Vec3(1, 0, 0) : Vec3(0, 1, 0)).cross(z).normalized();
    const Vec3 y = z.cross(x);
    return {x.x, x.y, x.z, 0, y.x, y.y, y.z, 0, z.x, z.y, z.z, 0, place.x, place.y, place.z, 1};
}

render::MeshShape knot_mesh(std::size_t triangles, double radius) {
    constexpr double kTube = 0.45;
    constexpr double kOuterRadius = 3 + kTube;
    // The triangles are about as long as wide.
    const auto around = std::max<std::size_t>(
        3, static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(triangles) / 24))));
    const std::size_t along = std::max<std::size_t>(3, triangles / (2 * around));
    render::MeshShape mesh;
    for (std::size_t i = 0; i < along; ++i) {
        const double t = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(along);
        const Vec3 forward = (knot_point(t + 1e-4) - knot_point(t - 1e-4)).normalized();
        const Vec3 side = forward.cross(Vec3(0, 0, 1)).normalized();
        const Vec3 up = side.cross(forward);
        for (std::size_t k = 0; k < around; ++k) {
            const double turn =
                2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(around);
            const Vec3 point =
                knot_point(t) + (side * std::cos(turn) + up * std::sin(turn)) * kTube;
            mesh.vertices.push_back(point * (radius / kOuterRadius));
        }
    }
    for (std::size_t i = 0; i < along; ++i) {
        for (std::size_t k = 0; k < around; ++k) {
            const auto at = [&](std::size_t ring, std::size_t place) {
                return static_cast<std::uint32_t>(ring % along * around + place % around);
            };
            mesh.triangles.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
            mesh.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
        }
    }
    return mesh;
}

}  // namespace carom::pipeline
