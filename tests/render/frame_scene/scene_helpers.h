// Helpers that make scenes and rays in one line each.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "render/frame_scene/frame_scene.h"
#include "render/frame_scene/static_geometry.h"
#include "render/geometry/affine.h"
#include "tests/render/pose_matrix.h"
#include "tests/render/statistics.h"

namespace carom::test {

using namespace render;

inline Mat44 placed(const Vec3& position, const Quat& turn = Quat(), const Vec3& scale = Vec3(1)) {
    Mat44 m;
    m.setScale(scale);
    return m * pose_matrix({position, turn});
}

inline Quat turn_about(const Vec3& axis, double angle) {
    return Quat(std::cos(angle / 2), std::sin(angle / 2) * axis.normalized());
}

/// Scaled, sheared, rotated, translated, and every other time mirrored.
inline Mat44 random_affine(TestRandom& random) {
    Mat44 m;
    for (;;) {
        for (int row = 0; row < 3; ++row) {
            for (int axis = 0; axis < 3; ++axis) {
                m[row][axis] = static_cast<double>(random.between(-1.5f, 1.5f));
            }
            m[3][row] = static_cast<double>(random.between(-3, 3));
        }
        if (std::abs(m.determinant()) > 0.3) {
            return m;
        }
    }
}

/// Distance of a coordinate from the interval [-half, half].
inline double beyond(double p, double half) {
    return std::max(std::abs(p) - half, 0.0);
}

/// A scene with the materials "plain" (0) and "painted" (1, textured).
struct SceneBuilder {
    SceneDescription scene;
    std::vector<sim::Track> tracks;

    SceneBuilder() {
        scene.materials.resize(2);
        scene.materials[0].name = "plain";
        scene.materials[1].name = "painted";
        scene.materials[1].surface.base = CheckerTexture{};
    }

    std::uint32_t add(const Shape& shape, const Mat44& world_from_object,
                      const std::string& track = {}, const std::string& material = "painted") {
        ObjectDescription object;
        object.name = "object" + std::to_string(scene.objects.size());
        object.shape = shape;
        object.world_from_object = world_from_object;
        object.track = track;
        object.material = material;
        scene.objects.push_back(object);
        return static_cast<std::uint32_t>(scene.objects.size() - 1);
    }

    std::uint32_t add_moving(const Shape& shape, std::vector<sim::Key> keys,
                             const Vec3& scale = Vec3(1)) {
        const std::string name = "track" + std::to_string(tracks.size());
        tracks.emplace_back(name, std::move(keys));
        return add(shape, placed(Vec3(0), Quat(), scale), name);
    }
};

/// A static geometry with its frame.
struct BuiltScene {
    StaticGeometry geometry;
    FrameScene frame;

    BuiltScene(const SceneBuilder& builder, double open = 0, double close = 0,
               const StructureMaker& maker = {})
        : geometry(builder.scene, {}, maker), frame(geometry, builder.tracks, open, close) {}
};

inline Ray ray_from(const Vec3& origin, const Vec3& target, float time = 0) {
    Ray ray;
    ray.origin = V3f(origin);
    const V3f v = V3f(target) - ray.origin;
    ray.direction = v * (1 / std::sqrt(v.dot(v)));
    ray.time = time;
    return ray;
}

inline Vec3 random_vector(TestRandom& random, float size = 1) {
    const float x = random.between(-size, size);
    const float y = random.between(-size, size);
    const float z = random.between(-size, size);
    return Vec3(V3f(x, y, z));
}

inline sim::Key key_at(double time, const Vec3& position, const Vec3& velocity = Vec3(0),
                       const Vec3& angular_velocity = Vec3(0), const Quat& orientation = Quat()) {
    sim::Key key;
    key.time = time;
    key.position = position;
    key.orientation = orientation;
    key.velocity_in = key.velocity_out = velocity;
    key.angular_velocity_in = key.angular_velocity_out = angular_velocity;
    return key;
}

/// The cube of edge 2 as a mesh, corners counter-clockwise from outside.
inline MeshShape cube_mesh() {
    MeshShape mesh;
    for (int i = 0; i < 8; ++i) {
        mesh.vertices.emplace_back((i & 1) ? 1 : -1, (i & 2) ? 1 : -1, (i & 4) ? 1 : -1);
    }
    const std::uint32_t quads[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                       {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    for (const auto& q : quads) {
        mesh.triangles.push_back({q[0], q[1], q[2]});
        mesh.triangles.push_back({q[0], q[2], q[3]});
    }
    return mesh;
}

}  // namespace carom::test
