#include "lab/comparison/growth_rays.h"

#include <cmath>
#include <cstdint>

#include "core/splitmix.h"
#include "lab/comparison/scene_parts.h"

namespace carom::pipeline {

namespace {

using render::Hit;
using render::Ray;
using render::RayKind;
using render::V3f;

class Numbers {
  public:
    explicit Numbers(std::uint64_t seed) : random_(seed) {}

    /// In [0, 1).
    double next() { return random_.next_unit(); }
    /// Uniform over all directions.
    V3f direction() {
        const double z = 2 * next() - 1;
        const double turn = 6.283185307179586 * next();
        const double across = std::sqrt(1 - z * z);
        return V3f(Vec3(across * std::cos(turn), across * std::sin(turn), z)).normalized();
    }

  private:
    SplitMix64 random_;
};

constexpr double kShutter = 1.0 / 48;  // s

/// Along one line until the middle of the shutter, then along another.
sim::Track bouncing_track(const std::string& name, const Vec3& place, const Vec3& before,
                          const Vec3& after) {
    sim::Key first;
    first.position = place;
    first.velocity_in = first.velocity_out = before;
    sim::Key impact = first;
    impact.time = 0.5 * kShutter;
    impact.position = place + before * impact.time;
    impact.velocity_out = after;
    sim::Key last = impact;
    last.time = kShutter;
    last.position = impact.position + after * (last.time - impact.time);
    last.velocity_in = last.velocity_out = after;
    return {name, {first, impact, last}};
}

/// Along lines of random directions and lengths, for a second.
sim::Track restless_track(const std::string& name, const Vec3& place, Numbers& numbers) {
    const auto velocity = [&] { return Vec3(numbers.direction()) * (2 * numbers.next()); };
    std::vector<sim::Key> keys;
    sim::Key key;
    key.position = place;
    key.velocity_in = key.velocity_out = velocity();
    keys.push_back(key);
    while (key.time < 1) {
        const double leg = std::min(0.05 + 0.1 * numbers.next(), 1 - key.time);
        key.time = leg > 0.999 - key.time ? 1 : key.time + leg;
        key.position += key.velocity_out * (key.time - keys.back().time);
        key.velocity_in = key.velocity_out;
        key.velocity_out = velocity();
        keys.push_back(key);
    }
    keys.back().velocity_out = keys.back().velocity_in;
    return {name, std::move(keys)};
}

/// Lets the object follow a track that begins where it is.
void set_track(LaboratoryScene& scene, render::ObjectDescription& object, sim::Track track) {
    scene.tracks.push_back(std::move(track));
    object.track = object.name;
    object.world_from_object = Mat44();
}

constexpr float kStep = 1e-4f;  // offset from a hit, m

/// Towards squares across the cloud; neighbours follow each other, as in the tiles of a picture.
std::vector<Ray> camera_rays(std::size_t count) {
    constexpr int kTile = 8;
    const int side =
        kTile *
        std::max(1, static_cast<int>(std::lround(std::sqrt(static_cast<double>(count)))) / kTile);
    std::vector<Ray> rays;
    for (int tile = 0; tile < side / kTile * (side / kTile); ++tile) {
        for (int i = 0; i < kTile * kTile; ++i) {
            const int x = tile % (side / kTile) * kTile + i % kTile;
            const int y = tile / (side / kTile) * kTile + i / kTile;
            Ray ray;
            ray.origin = V3f(2.2f, -3.2f, 2.0f);
            const V3f forward = (-ray.origin).normalized();
            const V3f right = forward.cross(V3f(0, 0, 1)).normalized();
            const V3f up = right.cross(forward);
            const auto at = [&](int place) {
                return 0.72f *
                       ((static_cast<float>(place) + 0.5f) / static_cast<float>(side) - 0.5f);
            };
            ray.direction = (forward + right * at(x) + up * at(y)).normalized();
            ray.kind = RayKind::primary;
            rays.push_back(ray);
        }
    }
    return rays;
}

}  // namespace

LaboratoryScene sphere_cloud(std::size_t shapes) {
    LaboratoryScene scene = empty_scene("spheres", {});
    add_surface(scene, "grey", {0.6, 0.6, 0.6});
    Numbers numbers(shapes);
    const double radius = 0.6 / std::cbrt(static_cast<double>(shapes));
    for (std::size_t i = 0; i < shapes; ++i) {
        const Vec3 place(2 * numbers.next() - 1, 2 * numbers.next() - 1, 2 * numbers.next() - 1);
        add_object(scene, render::SphereShape{radius}, moved_to(place), "grey");
    }
    return scene;
}

LaboratoryScene ball_cloud(std::size_t balls) {
    LaboratoryScene scene = sphere_cloud(balls);
    scene.frame.scene_close = kShutter;
    const double spacing = 2 / std::cbrt(static_cast<double>(balls));
    Numbers numbers(~balls);
    // At most three quarters of the mean distance between balls during the shutter.
    const auto velocity = [&] {
        return Vec3(numbers.direction()) * (0.75 * spacing / kShutter * numbers.next());
    };
    for (std::size_t i = 1; i < balls; i += 2) {
        render::ObjectDescription& ball = scene.scene.objects[i];
        const Vec3 before = velocity();
        set_track(
            scene, ball,
            bouncing_track(ball.name, ball.world_from_object.translation(), before, velocity()));
    }
    return scene;
}

LaboratoryScene restless_balls(std::size_t balls) {
    LaboratoryScene scene = sphere_cloud(balls);
    Numbers numbers(~balls);
    for (std::size_t i = 1; i < balls; i += 2) {
        render::ObjectDescription& ball = scene.scene.objects[i];
        set_track(scene, ball,
                  restless_track(ball.name, ball.world_from_object.translation(), numbers));
    }
    return scene;
}

LaboratoryScene single_knot(std::size_t shapes) {
    LaboratoryScene scene = empty_scene("mesh", {});
    add_surface(scene, "grey", {0.6, 0.6, 0.6});
    add_object(scene, knot_mesh(shapes, 1), moved_to({0, 0, 0}), "grey");
    return scene;
}

RaysByKind growth_rays(const render::AccelerationStructure& structure, std::size_t count) {
    RaysByKind rays;
    rays[0] = camera_rays(count);
    const V3f light(1.5f, -1, 4);
    Numbers numbers(1);
    Numbers times(2);
    for (Ray& ray : rays[0]) {
        ray.time = static_cast<float>(times.next());
        Hit hit;
        if (!structure.closest_hit(ray, hit)) {
            continue;
        }
        Ray secondary;
        secondary.origin = ray.origin + ray.direction * (hit.t - kStep);
        secondary.direction = numbers.direction();
        if (secondary.direction.dot(ray.direction) > 0) {
            secondary.direction = -secondary.direction;
        }
        secondary.time = ray.time;
        secondary.kind = RayKind::secondary;
        rays[1].push_back(secondary);
        Ray shadow = secondary;
        const V3f to_light = light - secondary.origin;
        shadow.t_max = to_light.length();
        shadow.direction = to_light.normalized();
        shadow.kind = RayKind::shadow;
        rays[2].push_back(shadow);
    }
    return rays;
}

RaysByKind thinned(const RaysByKind& rays, std::size_t every) {
    RaysByKind some;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        for (std::size_t k = 0; k < rays[i].size(); k += every) {
            some[i].push_back(rays[i][k]);
        }
    }
    return some;
}

RayArrays::RayArrays(std::span<const Ray> rays) : count_(static_cast<int>(rays.size())) {
    for (std::size_t i = 0; i < rays.size(); ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            numbers_[axis][i] = rays[i].origin[static_cast<int>(axis)];
            numbers_[3 + axis][i] = rays[i].direction[static_cast<int>(axis)];
        }
        numbers_[6][i] = rays[i].time;
        numbers_[7][i] = rays[i].t_max;
    }
}

render::RayBatch RayArrays::batch() const {
    return {count_,
            {numbers_[0].data(), numbers_[1].data(), numbers_[2].data()},
            {numbers_[3].data(), numbers_[4].data(), numbers_[5].data()},
            numbers_[6].data()};
}

}  // namespace carom::pipeline
