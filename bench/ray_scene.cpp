#include "bench/ray_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <fmt/core.h>

#include "bench/bumpy_ball.h"
#include "render/camera/thin_lens_camera.h"
#include "render/sampling/sampler.h"
#include "render/sampling/scalar_kernels.h"

namespace carom::bench {
namespace {

using namespace render;
using scalar::One;

constexpr double kBallRadius = 0.028575;
constexpr int kWidth = 640;
constexpr int kHeight = 360;

void add(SceneDescription& scene, const Shape& shape, const Vec3& at, const std::string& track) {
    ObjectDescription object;
    object.name = fmt::format("object{}", scene.objects.size());
    object.shape = shape;
    if (track.empty()) {
        object.world_from_object.setTranslation(at);
    }
    object.track = track;
    object.material = "plain";
    scene.objects.push_back(object);
}

void add_box(SceneDescription& scene, const Vec3& low, const Vec3& high) {
    add(scene, BoxShape{high - low}, 0.5 * (low + high), "");
}

/// Forty boxes: floor, bed, cushions, rails, legs, sights.
void add_table(SceneDescription& scene) {
    add_box(scene, Vec3(-4, -3, -0.9), Vec3(4, 3, -0.8));
    add_box(scene, Vec3(-1.32, -0.685, -0.03), Vec3(1.32, 0.685, 0));
    for (const double side : {-1.0, 1.0}) {
        for (const double end : {-1.0, 1.0}) {
            const double x0 = end < 0 ? -1.21 : 0.06;
            const double y = 0.66 * side;
            add_box(scene, Vec3(x0, y - 0.025, -0.002), Vec3(x0 + 1.15, y + 0.025, 0.0365));
            add_box(scene, Vec3(1.3 * end - 0.08, 0.6 * side - 0.08, -0.8),
                    Vec3(1.3 * end + 0.08, 0.6 * side + 0.08, -0.08));
        }
        add_box(scene, Vec3(1.295 * side - 0.025, -0.575, -0.002),
                Vec3(1.295 * side + 0.025, 0.575, 0.0365));
        add_box(scene, Vec3(-1.45, 0.75 * side - 0.065, -0.08),
                Vec3(1.45, 0.75 * side + 0.065, 0.042));
        add_box(scene, Vec3(1.385 * side - 0.065, -0.684, -0.08),
                Vec3(1.385 * side + 0.065, 0.684, 0.042));
        for (int i = 0; i < 8; ++i) {
            const double x = -1.1 + 0.314 * i;
            add_box(scene, Vec3(x - 0.006, 0.76 * side - 0.006, 0.042),
                    Vec3(x + 0.006, 0.76 * side + 0.006, 0.043));
        }
    }
    for (int i = 0; i < 8; ++i) {
        const double x = i < 4 ? -1.4 : 1.4;
        const double y = -0.45 + 0.3 * (i % 4);
        add_box(scene, Vec3(x - 0.006, y - 0.006, 0.042), Vec3(x + 0.006, y + 0.006, 0.043));
    }
}

sim::Key key(double time, const Vec3& position, const Vec3& before, const Vec3& after) {
    sim::Key k;
    k.time = time;
    k.position = position;
    k.velocity_in = before;
    k.velocity_out = after;
    k.angular_velocity_in = k.angular_velocity_out = Vec3(-before.y, before.x, 0) / kBallRadius;
    return k;
}

void add_balls(TableShot& shot) {
    for (int i = 0; i < 16; ++i) {
        const Vec3 start(-0.5 + 0.16 * (i % 8), i < 8 ? -0.15 : 0.2, kBallRadius);
        const bool moves = i % 2 == 0;
        const double angle = 0.7 * i;
        const Vec3 before = (moves ? 2.5 - 0.1 * i : 0) * Vec3(std::cos(angle), std::sin(angle), 0);
        const Vec3 after = (moves ? 1.0 : 0) * Vec3(std::sin(angle), std::cos(angle), 0);
        const double impact = shot.scene_close * (0.2 + 0.04 * i);
        const Vec3 middle = start + impact * before;
        const Vec3 end = middle + (shot.scene_close - impact) * after;
        const std::string name = fmt::format("ball{}", i);
        shot.tracks.emplace_back(
            name,
            std::vector<sim::Key>{key(0, start, before, before), key(impact, middle, before, after),
                                  key(shot.scene_close, end, after, after)});
        add(shot.scene, SphereShape{kBallRadius}, Vec3(0), name);
    }
}

/// A torus knot (2, 3) of 100 000 triangles.
MeshShape knot() {
    MeshShape mesh;
    const int along = 1000;
    const int around = 50;
    for (int i = 0; i < along; ++i) {
        const double t = 2 * std::numbers::pi * i / along;
        const auto place = [](double s) {
            const double r = 0.2 + 0.08 * std::cos(3 * s);
            return Vec3(r * std::cos(2 * s), r * std::sin(2 * s), 0.08 * std::sin(3 * s));
        };
        const Vec3 centre = place(t);
        const Vec3 forward = (place(t + 1e-4) - centre).normalized();
        const Vec3 side = forward.cross(Vec3(0, 0, 1)).normalized();
        const Vec3 up = side.cross(forward);
        for (int k = 0; k < around; ++k) {
            const double a = 2 * std::numbers::pi * k / around;
            mesh.vertices.push_back(centre + 0.03 * (std::cos(a) * side + std::sin(a) * up));
            const auto at = [&](int x, int y) {
                return static_cast<std::uint32_t>((x % along) * around + y % around);
            };
            mesh.triangles.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
            mesh.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
        }
    }
    return mesh;
}

ThinLensCamera make_camera() {
    CameraState state;
    state.position = Vec3(-0.9, -1.9, 0.9);
    state.target = Vec3(0.1, 0, 0.05);
    state.vertical_fov = 0.6;
    state.focus_distance = 2.1;
    state.lens_radius = 0.01;
    return {state, state, kWidth, kHeight, 0.2, PixelFilter::blackman_harris, 1.5};
}

}  // namespace

TableShot make_table_shot(bool with_knot) {
    TableShot shot;
    shot.scene.materials.push_back({"plain", {}});
    add_table(shot.scene);
    add_balls(shot);
    if (with_knot) {
        add(shot.scene, knot(), Vec3(0.1, 0, 0.5), "");
    }
    return shot;
}

TableShot make_equal_meshes(bool move) {
    TableShot shot;
    shot.scene.materials.push_back({"plain", {}});
    add_box(shot.scene, Vec3(-4, -3, -0.1), Vec3(4, 3, 0));
    const MeshShape ball = bumpy_ball(20'000, 0.07);
    for (int i = 0; i < 200; ++i) {
        const Vec3 place(0.18 * (i % 20) - 1.7, 0.18 * (i / 20) - 0.8, 0.09);
        std::string track;
        if (move) {
            track = fmt::format("track{}", i);
            const Vec3 velocity(std::cos(0.7 * i), std::sin(0.7 * i), 0);
            shot.tracks.emplace_back(
                track,
                std::vector<sim::Key>{key(0, place, velocity, velocity),
                                      key(shot.scene_close, place + shot.scene_close * velocity,
                                          velocity, velocity)});
        }
        add(shot.scene, ball, place, track);
    }
    return shot;
}

RaySets make_ray_sets(const FrameScene& frame) {
    RaySets sets;
    const ThinLensCamera camera = make_camera();
    for (int block = 0; block < (kWidth / 4) * (kHeight / 4); ++block) {
        for (int pixel = 0; pixel < 16; ++pixel) {
            const int x = 4 * (block % (kWidth / 4)) + pixel % 4;
            const int y = 4 * (block / (kWidth / 4)) + pixel / 4;
            SampleStream stream(1, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), 0);
            const Ray ray = camera.ray(x, y, stream.camera_sample());
            sets.primary.push_back(ray);
            Hit hit;
            if (!frame.structure().closest_hit(ray, hit)) {
                continue;
            }
            const SurfacePoint point = frame.surface_at(ray, hit);
            const auto u = stream.next_4d();
            Ray next;
            next.origin = point.position + point.offset * point.geometric_normal;
            next.time = ray.time;
            next.direction = scalar::basis_around<One>(point.geometric_normal)
                                 .to_world(scalar::sample_cosine_hemisphere<One>({u[0], u[1]}));
            sets.secondary.push_back(next);
            const V3f on_lamp(0.1f + 1.2f * (u[2] - 0.5f), 0.4f * (u[3] - 0.5f), 1.3f);
            const V3f to_lamp = on_lamp - next.origin;
            next.t_max = 0.9999f * to_lamp.length();
            next.direction = to_lamp * (1 / std::sqrt(to_lamp.dot(to_lamp)));
            sets.shadow.push_back(next);
        }
    }
    // A fixed shuffle, by a multiplicative hash of the index.
    std::vector<std::uint32_t> order(sets.secondary.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(),
              [](std::uint32_t a, std::uint32_t b) { return a * 2654435761u < b * 2654435761u; });
    for (const std::uint32_t i : order) {
        sets.shuffled.push_back(sets.secondary[i]);
    }
    return sets;
}

}  // namespace carom::bench
