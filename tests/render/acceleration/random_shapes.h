// Random rays and shapes for tests of acceleration structures.
#pragma once

#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <vector>

#include "render/acceleration/moving_shape.h"
#include "render/acceleration/shapes.h"
#include "render/acceleration/triangle_scene.h"
#include "render/acceleration/triangle_tree.h"
#include "tests/render/pose_matrix.h"
#include "tests/render/statistics.h"

namespace carom::test {

using render::Affine;
using render::Ray;
using render::V2f;
using render::V3f;

inline V3f random_point(TestRandom& random, float size) {
    const float x = random.between(-size, size);
    const float y = random.between(-size, size);
    const float z = random.between(-size, size);
    return V3f(x, y, z);
}

inline V3f random_direction(TestRandom& random) {
    for (;;) {
        const V3f v = random_point(random, 1);
        if (v.length2() > 0.01f && v.length2() <= 1) {
            return v * (1 / std::sqrt(v.dot(v)));
        }
    }
}

inline Ray random_ray(TestRandom& random, float size) {
    Ray ray;
    ray.origin = random_point(random, size);
    ray.direction = random_direction(random);
    ray.time = random.unit();
    return ray;
}

/// From a random point of `from` towards a random point of `to`.
inline Ray random_ray_toward(TestRandom& random, float from, float to) {
    Ray ray = random_ray(random, from);
    const V3f v = random_point(random, to) - ray.origin;
    ray.direction = v * (1 / std::sqrt(v.dot(v)));
    return ray;
}

inline Quat random_turn(TestRandom& random) {
    const V3f axis = random_direction(random);
    const double half = static_cast<double>(random.between(0, 3));
    return Quat(std::cos(half), std::sin(half) * Vec3(axis)).normalized();
}

/// A random map from world space to the unit shape of the given half sizes.
inline Affine random_map(TestRandom& random, const V3f& half_size, float size) {
    const Quat turn = random_turn(random);
    Mat44 scale;
    scale.setScale(Vec3(half_size));
    const Mat44 world_from_unit =
        scale * render::pose_matrix({Vec3(random_point(random, size)), turn});
    return Affine::narrowed(world_from_unit.inverse());
}

/// A cylinder, a cone or a frustum, either way up.
inline V3f random_parameters(TestRandom& random) {
    const float other = std::max(0.f, random.between(-0.5f, 1.5f));
    const float top = random.next() % 2 == 0 ? 1 : std::min(other, 1.f);
    const float bottom = top == 1 ? std::min(other, 1.f) : 1;
    return V3f(0.5f * (top + bottom), 0.5f * (top - bottom), 0);
}

/// The core of a rounded box, half sizes; flat or zero along some axes.
inline V3f random_core(TestRandom& random) {
    const V3f core = random_point(random, 2);
    return V3f(std::max(core.x, 0.f), std::max(core.y, 0.f), std::max(core.z, 0.f));
}

/// A path of three segments with two impacts and fast rotation.
inline sim::Track random_track(TestRandom& random, float size) {
    std::vector<sim::Key> keys;
    Vec3 position(random_point(random, size));
    for (int i = 0; i < 4; ++i) {
        sim::Key key;
        key.time = i / 3.0;
        key.position = position;
        key.velocity_in = Vec3(random_point(random, 0.5f));
        key.velocity_out = Vec3(random_point(random, 0.5f));
        key.angular_velocity_in = Vec3(random_point(random, 3));
        key.angular_velocity_out = Vec3(random_point(random, 3));
        key.orientation = random_turn(random);
        keys.push_back(key);
        position += Vec3(random_point(random, 0.15f));
    }
    return sim::Track("moving", keys);
}

inline void add_moving_sphere(render::ShapeSet& shapes, const render::RigidMotion& motion,
                              float radius, std::uint32_t object) {
    const auto path = motion.path();
    for (std::size_t i = 0; i < path.size(); ++i) {
        render::SphereSegment sphere;
        sphere.path = path[i];
        sphere.start = i == 0 ? -render::kInfinity : path[i].start;
        sphere.end = i + 1 == path.size() ? render::kInfinity : path[i].end;
        sphere.radius = radius;
        sphere.object = object;
        shapes.add_sphere(sphere);
    }
}

template <class Shape>
void add_mapped(render::ShapeSet& shapes, const Affine& unit_from_world, std::uint32_t object,
                const V3f& parameters = V3f(0), bool one_sided = false) {
    const auto [block, lane] = shapes.blocks.of<Shape>().add(object);
    block.set_map(lane, unit_from_world);
    block.set_parameters(lane, parameters);
    block.one_sided.values[lane] = one_sided ? 1.f : 0.f;
}

inline void add_aligned_box(render::ShapeSet& shapes, const V3f& low, const V3f& high,
                            std::uint32_t object) {
    const auto [block, lane] = shapes.blocks.of<render::AlignedBox>().add(object);
    block.set(lane, low, high);
}

/// A closed, bumpy surface around the origin: 2 * rings * (2 * rings) triangles.
inline render::TriangleMesh bumpy_ball(float radius, int rings) {
    render::TriangleMesh mesh;
    const int sectors = 2 * rings;
    for (int r = 0; r <= rings; ++r) {
        for (int s = 0; s < sectors; ++s) {
            const float theta =
                std::numbers::pi_v<float> * static_cast<float>(r) / static_cast<float>(rings);
            const float phi = 6.2831853f * static_cast<float>(s) / static_cast<float>(sectors);
            const float size = radius * (1 + 0.2f * std::sin(5 * theta) * std::cos(4 * phi));
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

/// Some shapes of every kind. Its meshes live as long as the scene.
struct RandomScene {
    render::ShapeSet shapes;
    std::vector<std::unique_ptr<render::TriangleMesh>> meshes;
    std::vector<render::MeshEntry> static_meshes;
    std::shared_ptr<const render::TriangleTree> ball;  // of all instances
    const render::TriangleMesh* ball_mesh = nullptr;
    std::uint32_t object_count = 0;

    void add_static(TestRandom& random, int count) {
        for (int i = 0; i < count; ++i) {
            render::SphereSegment sphere;
            sphere.path.c[0] = random_point(random, 2);
            sphere.radius = random.between(0.05f, 0.3f);
            sphere.object = object_count++;
            shapes.add_sphere(sphere);
            const V3f low = random_point(random, 2);
            const V3f size = random_point(random, 0.2f) + V3f(0.25f);
            add_aligned_box(shapes, low, low + size, object_count++);
            const V3f half = random_point(random, 0.1f) + V3f(0.15f);
            add_mapped<render::UnitBox>(shapes, random_map(random, half, 2), object_count++);
            add_mapped<render::UnitSphere>(shapes, random_map(random, half, 2), object_count++);
            add_mapped<render::UnitRectangle>(shapes, random_map(random, half, 2), object_count++,
                                              V3f(0), i % 2 == 0);
            add_mapped<render::UnitTriangle>(shapes, random_map(random, half, 2), object_count++);
            add_mapped<render::UnitDisk>(shapes, random_map(random, half, 2), object_count++);
            const Affine map = random_map(random, half, 2);
            add_mapped<render::UnitFrustum>(shapes, map, object_count++, random_parameters(random));
            add_mapped<render::UnitCapsule>(shapes, random_map(random, 0.5f * half, 2),
                                            object_count++, V3f(random.between(0.1f, 3), 0, 0));
            add_mapped<render::UnitRoundedBox>(shapes, random_map(random, 0.5f * half, 2),
                                               object_count++, random_core(random));
        }
        add_mapped<render::UnitPlane>(shapes, random_map(random, V3f(1), 0.2f), object_count++);
    }

    void add_moving(TestRandom& random, int count) {
        using Kind = render::ShapeKind;
        for (int i = 0; i < count; ++i) {
            const render::RigidMotion motion(random_track(random, 2), 0, 1);
            add_moving_sphere(shapes, motion, random.between(0.05f, 0.3f), object_count++);
            std::shared_ptr<render::RigidMotion> own;
            for (const Kind kind :
                 {Kind::sphere, Kind::box, Kind::rectangle, Kind::triangle, Kind::disk,
                  Kind::frustum, Kind::capsule, Kind::rounded_box, Kind::mesh}) {
                render::MovingShape shape;
                shape.kind = kind;
                const V3f half_size = random_point(random, 0.1f) + V3f(0.15f);
                Mat44 unit_from_body;
                unit_from_body.setScale(Vec3(1) / Vec3(half_size));
                shape.unit_from_body = Affine::narrowed(unit_from_body);
                if (kind == Kind::frustum) {
                    shape.parameters = random_parameters(random);
                }
                if (kind == Kind::capsule) {
                    shape.parameters = V3f(random.between(0.1f, 3), 0, 0);
                }
                if (kind == Kind::rounded_box) {
                    shape.parameters = random_core(random);
                }
                // The frustum, the capsule and the rounded box are of one body.
                if (kind != Kind::capsule && kind != Kind::rounded_box) {
                    own = std::make_shared<render::RigidMotion>(random_track(random, 2), 0, 1);
                }
                shape.motion = own;
                // A capsule's only measure is half the length of its axis, which is z.
                const V3f core =
                    kind == Kind::capsule ? V3f(0, 0, shape.parameters.x) : shape.parameters;
                const float bounding_radius = half_size.length() + (half_size * core).length();
                if (kind == Kind::mesh) {
                    add_instance({}, own);
                    continue;
                }
                shape.bounds = render::swept_bounds(*shape.motion, bounding_radius);
                shape.object = object_count++;
                shapes.moving.push_back(shape);
            }
        }
    }

    /// A ball of which there is one tree for all. `mesh_from_body`: none, or from axes of its own.
    void add_instance(const std::optional<Mat44>& body_from_mesh,
                      const std::shared_ptr<const render::RigidMotion>& motion) {
        if (!ball) {
            meshes.push_back(std::make_unique<render::TriangleMesh>(bumpy_ball(0.2f, 6)));
            const render::MeshEntry entry{meshes.back().get(), 0};
            ball = std::make_shared<const render::TriangleTree>(
                render::make_triangle_tree(std::span(&entry, 1)));
            ball_mesh = meshes.back().get();
        }
        render::MeshInstance instance{ball, {}, motion, {}, object_count++};
        const Affine map = Affine::narrowed(body_from_mesh.value_or(Mat44()));
        if (body_from_mesh) {
            instance.mesh_from_body = Affine::narrowed(body_from_mesh->inverse());
        }
        float radius = 0;
        for (const V3f& vertex : ball_mesh->vertices) {
            instance.bounds.extendBy(map.point(vertex));
            radius = std::max(radius, map.point(vertex).length());
        }
        if (motion) {
            instance.bounds = render::swept_bounds(*motion, radius);
        }
        shapes.instances.push_back(instance);
    }

    /// Copies of a ball, at rest and in motion.
    void add_instances(TestRandom& random, int count) {
        for (int i = 0; i < count; ++i) {
            Mat44 stretch;
            stretch.setScale(Vec3(random_point(random, 0.5f) + V3f(1)));
            stretch[0][1] = static_cast<double>(random.between(-0.3f, 0.3f));
            const bool moves = i % 2 != 0;
            const Vec3 place(random_point(random, moves ? 0.1f : 2));
            add_instance(
                stretch * render::pose_matrix({place, random_turn(random)}),
                moves ? std::make_shared<const render::RigidMotion>(random_track(random, 2), 0, 1)
                      : nullptr);
        }
    }

    void add_static_meshes(TestRandom& random, int count) {
        for (int i = 0; i < count; ++i) {
            meshes.push_back(std::make_unique<render::TriangleMesh>(bumpy_ball(0.3f, 10)));
            const V3f place = random_point(random, 2);
            for (V3f& vertex : meshes.back()->vertices) {
                vertex += place;
            }
            static_meshes.push_back({meshes.back().get(), object_count++});
        }
        shapes.meshes = std::make_shared<render::TriangleScene>(static_meshes);
    }
};

}  // namespace carom::test
