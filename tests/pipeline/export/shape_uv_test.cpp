// The uv of exported meshes against those of the renderer.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/export/shape_mesh.h"
#include "tests/render/frame_scene/scene_helpers.h"

namespace carom::pipeline {
namespace {

using render::MeshShape;

/// Of a coordinate that may run around: 0.99 and 0.01 are 0.02 apart.
double apart(double a, double b, bool is_round) {
    const double difference = std::abs(a - b);
    return is_round ? std::abs(difference - std::round(difference)) : difference;
}

struct Case {
    const char* name;
    render::Shape shape;
    bool is_round;     // u is a longitude on it, except on flat ends
    double tolerance;  // round shapes are polygons
};

/// Looks from outside at a point of each triangle that is close to a corner.
void expect_uv_of_renderer(const Case& given) {
    const MeshShape mesh = shape_mesh(given.shape);
    test::SceneBuilder builder;
    builder.add(given.shape, Mat44());
    const test::BuiltScene scene(builder);
    ASSERT_EQ(mesh.uv.size(), mesh.vertices.size()) << given.name;
    for (const auto& t : mesh.triangles) {
        const Vec3 normal = (mesh.vertices[t[1]] - mesh.vertices[t[0]])
                                .cross(mesh.vertices[t[2]] - mesh.vertices[t[0]])
                                .normalized();
        for (std::size_t k = 0; k < 3; ++k) {
            Vec3 place(0, 0, 0);
            Vec2 uv(0, 0);
            for (std::size_t i = 0; i < 3; ++i) {
                const double weight = i == k ? 0.94 : 0.03;
                place += weight * mesh.vertices[t[i]];
                uv += weight * mesh.uv[t[i]];
            }
            const render::Ray ray = test::ray_from(place + 0.01 * normal, place - 0.01 * normal);
            render::Hit hit;
            ASSERT_TRUE(scene.frame.structure().closest_hit(ray, hit)) << given.name << place;
            const render::SurfacePoint point = scene.frame.surface_at(ray, hit);
            const bool is_flat = std::abs(normal.z) > 0.9999;
            ASSERT_LT(apart(uv.x, static_cast<double>(point.uv.x), given.is_round && !is_flat),
                      given.tolerance)
                << given.name << place << uv << point.uv;
            ASSERT_LT(apart(uv.y, static_cast<double>(point.uv.y), false), given.tolerance)
                << given.name << place << uv << point.uv;
        }
    }
}

TEST(ShapeUv, AllShapes_HaveThoseOfTheRenderer) {
    const std::vector<Case> cases{
        {"box", render::BoxShape{{1, 2, 3}}, false, 1e-5},
        {"rectangle", render::RectangleShape{{1, 2}}, false, 1e-5},
        {"plane", render::PlaneShape{}, false, 1e-4},
        {"triangle", render::TriangleShape{{Vec3(0, 0, 1), Vec3(2, 0, 1), Vec3(0, 3, 1)}}, false,
         1e-5},
        {"parallelogram", render::ParallelogramShape{{1, 0, 0}, {1, 1, 0}, {0, 1, 1}}, false, 1e-5},
        {"disk", render::DiskShape{0.7}, false, 1e-5},
        {"cylinder", render::CylinderShape{0.5, 2}, true, 1e-3},
        {"cone", render::ConeShape{1, 0.5, 1.5}, true, 1e-3},
        {"narrow cone", render::ConeShape{0.25, 1, 1.5}, true, 2e-3},
        {"rounded box", render::RoundedBoxShape{{1, 2, 3}, 0.25}, false, 5e-3},
        // At the poles a longitude changes quickly.
        {"sphere", render::SphereShape{0.5}, true, 6e-3},
        {"capsule", render::CapsuleShape{0.5, 2}, true, 6e-3},
    };
    for (const Case& one : cases) {
        expect_uv_of_renderer(one);
    }
}

TEST(ShapeUv, Seams_RunOnToOne) {
    for (const render::Shape& shape :
         std::vector<render::Shape>{render::SphereShape{1}, render::CapsuleShape{1, 1}}) {
        const MeshShape mesh = shape_mesh(shape);
        for (const auto& t : mesh.triangles) {
            const Vec2 a = mesh.uv[t[0]];
            for (const std::uint32_t corner : {t[1], t[2]}) {
                ASSERT_LT(std::abs(mesh.uv[corner].x - a.x), 0.9) << shape.index();
            }
        }
        double most = 0;
        for (const Vec2& uv : mesh.uv) {
            most = std::max(most, uv.x);
        }
        EXPECT_NEAR(most, 1, 1e-12) << shape.index();
    }
}

}  // namespace
}  // namespace carom::pipeline
