// Objects with equal meshes: one mesh and one tree for all, and the hits and surfaces of copies.
#include <cstdio>
#include <fstream>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "render/frame_scene/flat_faces.h"
#include "render/frame_scene/scene_object.h"
#include "tests/render/frame_scene/mesh_copies.h"
#include "tests/render/frame_scene/scene_helpers.h"

namespace carom::test {
namespace {

constexpr int kObjects = 24;
constexpr int kRings = 40;  // 3200 triangles, so that copies of all would be many

const HybridStructure& structure_of(const BuiltScene& scene) {
    return dynamic_cast<const HybridStructure&>(scene.frame.structure());
}

/// Stretched, mirrored and turned copies, of which every third one moves.
SceneBuilder copies_of_a_mesh() {
    SceneBuilder builder;
    TestRandom random(3);
    for (int i = 0; i < kObjects; ++i) {
        Mat44 map = random_affine(random);
        if (i % 3 == 0) {
            map[3][0] = map[3][1] = map[3][2] = 0.05;
            const Vec3 place = random_vector(random, 3);
            const sim::Key open = key_at(0, place, Vec3(0.3, 0.1, 0), Vec3(0, 0.4, 0.2));
            sim::Key close = open;
            close.time = 1;
            close.position += Vec3(0.3, 0.1, 0);
            builder.tracks.emplace_back("track" + std::to_string(i), std::vector{open, close});
            builder.add(bumpy_mesh(kRings, 0.6), map, "track" + std::to_string(i));
        } else {
            builder.add(bumpy_mesh(kRings, 0.6), map);
        }
    }
    return builder;
}

std::set<const TriangleMesh*> meshes_of(const BuiltScene& scene) {
    std::set<const TriangleMesh*> meshes;
    for (std::uint32_t i = 0; i < scene.geometry.object_count(); ++i) {
        meshes.insert(scene.geometry.object(i).mesh.get());
    }
    return meshes;
}

TEST(MeshInstances, EqualMeshes_AreOneInMemory) {
    SceneBuilder one;
    one.add(bumpy_mesh(kRings, 0.6), Mat44());
    const std::size_t bytes_of_one = structure_of(BuiltScene(one)).bytes();
    const BuiltScene all(copies_of_a_mesh(), 0, 1);
    EXPECT_EQ(meshes_of(all).size(), 1u);
    EXPECT_LT(structure_of(all).bytes(), bytes_of_one * 11 / 10);
    const BuiltScene copied(copies_of_a_mesh(), 0, 1, copying_maker());
    EXPECT_EQ(meshes_of(copied).size(), static_cast<std::size_t>(kObjects));
    EXPECT_GT(structure_of(copied).bytes(), bytes_of_one * (kObjects - 1));
}

TEST(MeshInstances, EqualContentOfSeveralFiles_IsOneMesh) {
    const auto path = [](int i) {
        return testing::TempDir() + "carom_equal_mesh_" + std::to_string(i) + ".obj";
    };
    SceneBuilder builder;
    const MeshShape mesh = bumpy_mesh(kRings, 1);
    for (int i = 0; i < kObjects; ++i) {
        std::ofstream file(path(i));
        file << "# file " << i << "\n";
        for (const Vec3& v : mesh.vertices) {
            file << "v " << v.x << " " << v.y << " " << v.z << "\n";
        }
        for (const auto& [a, b, c] : mesh.triangles) {
            file << "f " << a + 1 << " " << b + 1 << " " << c + 1 << "\n";
        }
        MeshShape shape;
        shape.file = path(i);
        builder.add(shape, placed(Vec3(3 * i, 0, 0), Quat(), Vec3(1 + 0.1 * i)));
    }
    const BuiltScene scene(builder);
    EXPECT_EQ(meshes_of(scene).size(), 1u);
    for (int i = 0; i < kObjects; ++i) {
        std::remove(path(i).c_str());
    }
}

TEST(MeshInstances, FewTriangles_AreMappedToTheWorld) {
    SceneBuilder builder;
    for (int i = 0; i < kObjects; ++i) {
        builder.add(cube_mesh(), placed(Vec3(3 * i, 0, 0)));
    }
    EXPECT_FALSE(BuiltScene(builder).geometry.object(1).mesh_is_mapped);
}

// Smoothing decides by angles, which stretching changes.
TEST(MeshInstances, SmoothedMeshes_AreSharedIfEquallyStretched) {
    SceneBuilder builder;
    TestRandom random(8);
    MeshShape mesh = bumpy_mesh(kRings, 1);
    mesh.smooth_angle = 1.2;
    for (int i = 0; i < 2 * kObjects; ++i) {
        const Vec3 scale = i % 2 == 0 ? Vec3(1, 1, 2.5) : Vec3(1 + 0.1 * i);
        const Quat turn = turn_about(random_vector(random), 0.1 * i);
        builder.add(mesh, placed(random_vector(random, 5), turn, scale));
    }
    const BuiltScene scene(builder);
    EXPECT_EQ(meshes_of(scene).size(), 2u);
    const BuiltScene copied(builder, 0, 0, copying_maker());
    int unlike = 0;
    for (int i = 0; i < 5'000; ++i) {
        const Ray ray = ray_from(random_vector(random, 9), random_vector(random, 5));
        Hit hit;
        Hit expected;
        if (scene.frame.structure().closest_hit(ray, hit) &&
            copied.frame.structure().closest_hit(ray, expected)) {
            const V3f normal = scene.frame.surface_at(ray, hit).shading_normal;
            const V3f other = copied.frame.surface_at(ray, expected).shading_normal;
            unlike += (normal - other).length() < 1e-3f ? 0 : 1;
        }
    }
    EXPECT_LE(unlike, 5);
}

TEST(MeshInstances, HitsAndSurfaces_ThoseOfCopies) {
    const SceneBuilder builder = copies_of_a_mesh();
    const BuiltScene shared(builder, 0, 1);
    const BuiltScene copied(builder, 0, 1, copying_maker());
    TestRandom random(4);
    int hits = 0;
    int unlike = 0;
    for (int i = 0; i < 50'000; ++i) {
        const Ray ray = ray_from(random_vector(random, 6), random_vector(random, 3), random.unit());
        Hit hit;
        Hit expected;
        const bool found = shared.frame.structure().closest_hit(ray, hit);
        EXPECT_EQ(shared.frame.structure().any_hit(ray), found);
        const bool also = copied.frame.structure().closest_hit(ray, expected);
        if (found != also || hit.object != expected.object || hit.primitive != expected.primitive) {
            ++unlike;
            continue;
        }
        if (!found) {
            continue;
        }
        ++hits;
        ASSERT_NEAR(hit.t, expected.t, 1e-4f);
        const SurfacePoint point = shared.frame.surface_at(ray, hit);
        const SurfacePoint other = copied.frame.surface_at(ray, expected);
        ASSERT_LT((point.position - other.position).length(), 5e-4f);
        ASSERT_LT((point.geometric_normal - other.geometric_normal).length(), 2e-3f);
        ASSERT_LT((point.shading_normal - other.shading_normal).length(), 5e-3f);
        ASSERT_LT((point.object_position - other.object_position).length(), 3e-4f);
        ASSERT_LT((point.uv - other.uv).length(), 1e-3f);
        for (const auto& [gradient, of_copy] : {std::pair(point.u_gradient, other.u_gradient),
                                                std::pair(point.v_gradient, other.v_gradient)}) {
            ASSERT_NEAR((gradient - of_copy).length(), 0, 1e-3f * of_copy.length());
        }
        ASSERT_NEAR(point.offset, other.offset, 1e-4f * other.offset);
        ASSERT_EQ(point.object, other.object);
    }
    EXPECT_GT(hits, 20'000);
    EXPECT_LE(unlike, 20);  // rays along edges
}

TEST(MeshInstances, FacesThatEmit_ThoseOfCopies) {
    const SceneBuilder builder = copies_of_a_mesh();
    const BuiltScene shared(builder, 0, 1);
    const BuiltScene copied(builder, 0, 1, copying_maker());
    for (std::uint32_t object = 0; object < kObjects; ++object) {
        const auto faces = flat_faces(shared.geometry, object);
        const auto expected = flat_faces(copied.geometry, object);
        ASSERT_EQ(faces.size(), expected.size());
        for (std::size_t i = 0; i < faces.size(); ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                ASSERT_LT((faces[i][k] - expected[i][k]).length(), 1e-5f);
            }
        }
    }
}

}  // namespace
}  // namespace carom::test
