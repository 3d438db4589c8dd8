#include "bench/growth_scenes.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include <fmt/core.h>

#include "tests/render/statistics.h"

namespace carom::bench {

namespace {

using namespace render;

constexpr double kRoom = 2;  // edge of the cloud, m
constexpr double kShutter = 1.0 / 48;
Vec3 random_place(test::TestRandom& random, double half) {
    const auto along = [&] {
        return static_cast<double>(
            random.between(static_cast<float>(-half), static_cast<float>(half)));
    };
    const double x = along();
    const double y = along();
    return Vec3(x, y, along());
}

GrowthScene make_room() {
    GrowthScene scene;
    scene.builder.diffuse("floor", 0.5).diffuse("grey", 0.7);
    scene.builder.object("ground", PlaneShape{}, Vec3(0, 0, -1.1), "floor");
    scene.builder.lamp(Vec3(0, 0, 3), 1, 1, 8).environment(0.3);
    scene.frame = test::still_frame(test::camera(Vec3(0, -4.5, 1.2), Vec3(0, 0, 0), 0.6));
    scene.frame.scene_close = kShutter;
    return scene;
}

/// Along one line until the middle of the shutter, then along another.
sim::Track bouncing_track(const std::string& name, const Vec3& place, const Vec3& before,
                          const Vec3& after) {
    sim::Key first;
    first.position = place;
    first.velocity_in = first.velocity_out = before;
    sim::Key impact = first;
    impact.time = 0.5 * kShutter;
    impact.position = place + impact.time * before;
    impact.velocity_out = after;
    sim::Key last = impact;
    last.time = kShutter;
    last.position = impact.position + (last.time - impact.time) * after;
    last.velocity_in = last.velocity_out = after;
    return sim::Track(name, {first, impact, last});
}

}  // namespace

GrowthScene make_ball_cloud(int count) {
    GrowthScene scene = make_room();
    test::TestRandom random(1);
    const double spacing = kRoom / std::cbrt(static_cast<double>(count));
    const double radius = 0.3 * spacing;
    for (int i = 0; i < count; ++i) {
        const std::string name = fmt::format("ball {}", i);
        const Vec3 place = random_place(random, 0.5 * kRoom);
        if (i % 2 == 0) {
            scene.builder.sphere(name, radius, place, "grey");
            continue;
        }
        // Up to three quarters of a spacing while the shutter is open.
        const double speed = spacing / kShutter;
        const Vec3 before = random_place(random, 0.75 * speed);
        const Vec3 after = random_place(random, 0.75 * speed);
        scene.tracks.push_back(bouncing_track(name, place, before, after));
        scene.builder.sphere(name, radius, place, "grey", name);
    }
    return scene;
}

render::MeshShape bumpy_ball(int count, double radius) {
    const int rings = static_cast<int>(std::ceil(std::sqrt(count / 4.0)));
    const int sectors = 2 * rings;
    MeshShape mesh;
    for (int r = 0; r <= rings; ++r) {
        for (int s = 0; s < sectors; ++s) {
            const double theta = std::numbers::pi * r / rings;
            const double phi = 2 * std::numbers::pi * s / sectors;
            const double bumps = std::sin(9 * theta) * std::cos(7 * phi) +
                                 0.3 * std::sin(61 * theta) * std::cos(53 * phi);
            const double size = radius * (1 + 0.12 * bumps);
            mesh.vertices.emplace_back(size * std::sin(theta) * std::cos(phi),
                                       size * std::sin(theta) * std::sin(phi),
                                       size * std::cos(theta));
        }
    }
    for (int r = 0; r < rings; ++r) {
        for (int s = 0; s < sectors; ++s) {
            const auto at = [&](int ring, int sector) {
                return static_cast<std::uint32_t>(ring * sectors + sector % sectors);
            };
            mesh.triangles.push_back({at(r, s), at(r + 1, s), at(r + 1, s + 1)});
            mesh.triangles.push_back({at(r, s), at(r + 1, s + 1), at(r, s + 1)});
        }
    }
    return mesh;
}

GrowthScene make_mesh(int count) {
    GrowthScene scene = make_room();
    scene.builder.object("knot", bumpy_ball(count, 0.85), Vec3(0, 0, 0), "grey");
    scene.builder.sphere("ball", 0.2, Vec3(1, -1, -0.9), "grey");
    return scene;
}

std::vector<Ray> make_rays(int count) {
    test::TestRandom random(2);
    std::vector<Ray> rays;
    const int columns = static_cast<int>(std::sqrt(count / 2.0));
    for (int i = 0; static_cast<int>(rays.size()) < count; ++i) {
        const double x = -1.2 + 2.4 * (i % columns) / columns;
        const double z = -1.2 + 2.4 * (i / columns % columns) / columns;
        Ray ray;
        ray.origin = V3f(0, -4.5f, 1.2f);
        ray.direction = (V3f(Vec3(x, 0, z)) - ray.origin).normalized();
        ray.time = random.unit();
        rays.push_back(ray);
        ray.origin = V3f(random_place(random, 0.5 * kRoom));
        ray.direction = V3f(random_place(random, 1)).normalized();
        ray.time = random.unit();
        rays.push_back(ray);
    }
    return rays;
}

}  // namespace carom::bench
